"""A node: publishers and subscriptions of one process, and waiting for messages or for the time.

node = Node("listener", Network.from_environment())
states = node.subscribe(JOINT_STATES)
while True:
    node.wait(1.0)
    for received, message in states.messages(refused=print):
        print(received.sent, message)
"""

import statistics
import time
from collections import deque
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, Final, Generic, NamedTuple, TypeVar, overload

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.live.dds import Network, open_participant
from quadruped_env.live.graph import Graph
from quadruped_env.live.profiles import dds_qos
from quadruped_env.live.topics import Topic
from quadruped_env.live.type_information import withhold_type_information
from quadruped_env.live.wire import wire_type
from quadruped_env.ros import Qos, cdr
from quadruped_env.timestamps import NS_PER_SECOND

_TAKEN: Final = 256
_LATENCIES: Final = 1000

T = TypeVar("T")
"""Of what the messages of a subscription are read as"""
Read = Callable[[bytes], T]
"""Reads CDR bytes; raises a QuadrupedError, or anything, if they do not hold what is expected"""
Refused = Callable[[str], object]
"""Called with the reason for each message that cannot be read"""


class Received(NamedTuple):
    """One message as it came."""

    data: bytes
    """CDR"""
    sent: int
    """ns of the sender's clock"""
    writer: int
    """Who sent it: `Endpoint.handle`"""
    taken: float = 0.0
    """s of `time.monotonic` when it was taken, before anything was read"""


class Publisher:
    """Sends messages on a topic. Made by `Node.publish`."""

    def __init__(self, participant: Any, topic: Topic, qos: Qos) -> None:
        from cyclonedds.pub import DataWriter

        self.topic = topic
        self.count = 0
        """Messages sent"""
        self._wire = wire_type(topic.type_name)
        self._writer = DataWriter(participant, _dds_topic(participant, topic), qos=dds_qos(qos, topic.type))

    def send(self, message: Any) -> None:
        """Send a message of `quadruped_env.ros.cdr`.

        Raises:
            QuadrupedError: if it is of another type.
        """
        if message.__msgtype__ != self.topic.type_name:
            raise QuadrupedError(
                f"{self.topic.name}: holds messages of {self.topic.type_name}; found {message.__msgtype__}"
            )
        self.send_bytes(cdr.serialize(message))

    def send_bytes(self, data: bytes) -> None:
        """Send a message that is CDR bytes already.

        Raises:
            QuadrupedError: if they do not hold a message of the topic's type; DDS looks.
        """
        from cyclonedds.core import DDSException

        try:
            self._writer.write(self._wire(data))
        except DDSException as error:
            raise QuadrupedError(
                f"{self.topic.name}: {len(data)} bytes could not be sent as a {self.topic.type_name}: {error}"
            ) from error
        self.count += 1

    @property
    def readers(self) -> int:
        """How many subscriptions it reaches."""
        return len(self._writer.get_matched_subscriptions())

    def wait_until_read(self, seconds: float) -> bool:
        """Wait until every reliable reader has what was sent; whether that came about in time."""
        try:
            return bool(self._writer.wait_for_acks(round(seconds * NS_PER_SECOND)))
        except AttributeError:
            # What cyclonedds 11.0.1 makes of a time that ran out: it looks for the code in a class without it.
            return False


class Subscription(Generic[T]):
    """Receives messages on a topic. Made by `Node.subscribe`."""

    def __init__(self, participant: Any, topic: Topic, qos: Qos, read: Read[T], ignore_own: bool = False) -> None:
        from cyclonedds.core import InstanceState, ReadCondition, SampleState, ViewState
        from cyclonedds.sub import DataReader

        self.topic = topic
        self.count = 0
        """Messages received"""
        self.latencies: deque[float] = deque(maxlen=_LATENCIES)
        """s from sending to taking, of the last ones; across machines as true as their clocks are"""
        self._read = read
        self._reader = DataReader(participant, _dds_topic(participant, topic), qos=dds_qos(qos, topic.type, ignore_own))
        self.condition = ReadCondition(self._reader, ViewState.Any | InstanceState.Any | SampleState.NotRead)

    def take(self) -> list[Received]:
        """All that has come since the last call, in the order of its coming."""
        taken: list[Received] = []
        while samples := self._reader.take(_TAKEN):
            # After the call, which may have been held up: a message cannot be older than this says.
            now, at = time.time_ns(), time.monotonic()
            for sample in samples:
                # A sample without data says only that a publisher went.
                if sample.sample_info.valid_data:
                    sent = sample.sample_info.source_timestamp
                    taken.append(Received(sample.data, sent, sample.sample_info.publication_handle, at))
                    self.latencies.append((now - sent) / NS_PER_SECOND)
            if len(samples) < _TAKEN:
                break
        self.count += len(taken)
        return taken

    def latest(self) -> Received | None:
        """The last one that has come since the last call."""
        taken = self.take()
        return taken[-1] if taken else None

    def messages(self, refused: Refused) -> Iterator[tuple[Received, T]]:
        """All messages since the last call that can be read, in the order of their coming.

        The one way in which nodes read what others send: no message of any size or content raises here.

        Args:
            refused: is called with the reason for every message that cannot be read.
        """
        for received in self.take():
            try:
                message = self.decode(received)
            except QuadrupedError as error:
                refused(str(error))
            else:
                yield received, message

    def newest(self, refused: Refused) -> tuple[Received, T] | None:
        """The last message since the last call that can be read; arguments as of `messages`."""
        messages = list(self.messages(refused))
        return messages[-1] if messages else None

    def decode(self, received: Received) -> T:
        """What a message that was received is read as: a message of `quadruped_env.ros.cdr`, or the result of `read`.

        Raises:
            QuadrupedError: if it cannot be read; the message names the topic.
            MissingExtraError: if rosbags is not installed.
        """
        try:
            return self._read(received.data)
        except MissingExtraError:
            raise
        except QuadrupedError as error:
            reason = str(error)
        # Bytes come from outside, and a reader may fail on them in ways that nobody has thought of.
        except Exception as error:
            reason = f"{len(received.data)} bytes cannot be read: {type(error).__name__}: {error}"
        prefix = f"{self.topic.name}: "
        raise QuadrupedError(reason if reason.startswith(prefix) else f"{prefix}{reason}")

    @property
    def writers(self) -> int:
        """How many publishers it hears."""
        return len(self._reader.get_matched_publications())

    @property
    def latency(self) -> float | None:
        """Median of `latencies`, or None before the first message."""
        return statistics.median(self.latencies) if self.latencies else None


