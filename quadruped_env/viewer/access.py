"""Requests that the viewer's server accepts: those of its own page, asked for by one of its own names.

A browser lets any page open a websocket to any address, and tells the server only whose page it is: the `Origin`. And a
page whose host name is made to resolve to this machine (DNS rebinding) has the same origin as this server, but its
`Host` is a name that the server does not have. So both headers are checked, of pages and of websockets.

A client that sends no `Origin` is no browser's page: a program of this machine, which could send any. It is accepted.
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
"""s between two lines about refusals of the same kind"""

_LOOPBACK_NAMES: Final = frozenset({"localhost", "127.0.0.1", "::1"})
_HOST: Final = re.compile(r"(?:\[(?P<address>[0-9a-f:.]+)\]|(?P<name>[a-z0-9._-]+))(?::(?P<port>[0-9]{1,5}))?")
_HTTP_PORT: Final = 80
_SHOWN: Final = 80
"""Characters of a header that a line of the log shows"""


@dataclass(frozen=True)
class Refusal:
    """A request that is refused: what of, and why."""

    kind: str
    reason: str


class AccessRules:
    """The hosts and origins that a server accepts.

    A server of this machine alone accepts the loopback's names. One that other machines reach accepts the name that it
    was given, this machine's name, and addresses in figures, which no page can make its own host's name.

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
        """Why a request is refused, or None.

        Args:
            port: that the request came to.
            hosts: values of its `Host` headers.
            origins: values of its `Origin` headers.
        """
        host = hosts[0].lower() if len(hosts) == 1 else ""
        if not self._accepts_host(host, port):
            return Refusal("host", f"Host is {_shown(hosts)}, which is no name of this server")
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
    """Logs what is refused: the first of a kind at once, and then a line every `LOG_PERIOD` with a count."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._next: dict[str, float] = {}
        self._left_out: dict[str, int] = {}

    def add(self, refusal: Refusal, who: str) -> None:
        """Take note of a refusal.

        Args:
            refusal: of what, and why.
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
    """The page's address for a browser of this machine, which a server on all addresses has under the loopback's."""
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
