"""The ROS graph of a domain: all publishers and subscriptions, and why some of them do not match."""

import itertools
import uuid
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Final

from quadruped_env.live.middleware.topics import ros_name
from quadruped_env.ros import Qos

_TAKEN: Final = 256
_NAMELESS: Final = "a process that gives no name"


@dataclass(frozen=True)
class Endpoint:
    """A publisher or subscription of a process on the domain."""

    topic: str
    """ROS 2 topic name."""
    type_name: str
    """`package/msg/Type`, or the DDS type name if it is not a ROS 2 type."""
    writes: bool
    qos: Qos
    type_hash: str
    """Type hash, empty if not announced, as before ROS 2 Iron."""
    handle: int
    """Instance handle, equal to `Received.writer` of the messages that it sends."""
    participant: str
    """Key of the participant that owns it."""
    key: str = ""
    """Key of the endpoint, under which its process announces the node that it belongs to."""

    @property
    def kind(self) -> str:
        """`publisher` or `subscription`."""
        return "publisher" if self.writes else "subscription"


class Graph:
    """The endpoints that a participant has discovered.

    Args:
        participant: a `cyclonedds` participant.
        announced: returns the messages of `ros_discovery_info` since the last call.
    """

    def __init__(self, participant: Any, announced: Callable[[], Iterable[tuple[Any, Any]]] = lambda: ()) -> None:
        from cyclonedds import builtin

        self.participant = str(participant.guid)
        """Key of this process's participant, see `Endpoint.participant`."""
        self._readers = {
            True: builtin.BuiltinDataReader(participant, builtin.BuiltinTopicDcpsPublication),
            False: builtin.BuiltinDataReader(participant, builtin.BuiltinTopicDcpsSubscription),
        }
        self._participants = builtin.BuiltinDataReader(participant, builtin.BuiltinTopicDcpsParticipant)
        self._endpoints: dict[str, Endpoint] = {}
        self._names: dict[str, str] = {}
        self._announced = announced
        self._nodes: dict[str, dict[str, list[str]]] = {}
        """Participant -> node -> keys of its endpoints."""

    def endpoints(self, topic: str | None = None) -> list[Endpoint]:
        """Return all current endpoints, or one topic's, including this process's own."""
        self._update()
        found = (one for one in self._endpoints.values() if topic in (None, one.topic))
        return sorted(found, key=lambda one: (one.topic, one.type_name, not one.writes, one.handle))

    def is_own(self, endpoint: Endpoint) -> bool:
        """Return True if the endpoint belongs to this participant."""
        return endpoint.participant == self.participant

    def owner(self, endpoint: Endpoint) -> str:
        """Name of the node that owns an endpoint, or of its process; process ID and machine, as far as announced."""
        self._update()
        name = self._names.get(endpoint.participant, _NAMELESS)
        for node, keys in self._nodes.get(endpoint.participant, {}).items():
            if endpoint.key in keys:
                shown = node.removeprefix("/") if node.count("/") == 1 else node
                return f"{shown}{name[name.find(' (') :] if ' (' in name else ''}"
        return name

    def problems(self, all_processes: bool = False) -> list[str]:
        """Return the reasons why publishers and subscriptions of the same topic do not match, without repetition.

        Args:
            all_processes: include pairs in which neither endpoint belongs to this process.
        """
        found: dict[str, None] = {}
        for _, group in itertools.groupby(self.endpoints(), key=lambda one: one.topic):
            ends = list(group)
            for writer, reader in itertools.product(ends, ends):
                concerned = all_processes or self.is_own(writer) or self.is_own(reader)
                if not (concerned and writer.writes and not reader.writes and (reason := _obstacle(writer, reader))):
                    continue
                # Another subscription of the same node may receive from the writer.
                others = [one for one in ends if not one.writes and one.participant == reader.participant]
                if all(_obstacle(writer, one) or self.owner(one) != self.owner(reader) for one in others):
                    where = f"{writer.topic}, from {self._whose(writer)} to {self._whose(reader)}"
                    found[f"{where}: {reason}"] = None
        return list(found)

    def _whose(self, endpoint: Endpoint) -> str:
        return "this node" if self.is_own(endpoint) else self.owner(endpoint)

    def _update(self) -> None:
        from cyclonedds.core import InstanceState

        for process in _taken(self._participants):
            key = str(process.key)
            if process.sample_info.instance_state == InstanceState.Alive:
                self._names[key] = _name(process.qos)
            else:
                self._names.pop(key, None)
                self._nodes.pop(key, None)
        for _, info in self._announced():
            if (participant := _key(info.gid)) not in self._names:
                continue
            self._nodes[participant] = {
                f"{one.node_namespace.rstrip('/')}/{one.node_name}": [
                    _key(gid) for gid in (*one.reader_gid_seq, *one.writer_gid_seq)
                ]
                for one in info.node_entities_info_seq
            }
        for writes, reader in self._readers.items():
            for one in _taken(reader):
                key = str(one.key)
                if one.sample_info.instance_state != InstanceState.Alive:
                    self._endpoints.pop(key, None)
                elif ros_name(one.topic_name):
                    self._endpoints[key] = Endpoint(
                        ros_name(one.topic_name),
                        _ros_type(one.type_name),
                        writes,
                        _read_qos(one.qos),
                        _read_type_hash(one.qos),
                        one.sample_info.instance_handle,
                        str(one.participant_key),
                        key,
                    )


