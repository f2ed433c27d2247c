"""A node: publishers and subscriptions of one process, and waiting for messages with a timeout.

node = Node("listener", Network.from_environment())
states = node.subscribe(JOINT_STATES)
while True:
    node.wait(1.0)
    for received, message in states.messages(refused=print):
        print(received.sent, message)
"""

import contextlib
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from typing import Any, Final, Generic, NamedTuple, TypeVar

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.live.middleware.dds import Network, open_participant
from quadruped_env.live.middleware.names import Names
from quadruped_env.live.middleware.ros_graph import Graph
from quadruped_env.live.middleware.topics import DISCOVERY_INFO, Topic
from quadruped_env.live.middleware.wire import wire_type, withhold_type_information
from quadruped_env.ros import MessageType, Qos, cdr
from quadruped_env.ros.timestamps import NS_PER_SECOND

_TAKEN: Final = 256
_BLOCKING: Final = 100_000_000
"""Maximum time that a reliable writer blocks on a slow reader, the DDS default, ns."""
_SEEN: Final = 256
"""Number of messages among which those that several readers receive are found."""
_CREATING: Final = threading.Lock()
"""Held while a topic is made: one that another thread makes meanwhile would share the type that is being changed."""
_ALL_NODES: Final = Qos(depth=0, transient_local=True)

T = TypeVar("T")
"""Type that the messages of a subscription are decoded to."""
Read = Callable[[bytes], T]
"""Decodes CDR bytes; may raise a QuadrupedError, or any other exception, for invalid bytes."""
Refused = Callable[[str], object]
"""Called with the reason for each message that cannot be decoded."""


class Received(NamedTuple):
    """One received message, not yet decoded."""

    data: bytes
    """CDR bytes."""
    sent: int
    """Source timestamp, by the sender's clock, ns."""
    writer: int
    """Handle of the publisher, see `Endpoint.handle`."""
    taken: float = 0.0
    """`time.monotonic` at which the message was taken, before decoding, s."""


class Publisher:
    """Sends messages on a topic. Created by `Node.publish`."""

    def __init__(self, participant: Any, topic: Topic, qos: Qos) -> None:
        from cyclonedds.pub import DataWriter

        self.topic = topic
        self.count = 0
        """Number of messages sent."""
        self.entity = DataWriter(participant, _dds_topic(participant, topic), qos=_dds_qos(qos, topic.type))
        self._wire = wire_type(topic.type_name)
        """The writer on DDS."""
        self.entities = [self.entity]

    def send(self, message: Any) -> None:
        """Send a message of `quadruped_env.ros.cdr`. Raises a QuadrupedError if it is of another type."""
        if message.__msgtype__ != self.topic.type_name:
            raise QuadrupedError(
                f"{self.topic.name}: holds messages of {self.topic.type_name}; found {message.__msgtype__}"
            )
        self.send_bytes(cdr.serialize(message))

    def send_bytes(self, data: bytes) -> None:
        """Send a message that is already serialized to CDR.

        Raises:
            QuadrupedError: if DDS rejects the bytes as a message of the topic's type.
        """
        from cyclonedds.core import DDSException

        try:
            self.entity.write(self._wire(data))
        except DDSException as error:
            raise QuadrupedError(
                f"{self.topic.name}: {len(data)} bytes could not be sent as a {self.topic.type_name}: {error}"
            ) from error
        self.count += 1

    @property
    def readers(self) -> int:
        """Number of matched subscriptions."""
        return int(self.entity.get_publication_matched_status().current_count)

    def wait_until_read(self, seconds: float) -> bool:
        """Wait until every reliable reader has acknowledged all messages. Returns False on timeout."""
        try:
            return bool(self.entity.wait_for_acks(round(seconds * NS_PER_SECOND)))
        except AttributeError:
            # cyclonedds 11.0.1 fails with this error on a timeout: it looks up the return code in the wrong class.
            return False


