"""Access rules of the viewer's server: it accepts requests from its own page, addressed to one of its own host names.

A browser lets any page open a websocket to any address; only the `Origin` header identifies the page. A page whose host
name is made to resolve to this machine (DNS rebinding) has the same origin as this server, but its `Host` is not one of
the server's names. Therefore both headers are checked, for pages and for websockets.

A program can send any header, but one that was not written against this server sends no `Origin`: its websocket is
refused, since its messages would reach viser as they are.
"""

import ipaddress
import re
import socket
from collections.abc import Sequence
from typing import Final

from quadruped_env.errors import QuadrupedError

_LOOPBACK_NAMES: Final = frozenset({"localhost", "127.0.0.1", "::1"})
_HOST: Final = re.compile(r"(?:\[(?P<address>[0-9a-f:.]+)\]|(?P<name>[a-z0-9._-]+))(?::(?P<port>[0-9]{1,5}))?")
_HTTP_PORT: Final = 80


class AccessRules:
    """The hosts and origins that a server accepts.

    A loopback server accepts the loopback names. A server that other machines can reach accepts the configured name,
    this machine's name, and numeric addresses, which DNS rebinding cannot fake.

    Args:
        host: the address that the server listens on.
        allowed: further hosts, as browsers address a forwarded port or a proxy: `NAME` or `NAME:PORT`.

    Raises:
        QuadrupedError: if one of the allowed hosts is not of that form.
    """

    def __init__(self, host: str, allowed: Sequence[str] = ()) -> None:
        self._allowed = frozenset(one.lower() for one in allowed)
        for one in self._allowed:
            if not _HOST.fullmatch(one):
                raise QuadrupedError(f"--allow-host: expected NAME or NAME:PORT; found {one!r}")
        host = host.lower()
        address = _address(host)
        self._is_local = host == "localhost" or (address is not None and address.is_loopback)
        machine = socket.gethostname().lower()
        own = {host} if self._is_local else {host, machine, machine.split(".")[0], f"{machine.split('.')[0]}.local"}
        self._names = _LOOPBACK_NAMES | own

    def refusal(self, port: int, hosts: Sequence[str], origins: Sequence[str], websocket: bool = False) -> str | None:
        """Return the reason to refuse a request, or None.

        Args:
            port: the port that received the request.
            hosts: values of its `Host` headers.
            origins: values of its `Origin` headers.
            websocket: True for a websocket, which needs an `Origin`; browsers send none when they load a page.
        """
        host = hosts[0].lower() if len(hosts) == 1 else ""
        if not self._accepts_host(host, port):
            return f"Host is {_shown(hosts)}, which is not a name of this server"
        # A proxy may encrypt the connection to the browser.
        schemes = ("http", "https") if host in self._allowed else ("http",)
        if (origins or websocket) and [origin.lower() for origin in origins] not in [
            [f"{scheme}://{host}"] for scheme in schemes
        ]:
            return f"Origin is {_shown(origins)}: a foreign page"
        return None

    def _accepts_host(self, host: str, port: int) -> bool:
        if host in self._allowed:
            return True
        match = _HOST.fullmatch(host)
        if match is None or int(match["port"] or _HTTP_PORT) != port:
            return False
        name = match["address"] or match["name"]
        address = _address(name)
        if address is not None and (address.is_loopback or not self._is_local):
            return True
        return name in self._names


def page_address(host: str, port: int) -> str:
    """Return the page's URL for a browser on this machine; for a server on all addresses, the loopback address."""
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
    return f"{', '.join(values)!r:.90}" if values else "missing"
