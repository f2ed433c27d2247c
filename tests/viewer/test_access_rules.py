"""Rules for the host names and origins of requests, without a server."""

import socket

import pytest

from quadruped_env import QuadrupedError
from quadruped_env.viewer.access import AccessRules, page_address

EVERYWHERE = "0.0.0.0"  # noqa: S104


@pytest.mark.parametrize(
    ("listening", "host", "origin", "kind"),
    [
        ("127.0.0.1", "127.0.0.1:8080", [], None),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1:8080"], None),
        ("127.0.0.1", "LocalHost:8080", ["http://localhost:8080"], None),
        ("127.0.0.1", "[::1]:8080", ["http://[::1]:8080"], None),
        ("localhost", "127.0.0.1:8080", ["http://127.0.0.1:8080"], None),
        ("127.0.0.1", "127.0.0.1:8080", ["http://localhost:8080"], "Origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1:8081"], "Origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1"], "Origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["https://127.0.0.1:8080"], "Origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["null"], "Origin"),
        ("127.0.0.1", "127.0.0.1:8080", [""], "Origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1:8080", "http://evil.example"], "Origin"),
        ("127.0.0.1", "127.0.0.1:8080", ["http://127.0.0.1:8080.evil.example"], "Origin"),
        ("127.0.0.1", "evil.example:8080", ["http://evil.example:8080"], "Host"),
        ("127.0.0.1", "localhost.evil.example:8080", [], "Host"),
        ("127.0.0.1", "127.0.0.1", [], "Host"),
        ("127.0.0.1", "127.0.0.1:8081", [], "Host"),
        ("127.0.0.1", "192.168.1.2:8080", [], "Host"),
        ("127.0.0.1", "user@127.0.0.1:8080", [], "Host"),
        ("127.0.0.1", "", [], "Host"),
        (EVERYWHERE, "192.168.1.2:8080", ["http://192.168.1.2:8080"], None),
        (EVERYWHERE, f"{socket.gethostname()}:8080", [], None),
        (EVERYWHERE, "evil.example:8080", ["http://evil.example:8080"], "Host"),
        ("::", "[fe80::1]:8080", ["http://[fe80::1]:8080"], None),
        ("robot.lan", "robot.lan:8080", ["http://robot.lan:8080"], None),
        ("robot.lan", "robot.lan:8080", ["http://192.168.1.2:8080"], "Origin"),
        ("robot.lan", "evil.example:8080", [], "Host"),
    ],
)
def test_access_rules_accept_this_servers_names_and_its_own_page(listening, host, origin, kind):
    refusal = AccessRules(listening).refusal(8080, [host], origin)
    assert (refusal and refusal.split()[0]) == kind


def test_access_rules_on_the_port_of_http_accept_hosts_without_one():
    assert AccessRules("127.0.0.1").refusal(80, ["localhost"], ["http://localhost"]) is None


@pytest.mark.parametrize(
    ("host", "origin", "kind"),
    [
        ("localhost:9000", ["http://localhost:9000"], None),
        ("robot.example", ["https://robot.example"], None),
        ("robot.example", ["https://evil.example"], "Origin"),
        ("localhost:9001", [], "Host"),
        ("robot.example:9000", [], "Host"),
        ("127.0.0.1:8080", ["https://127.0.0.1:8080"], "Origin"),
    ],
)
def test_access_rules_accept_allowed_hosts_as_they_are_given(host, origin, kind):
    refusal = AccessRules("127.0.0.1", ["LocalHost:9000", "robot.example"]).refusal(8080, [host], origin)
    assert (refusal and refusal.split()[0]) == kind
    with pytest.raises(QuadrupedError, match="--allow-host: expected NAME or NAME:PORT; found 'http://a'"):
        AccessRules("127.0.0.1", ["http://a"])


@pytest.mark.parametrize("hosts", [[], ["127.0.0.1:8080", "127.0.0.1:8080"]])
def test_access_rules_demand_one_host(hosts):
    assert AccessRules("127.0.0.1").refusal(8080, hosts, []).startswith("Host")


@pytest.mark.parametrize(
    ("host", "address"),
    [
        ("127.0.0.1", "http://127.0.0.1:8080"),
        ("robot.lan", "http://robot.lan:8080"),
        (EVERYWHERE, "http://127.0.0.1:8080"),
        ("::", "http://[::1]:8080"),
        ("fe80::1", "http://[fe80::1]:8080"),
    ],
)
def test_the_page_address_can_be_opened_and_is_accepted(host, address):
    assert page_address(host, 8080) == address
    assert AccessRules(host).refusal(8080, [address.removeprefix("http://")], [address]) is None


def test_a_long_header_is_cut_in_the_log():
    refusal = AccessRules("127.0.0.1").refusal(8080, ["x" * 10_000], [])
    assert len(refusal) < 200
