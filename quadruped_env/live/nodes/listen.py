"""Programs that listen to the topics of other processes: `list`, `echo`, `hz` and `record`."""

import argparse
import itertools
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.message_recorder import Recorder
from quadruped_env.live.messages.message_text import as_yaml, field_at, plain
from quadruped_env.live.middleware.dds import DOMAIN_VARIABLE
from quadruped_env.live.middleware.node import Read, Subscription, message_reader
from quadruped_env.live.middleware.ros_graph import Endpoint, Graph
from quadruped_env.live.middleware.topics import TOPICS, Topic
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session
from quadruped_env.ros import MESSAGE_TYPES, Qos
from quadruped_env.trajectory.formats.bag_writer import STORAGES
from quadruped_env.utils.files import free_path
from quadruped_env.utils.interpreter import program_command

DISCOVERY: Final = 1.5
"""Time within which existing publishers are discovered, with a margin, s."""
_UPDATE_PERIOD: Final = 0.1
"""Time between checks for new publishers, s."""
_DEPTH: Final = 1000
"""Queue depth of the subscriptions, messages."""
_DEFAULT_DEPTH: Final = 10
_WINDOW: Final = 1000
"""Number of messages that a rate is measured over."""
_LINES_PERIOD: Final = 1.0
"""Time between lines of `hz`, s."""
_NAMED: Final = 20
"""Maximum number of topics named in an error."""
_NO_TOPICS: Final = (
    f"no topic is published there: start a node, such as '{program_command('live', 'display')}', or look in another "
    f"domain ({DOMAIN_VARIABLE}) or on other machines (--subnet)"
)


class List:
    """List the topics on the domain and their types, and with --verbose their publishers and subscriptions.

    Listens for a moment, since discovery takes time. Reports why a publisher and a subscription do not match: different
    types or type hashes, or incompatible quality of service.
    """

    @staticmethod
    def add_arguments(parser: argparse.ArgumentParser) -> None:
        """Add the level of detail."""
        parser.add_argument(
            "-v",
            "--verbose",
            action="store_true",
            help="also list publishers and subscriptions, with QoS and type hash",
        )
        _add_seconds(parser, "listen for S seconds", DISCOVERY)

    @staticmethod
    def run(session: Session, arguments: argparse.Namespace) -> int:
        """Listen, print, and end."""
        while session.running:
            session.wait()
        graph = session.node.graph
        endpoints = graph.endpoints()
        for name, group in itertools.groupby(endpoints, key=lambda one: one.topic):
            ends = list(group)
            print(f"{name} [{', '.join(dict.fromkeys(one.type_name for one in ends))}]")
            if arguments.verbose:
                for one in ends:
                    print(f"    {_line(graph, one)}")
        for problem in graph.problems(all_processes=True):
            print(f"! {problem}")
        if not endpoints:
            session.say(f"listened on {session.node.network} for {session.elapsed:.1f} s; {_NO_TOPICS}")
        return 0


class Echo:
    """Print the messages of a topic, like `ros2 topic echo --full-length`.

        mini-quadruped live echo /joint_states
        mini-quadruped live echo /imu/data --once
        mini-quadruped live echo /cmd_vel --field linear.x
        mini-quadruped live echo /joint_states --seconds 10 > recording.yaml

    Requests a quality of service that all publishers of the topic offer. Messages that cannot be decoded or lack the
    field are counted in the log; if none is printed, the exit status is 2. Printed joint states can be read back:
    `mini-quadruped replay recording.yaml`.
    """

    @staticmethod
    def add_arguments(parser: argparse.ArgumentParser) -> None:
        """Add the topic and the output format."""
        parser.add_argument("topic", metavar="TOPIC", help="topic name, for example /joint_states")
        parser.add_argument("--once", action="store_true", help="end after the first message")
        parser.add_argument(
            "--field",
            default="",
            metavar="PATH",
            help="print only this field: header.stamp, position.0, transforms.0.transform",
        )
        _add_seconds(parser)

    @staticmethod
    def run(session: Session, arguments: argparse.Namespace) -> int:
        """Print until the session ends."""
        printed: set[str] = set()

        def reader(topic: Topic) -> Read[str]:
            return message_reader(topic, lambda message: as_yaml(field_at(plain(message), arguments.field)))

        for subscription in _listen(session, [arguments.topic], "print", lambda: printed, reader):
            for _, text in subscription.messages(session.refuse):
                print(text, end="", flush=True)
                printed.add(subscription.topic.name)
                if arguments.once:
                    return 0
        return 0