def _key(gid: Any) -> str:
    return str(uuid.UUID(bytes=bytes(gid.data)))


def _read_qos(qos: Any) -> Qos:
    """Return the profile of a discovered endpoint; depth 0 means keep all."""
    from cyclonedds.core import Policy

    policies = {policy.__scope__: policy for policy in qos}
    return Qos(
        depth=getattr(policies.get("History"), "depth", 0),
        reliable=isinstance(policies.get("Reliability"), Policy.Reliability.Reliable),
        transient_local=policies.get("Durability") not in (None, Policy.Durability.Volatile),
    )


def _read_type_hash(qos: Any) -> str:
    """Return the type hash in the user data of a discovered endpoint; empty if it has none."""
    for policy in qos:
        if policy.__scope__ == "Userdata":
            for entry in policy.data.decode("ascii", "replace").split(";"):
                key, _, value = entry.strip().partition("=")
                if key == "typehash":
                    return str(value)
    return ""


def _obstacle(writer: Endpoint, reader: Endpoint) -> str:
    """Return the reason why a reader receives nothing from a writer of its topic; empty if there is none."""
    if writer.type_name != reader.type_name:
        return f"no message will arrive; the types differ: {writer.type_name} and {reader.type_name}"
    checks = [
        (reader.qos.reliable > writer.qos.reliable, "reliable delivery", "best effort"),
        (reader.qos.transient_local > writer.qos.transient_local, "transient local (latched)", "volatile"),
    ]
    reasons = [f"the reader requests {asked}, the writer offers {offered}" for fails, asked, offered in checks if fails]
    if reasons:
        return f"no message will arrive; {' and '.join(reasons)}"
    if writer.type_hash and reader.type_hash and writer.type_hash != reader.type_hash:
        return (
            f"both use the type {writer.type_name}, but its definitions differ ({writer.type_hash} and "
            f"{reader.type_hash}); received messages cannot be trusted"
        )
    return ""


def _taken(reader: Any) -> Iterator[Any]:
    """Yield all changes since the last call."""
    while samples := reader.take(_TAKEN):
        yield from samples
        if len(samples) < _TAKEN:
            return


def _ros_type(dds_name: str) -> str:
    package, _, name = dds_name.partition("::msg::dds_::")
    return f"{package}/msg/{name.removesuffix('_')}" if name else dds_name


def _name(qos: Any) -> str:
    """Return a participant's name, process and machine, as far as its DDS implementation announces them."""
    properties: dict[str, str] = {}
    for policy in qos:
        if hasattr(policy, "key"):
            properties[policy.key] = policy.value
        elif policy.__scope__ == "EntityName":
            properties["name"] = policy.name
    process = properties.get("__Pid")
    where = f"process {process} on {properties.get('__Hostname', 'some machine')}" if process else ""
    name = properties.get("name") or properties.get("__ProcessName", "")
    return f"{name} ({where})" if name and where else name or where or _NAMELESS
