"""The way into DDS: the library, the domain, the network, and the participant of a process."""

import os
import socket
import stat
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError

DOMAIN_VARIABLE: Final = "ROS_DOMAIN_ID"
MAX_DOMAIN: Final = 232
"""Beyond it the ports of DDS would end beyond 65535"""
LOOPBACK_INTERFACE: Final = "lo" if sys.platform.startswith("linux") else "lo0"

_PARTICIPANTS: Final = 32
"""Processes on one machine that find each other without multicast: as many as ROS 2 allows for"""
_ANNOUNCED: Final = "1s"
"""How often a process tells of itself: a ROS 2 with its usual settings learns of it in no other way"""
_RECEIVED: Final = "192 KiB"
"""of a buffer for what comes in. CycloneDDS fills one to its end before it takes the next; with the 1 MiB that it would
take, a process seems to grow for half an hour"""
_LOOPBACK: Final = f"""
  <General>
    <Interfaces><NetworkInterface name="{LOOPBACK_INTERFACE}" multicast="false"/></Interfaces>
    <AllowMulticast>false</AllowMulticast>
  </General>
"""
_SETTINGS: Final = """
<CycloneDDS><Domain Id="any">{general}
  <Discovery>
    <ParticipantIndex>auto</ParticipantIndex>
    <MaxAutoParticipantIndex>{participants}</MaxAutoParticipantIndex>
    <SPDPInterval>{announced}</SPDPInterval>
    <Peers><Peer address="localhost"/></Peers>
  </Discovery>
  <Sizing><ReceiveBufferSize>{received}</ReceiveBufferSize></Sizing>
</Domain></CycloneDDS>
"""
_SETTINGS_VARIABLE: Final = "CYCLONEDDS_URI"
_FILES: Final = Path("/proc/self/fd")
_FIRST_PORT: Final = 7400
_PORTS: Final = 250
"""of each domain, as the standard has it"""


@dataclass(frozen=True)
class Network:
    """Who can be met."""

    domain_id: int = 0
    """Only participants of the same domain meet; 0 to 232"""
    subnet: bool = False
    """False keeps to this machine, as `ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST` does; True meets other machines
    as well, as CYCLONEDDS_URI says where that is set"""

    def __post_init__(self) -> None:
        if not 0 <= self.domain_id <= MAX_DOMAIN:
            raise QuadrupedError(f"{DOMAIN_VARIABLE}: expected 0 to {MAX_DOMAIN}; found {self.domain_id}")

    @classmethod
    def from_environment(
        cls, domain_id: int | None = None, subnet: bool = False, environment: Mapping[str, str] = os.environ
    ) -> "Network":
        """The domain that ROS 2 would take: ROS_DOMAIN_ID, or 0.

        Raises:
            QuadrupedError: if the variable holds no domain.
        """
        text = environment.get(DOMAIN_VARIABLE, "").strip()
        if domain_id is not None or not text:
            return cls(domain_id or 0, subnet)
        if not text.isdecimal():
            raise QuadrupedError(f"{DOMAIN_VARIABLE}: expected a whole number, 0 to {MAX_DOMAIN}; found {text!r}")
        return cls(int(text), subnet)

    def __str__(self) -> str:
        return f"domain {self.domain_id}, {'this subnet' if self.subnet else 'this machine only'}"


def import_dds() -> Any:
    """The module `cyclonedds`.

    Raises:
        MissingExtraError: if it is not installed.
    """
    try:
        import cyclonedds.core
    except ImportError as error:
        raise MissingExtraError("Live ROS 2 topics", "dds") from error
    return cyclonedds


def open_participant(network: Network, name: str) -> Any:
    """A participant of a domain: what a process needs to be seen, and to see others.

    The first one of a process decides on the network for its domain.

    Args:
        network: where to.
        name: what others may call it.

    Raises:
        MissingExtraError: if cyclonedds is not installed.
        QuadrupedError: if the domain cannot be joined.
    """
    import_dds()
    from cyclonedds.core import DDSException, Policy, Qos
    from cyclonedds.domain import DomainParticipant

    try:
        domain = _domain(network)
        # What ROS 2 writes there, so that its tools take the process for one without access control.
        participant = DomainParticipant(
            network.domain_id, qos=Qos(Policy.Userdata(b"enclave=/;"), Policy.EntityName(name))
        )
    except DDSException as error:
        fault = _SETTINGS_VARIABLE if network.subnet else f"the interface {LOOPBACK_INTERFACE}"
        raise QuadrupedError(
            f"cannot join {network}: {error}; {fault} may be at fault, or there are {_PARTICIPANTS} processes on the "
            f"domain already"
        ) from error
    if not network.subnet:
        _bind_to_loopback(network.domain_id)
    # The domain's settings live as long as somebody holds it.
    participant.quadruped_domain = domain
    return participant


_DOMAINS: Final[dict[int, tuple[Network, Any]]] = {}


def _domain(network: Network) -> Any:
    """The domain of an id within this process, with its settings."""
    from cyclonedds.domain import Domain

    known = _DOMAINS.get(network.domain_id)
    if known is None:
        own_settings = network.subnet and os.environ.get(_SETTINGS_VARIABLE)
        general = "" if network.subnet else _LOOPBACK
        settings = (
            None
            if own_settings
            else _SETTINGS.format(general=general, participants=_PARTICIPANTS, announced=_ANNOUNCED, received=_RECEIVED)
        )
        known = _DOMAINS[network.domain_id] = (network, Domain(network.domain_id, settings))
    if known[0] != network:
        raise QuadrupedError(
            f"domain {network.domain_id}: this process is on it with {known[0]}; it cannot be on it with {network} too"
        )
    return known[1]


def _bind_to_loopback(domain_id: int) -> None:
    """Let a domain's sockets hear nothing but the loopback interface.

    CycloneDDS sends on the interface that it is told, but listens on all of them.
    """
    if not hasattr(socket, "SO_BINDTODEVICE"):
        return
    first = _FIRST_PORT + _PORTS * domain_id
    for duplicate in _datagram_sockets():
        with duplicate:
            address, port = duplicate.getsockname()
            if address == "0.0.0.0" and first <= port < first + _PORTS:  # noqa: S104
                duplicate.setsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, LOOPBACK_INTERFACE.encode() + b"\0")


def _datagram_sockets() -> Iterator[socket.socket]:
    """The open UDP sockets of this process, each as a duplicate for the caller to close."""
    for entry in list(_FILES.iterdir()):
        number = int(entry.name)
        try:
            if not stat.S_ISSOCK(os.fstat(number).st_mode):
                continue
            # Closing the Python object must not close the socket itself.
            duplicate = socket.socket(fileno=os.dup(number))
        except OSError:
            # It was closed meanwhile.
            continue
        if duplicate.family == socket.AF_INET and duplicate.type == socket.SOCK_DGRAM:
            yield duplicate
        else:
            duplicate.close()
