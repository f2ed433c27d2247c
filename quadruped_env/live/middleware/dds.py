"""DDS setup: the library, the domain, the network, and the participant of a process."""

import os
import socket
import stat
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError

DOMAIN_VARIABLE: Final = "ROS_DOMAIN_ID"
MAX_DOMAIN: Final = 232
"""Highest domain ID whose DDS ports do not exceed 65535."""
LOOPBACK_INTERFACE: Final = "lo" if sys.platform.startswith("linux") else "lo0"

_PARTICIPANTS: Final = 32
"""Maximum number of processes on one machine that discover each other without multicast, as in ROS 2."""
_ANNOUNCED: Final = "1s"
"""Interval of participant announcements. ROS 2 with default settings discovers a process only through these."""
_RECEIVED: Final = "192 KiB"
"""Receive buffer size. CycloneDDS fills one buffer completely before it uses the next; with its default of 1 MiB the
memory of a process appears to grow for half an hour."""
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
_ERRORS: Final = 3
"""CycloneDDS's log levels fatal and error. With warnings it would print a line for every damaged packet."""
_FILES: Final = Path("/proc/self/fd")
_FIRST_PORT: Final = 7400
_PORTS: Final = 250
"""Number of ports per domain in the DDSI-RTPS standard."""


@dataclass(frozen=True)
class Network:
    """The domain and network scope that a process communicates in."""

    domain_id: int = 0
    """Domain ID, 0 to 232; only participants of the same domain discover each other."""
    subnet: bool = False
    """False: this machine only, like `ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST`. True: also other machines of the
    subnet, with the settings of CYCLONEDDS_URI if set."""

    def __post_init__(self) -> None:
        if not 0 <= self.domain_id <= MAX_DOMAIN:
            raise QuadrupedError(f"{DOMAIN_VARIABLE}: expected 0 to {MAX_DOMAIN}; found {self.domain_id}")

    @classmethod
    def from_environment(cls, subnet: bool = False) -> "Network":
        """Return the domain that ROS 2 would use: ROS_DOMAIN_ID, or 0.

        Raises:
            QuadrupedError: if the variable is not a valid domain ID.
        """
        text = os.environ.get(DOMAIN_VARIABLE, "").strip() or "0"
        if not text.isdecimal():
            raise QuadrupedError(f"{DOMAIN_VARIABLE}: expected a whole number, 0 to {MAX_DOMAIN}; found {text!r}")
        return cls(int(text), subnet)

    def __str__(self) -> str:
        return f"domain {self.domain_id}, {'this subnet' if self.subnet else 'this machine only'}"


def import_dds() -> Any:
    """Import the module `cyclonedds`.

    Raises:
        MissingExtraError: if it is not installed.
    """
    try:
        import cyclonedds.core
    except ImportError as error:
        raise MissingExtraError("Live ROS 2 topics", "dds") from error
    return cyclonedds


def open_participant(network: Network, name: str) -> Any:
    """Create a DDS participant, through which a process discovers others and is discovered.

    The first participant of a process fixes the network of its domain.

    Args:
        network: the domain and network to join.
        name: the participant's name, visible to other processes.

    Raises:
        MissingExtraError: if cyclonedds is not installed.
        QuadrupedError: if the domain cannot be joined.
    """
    import_dds()
    from cyclonedds.core import DDSException, Policy, Qos
    from cyclonedds.domain import DomainParticipant
    from cyclonedds.internal import DDS

    DDS._dll_handle.dds_set_log_mask(_ERRORS)
    try:
        domain = _domain(network)
        # ROS 2 writes the same user data for a process without access control.
        participant = DomainParticipant(
            network.domain_id, qos=Qos(Policy.Userdata(b"enclave=/;"), Policy.EntityName(name))
        )
    except DDSException as error:
        fault = _SETTINGS_VARIABLE if network.subnet else f"the interface {LOOPBACK_INTERFACE}"
        raise QuadrupedError(
            f"cannot join {network}: {error}; check {fault}, or end a process if {_PARTICIPANTS} are on the "
            f"domain already"
        ) from error
    if not network.subnet:
        _bind_to_loopback(network.domain_id)
    # The domain's settings exist only as long as the domain object is referenced.
    participant.quadruped_domain = domain
    participant.quadruped_topics = {}
    return participant


_DOMAINS: Final[dict[int, tuple[Network, Any]]] = {}


def _domain(network: Network) -> Any:
    """Return the domain of an id within this process, with its settings."""
    from cyclonedds.domain import Domain

    if network.domain_id not in _DOMAINS:
        settings = _SETTINGS.format(
            general="" if network.subnet else _LOOPBACK,
            participants=_PARTICIPANTS,
            announced=_ANNOUNCED,
            received=_RECEIVED,
        )
        users = network.subnet and os.environ.get(_SETTINGS_VARIABLE)
        _DOMAINS[network.domain_id] = network, Domain(network.domain_id, None if users else settings)
    joined, domain = _DOMAINS[network.domain_id]
    if joined != network:
        raise QuadrupedError(
            f"domain {network.domain_id}: this process has joined it with {joined}; it cannot join with {network}"
        )
    return domain


def _bind_to_loopback(domain_id: int) -> None:
    """Restrict a domain's sockets to the loopback interface.

    CycloneDDS sends on the configured interface only, but listens on all interfaces.
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
    """Yield the open UDP sockets of this process, each as a duplicate for the caller to close."""
    for entry in list(_FILES.iterdir()):
        number = int(entry.name)
        try:
            if not stat.S_ISSOCK(os.fstat(number).st_mode):
                continue
            # Closing the Python object must not close the socket itself.
            duplicate = socket.socket(fileno=os.dup(number))
        except OSError:
            # The descriptor was closed in the meantime.
            continue
        if duplicate.family == socket.AF_INET and duplicate.type == socket.SOCK_DGRAM:
            yield duplicate
        else:
            duplicate.close()