class Subscription(Generic[T]):
    """Receives messages on a topic, each once. Created by `Node.subscribe`.

    With several requests it has a reader for each, so that it matches publishers that no single request matches.
    """

    def __init__(
        self, participant: Any, topic: Topic, requests: Sequence[Qos], read: Read[T], ignore_own: bool = False
    ) -> None:
        from cyclonedds.core import InstanceState, ReadCondition, SampleState, ViewState
        from cyclonedds.sub import DataReader

        self.topic = topic
        self.count = 0
        """Number of messages received."""
        self._read = read
        self.entities = [
            DataReader(participant, _dds_topic(participant, topic), qos=_dds_qos(qos, topic.type, ignore_own))
            for qos in requests
        ]
        """The readers on DDS."""
        unread = ViewState.Any | InstanceState.Any | SampleState.NotRead
        self.conditions = [ReadCondition(entity, unread) for entity in self.entities]
        self._seen: deque[tuple[int, int]] = deque(maxlen=_SEEN)
        """Publisher and source timestamp of the last messages of several readers."""

    def take(self) -> list[Received]:
        """Return all messages since the last call, in order of arrival; with several readers, in order of sending."""
        taken = [received for entity in self.entities for received in self._take(entity)]
        if len(self.entities) > 1:
            taken = [received for received in sorted(taken, key=lambda one: one.sent) if self._is_new(received)]
        self.count += len(taken)
        return taken

    def _is_new(self, received: Received) -> bool:
        """Return False if another reader has received the message; one without a source timestamp counts as new."""
        key = received.writer, received.sent
        if received.sent > 0 and key in self._seen:
            return False
        self._seen.append(key)
        return True

    def _take(self, entity: Any) -> list[Received]:
        taken: list[Received] = []
        while samples := entity.take(_TAKEN):
            # Read the clock after the call, which may have been delayed, so that no message seems younger than it is.
            at = time.monotonic()
            for sample in samples:
                # A sample without data only reports that a publisher has left.
                if sample.sample_info.valid_data:
                    info = sample.sample_info
                    taken.append(Received(sample.data, info.source_timestamp, info.publication_handle, at))
            if len(samples) < _TAKEN:
                break
        return taken

    def messages(self, refused: Refused) -> Iterator[tuple[Received, T]]:
        """Yield all messages since the last call that can be decoded, in order of arrival.

        Nodes use this to read messages of other processes: no message raises here, whatever its size or content.

        Args:
            refused: called with the reason for each message that cannot be decoded.
        """
        for received in self.take():
            try:
                message = self.decode(received)
            except QuadrupedError as error:
                refused(str(error))
            else:
                yield received, message

    def newest(self, refused: Refused) -> tuple[Received, T] | None:
        """Return the last message since the last call that can be decoded; arguments as in `messages`."""
        messages = list(self.messages(refused))
        return messages[-1] if messages else None

    def decode(self, received: Received) -> T:
        """Decode a received message with `read`, by default to a message of `quadruped_env.ros.cdr`.

        Raises:
            QuadrupedError: if it cannot be decoded; the error names the topic.
            MissingExtraError: if rosbags is not installed.
        """
        try:
            return self._read(received.data)
        except MissingExtraError:
            raise
        except QuadrupedError as error:
            reason = str(error)
        # The bytes are untrusted, and a reader may fail on them with any exception.
        except Exception as error:
            reason = f"{len(received.data)} bytes cannot be read: {type(error).__name__}: {error}"
        raise QuadrupedError(f"{self.topic.name}: {reason}")

    @property
    def matched(self) -> set[int]:
        """Handles of the matched publishers, see `Received.writer`."""
        while True:
            # cyclonedds counts the handles before it reads them, and fails if there are more by then.
            with contextlib.suppress(IndexError):
                found = [handle for entity in self.entities for handle in entity.get_matched_publications()]
                # It reads them as signed numbers, so every second one is not the handle of its messages.
                return {handle % 2**64 for handle in found}

    @property
    def writers(self) -> int:
        """Number of matched publishers."""
        return len(self.matched)