class Node:
    """One node of the system.

    Args:
        name: what others may call it.
        network: where to meet them; without it as ROS_DOMAIN_ID says, on this machine only.

    Raises:
        MissingExtraError: if cyclonedds is not installed.
        QuadrupedError: if the domain cannot be joined.
    """

    def __init__(self, name: str, network: Network | None = None) -> None:
        self.name = name
        self.network = network or Network.from_environment()
        self._participant = open_participant(self.network, name)
        from cyclonedds.core import WaitSet

        self.graph = Graph(self._participant)
        self.publishers: list[Publisher] = []
        self.subscriptions: list[Subscription[Any]] = []
        self._waitset = WaitSet(self._participant)

    def publish(self, topic: Topic, qos: Qos | None = None) -> Publisher:
        """A publisher of a topic, which offers the topic's quality of service or another one."""
        _prepare(topic.type_name, None)
        publisher = Publisher(self._participant, topic, qos or topic.qos)
        self.publishers.append(publisher)
        return publisher

    @overload
    def subscribe(self, topic: Topic, qos: Qos | None = None, ignore_own: bool = False) -> Subscription[Any]: ...

    @overload
    def subscribe(
        self, topic: Topic, qos: Qos | None = None, ignore_own: bool = False, *, read: Read[T]
    ) -> Subscription[T]: ...

    def subscribe(
        self, topic: Topic, qos: Qos | None = None, ignore_own: bool = False, read: Read[Any] | None = None
    ) -> Subscription[Any]:
        """A subscription to a topic, which asks for the topic's quality of service or another one.

        One message of the type is read beforehand: the first reading takes up to a second, and messages would be late.

        Args:
            topic: what to hear.
            qos: what to ask for.
            ignore_own: hear only others, not what this node itself publishes.
            read: reads the CDR bytes; without it they become messages of `quadruped_env.ros.cdr`. Where it is `bytes`,
                they stay bytes.
        """
        if read is None:
            read = message_reader(topic, lambda message: message)
        if read is not bytes:
            _prepare(topic.type_name, read)
        subscription = Subscription(self._participant, topic, qos or topic.qos, read, ignore_own)
        self.subscriptions.append(subscription)
        self._waitset.attach(subscription.condition)
        return subscription

    def wait(self, seconds: float) -> bool:
        """Wait until a message is there to take, or for a time; whether there is one."""
        seconds = max(0.0, seconds)
        if not self.subscriptions:
            # DDS does not wait for nothing.
            time.sleep(seconds)
            return False
        return bool(self._waitset.wait(round(seconds * NS_PER_SECOND)) > 0)

    def close(self) -> None:
        """Leave the domain, so that others learn of it at once."""
        participant, self._participant = self._participant, None
        if participant is not None:
            participant._delete(participant._ref)


def message_reader(topic: Topic, convert: Callable[[Any], T]) -> Read[T]:
    """Reads a topic's CDR bytes as what a function makes of the message; it may raise a QuadrupedError."""
    return lambda data: convert(cdr.deserialize(data, topic.type_name))


@cache
def _example(type_name: str) -> bytes:
    """The CDR bytes of a message whose fields are all 0 or empty."""
    return cdr.serialize(cdr.message(type_name))


def _prepare(type_name: str, read: Read[Any] | None) -> None:
    """Write and read one message of a type: rosbags compiles its code at the first of each."""
    try:
        example = _example(type_name)
        if read is not None:
            read(example)
    except (QuadrupedError, MissingExtraError):
        # No joint states without names for this robot's reader. Who needs rosbags is told when it is needed.
        pass


def _dds_topic(participant: Any, topic: Topic) -> Any:
    from cyclonedds.topic import Topic as DdsTopic

    made = DdsTopic(participant, topic.dds_name, wire_type(topic.type_name))
    withhold_type_information(made)
    return made
