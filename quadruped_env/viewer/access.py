"""Access rules of the viewer's server: it accepts requests from its own page, addressed to one of its own host names.

A browser lets any page open a websocket to any address; only the `Origin` header identifies the page. A page whose host
name is made to resolve to this machine (DNS rebinding) has the same origin as this server, but its `Host` is not one of
the server's names. Therefore both headers are checked, for pages and for websockets.

A client without an `Origin` header is not a browser page but a program, which could send any header. It is accepted.
"""

import ipaddress
import logging
import re
import socket
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

LOG: Final = logging.getLogger("quadruped_env.viewer")
LOG_PERIOD: Final = 10.0
"""Minimum time between log lines about refusals of the same kind, s."""

_LOOPBACK_NAMES: Final = frozenset({"localhost", "127.0.0.1", "::1"})
_HOST: Final = re.compile(r"(?:\[(?P<address>[0-9a-f:.]+)\]|(?P<name>[a-z0-9._-]+))(?::(?P<port>[0-9]{1,5}))?")
_HTTP_PORT: Final = 80
_SHOWN: Final = 80
"""Maximum number of characters of a header in a log line."""


@dataclass(frozen=True)
class Refusal:
    """A refused request: its kind and the reason."""

    kind: str
    reason: str


class AccessRules:
    """The hosts and origins that a server accepts.

    A loopback server accepts the loopback names. A server that other machines can reach accepts the configured name,
    this machine's name, and numeric addresses, which DNS rebinding cannot fake.

    Args:
        host: the address that the server listens on.
    """

    def __init__(self, host: str) -> None:
        host = host.lower()
        address = _address(host)
        self._is_local = host == "localhost" or (address is not None and address.is_loopback)
        machine = socket.gethostname().lower()
        own = {host} if self._is_local else {host, machine, machine.split(".")[0], f"{machine.split('.')[0]}.local"}
        self._names = _LOOPBACK_NAMES | own

    def refusal(self, port: int, hosts: Sequence[str], origins: Sequence[str]) -> Refusal | None:
        """The reason to refuse a request, or None.

        Args:
            port: the port that received the request.
            hosts: values of its `Host` headers.
            origins: values of its `Origin` headers.
        """
        host = hosts[0].lower() if len(hosts) == 1 else ""
        if not self._accepts_host(host, port):
            return Refusal("host", f"Host is {_shown(hosts)}, which is not a name of this server")
        if origins and [origin.lower() for origin in origins] != [f"http://{host}"]:
            return Refusal("origin", f"Origin is {_shown(origins)}: a foreign page")
        return None

    def _accepts_host(self, host: str, port: int) -> bool:
        match = _HOST.fullmatch(host)
        if match is None or int(match["port"] or _HTTP_PORT) != port:
            return False
        name = match["address"] or match["name"]
        address = _address(name)
        if address is not None and (address.is_loopback or not self._is_local):
            return True
        return name in self._names


class RefusalLog:
    """Logs refusals: the first of a kind at once, then one line per `LOG_PERIOD` with a count."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._next: dict[str, float] = {}
        self._left_out: dict[str, int] = {}

    def add(self, refusal: Refusal, who: str) -> None:
        """Log or count a refusal.

        Args:
            refusal: its kind and reason.
            who: the client's address.
        """
        now = time.monotonic()
        with self._lock:
            if now < self._next.get(refusal.kind, 0.0):
                self._left_out[refusal.kind] = self._left_out.get(refusal.kind, 0) + 1
                return
            self._next[refusal.kind] = now + LOG_PERIOD
            more = self._left_out.pop(refusal.kind, 0)
        count = f" (and {more} more since the last line)" if more else ""
        LOG.warning("viewer: refused %s: %s%s", who, refusal.reason, count)


def page_address(host: str, port: int) -> str:
    """The page's URL for a browser on this machine; for a server on all addresses, the loopback address."""
    address = _address(host)
    if address is not None and address.is_unspecified:
        host = "127.0.0.1" if address.version == 4 else "::1"
    return f"http://[{host}]:{port}" if ":" in host else f"http://{host}:{port}"


def _address(text: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        return ipaddress.ip_address(text)
    except ValueError:
        return None


def _shown(values: Sequence[str]) -> str:
    if not values:
        return "missing"
    text = ", ".join(values)
    return repr(text if len(text) <= _SHOWN else text[:_SHOWN] + "...")