class Node:
    """A node on a DDS domain.

    Args:
        name: the node's name, visible to other processes.
        network: the domain and network; by default ROS_DOMAIN_ID on this machine only.
        names: names of the node and its topics, instead of `name`.

    Raises:
        MissingExtraError: if cyclonedds is not installed.
        QuadrupedError: if the domain cannot be joined.
    """

    def __init__(self, name: str, network: Network | None = None, names: Names | None = None) -> None:
        self.names = names or Names(name)
        self.name = name = self.names.node
        self.network = network or Network.from_environment()
        self._participant = open_participant(self.network, name)
        from cyclonedds.core import WaitSet

        info = Subscription(
            self._participant, DISCOVERY_INFO, [_ALL_NODES], message_reader(DISCOVERY_INFO, lambda it: it)
        )
        self.graph = Graph(self._participant, lambda: info.messages(lambda reason: None))
        self._info = Publisher(self._participant, DISCOVERY_INFO, DISCOVERY_INFO.qos)
        self.publishers: list[Publisher] = []
        self.subscriptions: list[Subscription[Any]] = []
        self._waitset = WaitSet(self._participant)
        self._announce()

    def publish(self, topic: Topic, qos: Qos | None = None) -> Publisher:
        """Create a publisher of a topic; `qos` replaces the topic's quality of service."""
        publisher = Publisher(self._participant, self.names.resolved(topic), qos or topic.qos)
        self.publishers.append(publisher)
        self._announce()
        return publisher

    def subscribe(
        self, topic: Topic, qos: Qos | None = None, ignore_own: bool = False, read: Read[Any] | None = None
    ) -> Subscription[Any]:
        """Create a subscription to a topic.

        Args:
            topic: the topic to subscribe to.
            qos: requested quality of service, of one reader; by default the topic's.
            ignore_own: ignore messages that this node itself publishes.
            read: decodes the CDR bytes; by default to messages of `quadruped_env.ros.cdr`; `bytes` keeps them.
        """
        read = read or message_reader(topic, lambda message: message)
        requests = (qos,) if qos else topic.requests or (topic.qos,)
        subscription = Subscription(self._participant, self.names.resolved(topic), requests, read, ignore_own)
        self.subscriptions.append(subscription)
        for condition in subscription.conditions:
            self._waitset.attach(condition)
        self._announce()
        return subscription

    @property
    def ends(self) -> list[Publisher | Subscription[Any]]:
        """Publishers and subscriptions."""
        return [*self.publishers, *self.subscriptions]

    def remove(self, end: Publisher | Subscription[Any]) -> None:
        """Delete a publisher or subscription of this node."""
        if isinstance(end, Publisher):
            self.publishers.remove(end)
        else:
            for condition in end.conditions:
                self._waitset.detach(condition)
            self.subscriptions.remove(end)
        for entity in end.entities:
            entity._delete(entity._ref)
        self._announce()

    def _announce(self) -> None:
        """Send the node's name and its publishers and subscriptions, as ROS 2's middleware does."""

        def gid(entity: Any) -> dict[str, Any]:
            return {"data": [*entity.guid.bytes]}

        info = {
            "node_namespace": self.names.namespace,
            "node_name": self.name,
            "reader_gid_seq": [gid(entity) for one in self.subscriptions for entity in one.entities],
            "writer_gid_seq": [gid(entity) for one in self.publishers for entity in one.entities],
        }
        process = gid(self._participant)
        self._info.send(cdr.message(DISCOVERY_INFO.type_name, gid=process, node_entities_info_seq=[info]))

    def wait(self, seconds: float) -> bool:
        """Wait for a message, with a timeout in s. Returns True if a message is available."""
        seconds = max(0.0, seconds)
        if not self.subscriptions:
            # A DDS wait set without conditions returns at once.
            time.sleep(seconds)
            return False
        return bool(self._waitset.wait(round(seconds * NS_PER_SECOND)) > 0)

    def close(self) -> None:
        """Leave the domain, so that other processes are notified at once."""
        participant, self._participant = self._participant, None
        if participant is not None:
            participant._delete(participant._ref)


def message_reader(topic: Topic, convert: Callable[[Any], T]) -> Read[T]:
    """Returns a `Read` that decodes a topic's messages and converts them; `convert` may raise a QuadrupedError."""
    return lambda data: convert(cdr.deserialize(data, topic.type_name))


def _dds_qos(qos: Qos, kind: MessageType, ignore_own: bool = False) -> Any:
    """Return the DDS QoS for an endpoint; its user data carries the type hash, as in ROS 2 Iron and later."""
    from cyclonedds.core import Policy
    from cyclonedds.core import Qos as DdsQos

    return DdsQos(
        Policy.Reliability.Reliable(_BLOCKING) if qos.reliable else Policy.Reliability.BestEffort,
        Policy.Durability.TransientLocal if qos.transient_local else Policy.Durability.Volatile,
        Policy.History.KeepLast(qos.depth) if qos.depth else Policy.History.KeepAll,
        Policy.IgnoreLocal.Participant if ignore_own else Policy.IgnoreLocal.Nothing,
        Policy.Userdata(f"typehash={kind.type_hash};".encode()),
    )


def _dds_topic(participant: Any, topic: Topic) -> Any:
    """Return a participant's topic, made once: CycloneDDS cannot hold more than some thirty of one type."""
    from cyclonedds.topic import Topic as DdsTopic

    with _CREATING:
        made = participant.quadruped_topics
        if (key := (topic.dds_name, topic.type_name)) not in made:
            made[key] = DdsTopic(participant, topic.dds_name, wire_type(topic.type_name))
            withhold_type_information(made[key])
        return made[key]