class Hz:
    """Measure the rate of messages, like `ros2 topic hz`: one line per second and topic.

        mini-quadruped live hz /joint_states
        mini-quadruped live hz                 all published topics

    Periods are measured between the arrivals of the last 1000 messages. Messages since the last line are reported at
    the end.
    """

    @staticmethod
    def add_arguments(parser: argparse.ArgumentParser) -> None:
        """Add the topics."""
        _add_topics(parser)

    @staticmethod
    def run(session: Session, arguments: argparse.Namespace) -> int:
        """Measure until the session ends."""
        arrivals: dict[str, deque[float]] = {}
        pace, unprinted = Pace(_LINES_PERIOD), 0
        pace.tick()

        def lines() -> None:
            for name, times in arrivals.items():
                print(f"{name}: {rate_text(times)}", flush=True)

        for subscription in _listen(session, arguments.topics, "measure", lambda: arrivals):
            if taken := subscription.take():
                times = arrivals.setdefault(subscription.topic.name, deque(maxlen=_WINDOW))
                times.extend(received.taken for received in taken)
            unprinted += len(taken)
            if pace.tick():
                lines()
                unprinted = 0
        if unprinted:
            lines()
        return 0


class Record:
    """Record topics into a bag, like `ros2 bag record`.

        mini-quadruped live record                           all topics of known types, as they appear
        mini-quadruped live record /joint_states -o my_bag

    The bag (rosbag2, MCAP) contains the received bytes with their arrival times, and the QoS that each topic's
    publishers offer. Ctrl-C completes it. During recording it is in `my_bag.part/my_bag`; if the recorder is killed it
    stays there, and `--repair salvage` recovers it. The recorded motion and the recorded joint targets can be replayed:

        mini-quadruped replay my_bag
        mini-quadruped replay my_bag --topic /joint_commands
        ros2 bag play my_bag
    """

    @staticmethod
    def add_arguments(parser: argparse.ArgumentParser) -> None:
        """Add the topics and the bag."""
        _add_topics(parser)
        parser.add_argument(
            "-o",
            "--output",
            type=Path,
            metavar="BAG",
            help="directory to create (default: results/recording, or that name with the next free number)",
        )
        parser.add_argument("-s", "--storage", choices=STORAGES, default="mcap", help="(default: %(default)s)")

    @staticmethod
    def run(session: Session, arguments: argparse.Namespace) -> int:
        """Record until the session ends."""
        path = arguments.output or free_path(Path("results") / "recording")
        with Recorder(path, arguments.storage) as recorder:
            for subscription in _listen(session, arguments.topics, "record", lambda: recorder.count):
                for received in subscription.take():
                    recorder.write(subscription.topic, received.data)
        print(f"{recorder.count} messages of {recorder.topics} topics: {path}")
        return 0


def _add_topics(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("topics", nargs="*", metavar="TOPIC", help="such as /joint_states (default: all)")
    _add_seconds(parser)


def _add_seconds(parser: argparse.ArgumentParser, what: str = "end after S seconds", default: Any = None) -> None:
    shown = "with Ctrl-C" if default is None else f"{default:g}"
    parser.add_argument("--seconds", type=float, metavar="S", default=default, help=f"{what} (default: {shown})")


def _listen(
    session: Session,
    names: Sequence[str],
    do: str,
    done: Callable[[], object],
    read: Callable[[Topic], Read[Any]] = lambda topic: bytes,
) -> Iterator[Subscription[Any]]:
    """Subscribe to topics of other processes as they appear, and yield each subscription at every turn.

    Args:
        session: of this process.
        names: topic names; without the leading slash, in the node's namespace; empty: all topics of known types.
        do: what the program does with messages, for the error.
        done: returns something true once the program has done so.
        read: returns the `read` function of a topic's subscription; by default messages stay bytes.

    Raises:
        QuadrupedError: if a requested topic has an unknown type, or nothing was done in the end.
    """
    names = [session.node.names.full(name) for name in names]
    found: dict[str, Subscription[Any]] = {}
    pace, missing = Pace(_UPDATE_PERIOD), ""
    for _ in session.turns(drain=True):
        if pace.tick():
            for name, publishers in _published(session).items():
                if name not in found and (not names or name in names) and (topic := _topic(session, publishers, names)):
                    qos = replace(topic.qos, depth=_DEPTH)
                    found[name] = session.node.subscribe(topic, qos, read=read(topic))
        yield from list(found.values())
        silent = [name for name in names if name not in found]
        missing = f"a publisher of {' and of '.join(silent)}" if silent else "" if found else "any publisher"
        session.wait_for(missing)
    if not done():
        published = sorted(_published(session))
        others = f"published there: {', '.join(published[:_NAMED])}{', ...' * (len(published) > _NAMED)}"
        raise QuadrupedError(
            f"nothing to {do} on {session.node.network}: waited for {missing or 'messages'} for "
            f"{session.elapsed:.1f} s; {others if published else _NO_TOPICS}"
        )


def _published(session: Session) -> dict[str, list[Endpoint]]:
    """Publishers of other processes, by topic."""
    graph = session.node.graph
    ends = [one for one in graph.endpoints() if one.writes and not graph.is_own(one)]
    return {name: list(group) for name, group in itertools.groupby(ends, key=lambda one: one.topic)}


def _topic(session: Session, publishers: Sequence[Endpoint], names: Sequence[str]) -> Topic | None:
    """Return a topic as its publishers offer it, or None if its type is unknown."""
    known = [endpoint for endpoint in publishers if endpoint.type_name in MESSAGE_TYPES]
    name = publishers[0].topic
    if known:
        # The name as it is on the domain.
        return Topic(name, known[0].type_name, common_qos([one.qos for one in known], name), is_global=True)
    problem = f"{name}: has the unknown type {publishers[0].type_name}; known types: {', '.join(MESSAGE_TYPES)}"
    if names:
        raise QuadrupedError(problem)
    session.say_once(f"skipped: {problem}")
    return None


def common_qos(offers: Sequence[Qos], name: str) -> Qos:
    """Return the QoS that matches all publishers of a topic, as ROS 2's tools choose it.

    The depth is taken from this robot's topic of the same name, since publishers need not announce theirs.
    """
    depth = TOPICS[name].qos.depth if name in TOPICS else _DEFAULT_DEPTH
    return Qos(
        depth,
        reliable=all(offer.reliable for offer in offers),
        transient_local=all(offer.transient_local for offer in offers),
    )


def rate_text(times: deque[float]) -> str:
    """Return the description of the rate and periods of messages with these arrival times, s."""
    if len(times) < 2:
        return f"{len(times)} messages" if len(times) != 1 else "1 message"
    periods = 1e3 * np.diff(times)
    return (
        f"average rate {1e3 / max(periods.mean(), 1e-6):.2f} Hz, period {periods.min():.2f} to "
        f"{periods.max():.2f} ms, standard deviation {periods.std():.2f} ms, {len(times)} messages"
    )


def _line(graph: Graph, endpoint: Endpoint) -> str:
    qos = endpoint.qos
    return (
        f"{endpoint.kind:<12} {graph.owner(endpoint)}: {'reliable' if qos.reliable else 'best effort'}, "
        f"{'transient local' if qos.transient_local else 'volatile'}, {endpoint.type_hash or 'no type hash'}"
    )
