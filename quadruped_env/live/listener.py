"""Subscriptions that follow the publishers of a topic: their type, and a QoS that all of them offer."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.middleware.dds import DOMAIN_VARIABLE
from quadruped_env.live.middleware.node import Read, Subscription
from quadruped_env.live.middleware.ros_graph import Endpoint
from quadruped_env.live.middleware.topics import TOPICS, Topic
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session
from quadruped_env.ros import MESSAGE_TYPES, Qos
from quadruped_env.utils.interpreter import program_command

DISCOVERY: Final = 1.5
"""Time within which existing publishers are discovered, with a margin, s."""
_DEPTH: Final = 1000
"""Queue depth of the subscriptions, messages."""
_DEFAULT_DEPTH: Final = 10
_NAMED: Final = 20
"""Maximum number of topics named in an error."""
NO_TOPICS: Final = (
    f"no topic is published there: start a node, such as '{program_command('live', 'display')}', or look in another "
    f"domain (--domain-id N, or {DOMAIN_VARIABLE}) or on other machines (--subnet)"
)
_UPDATE_PERIOD: Final = 0.1
"""Time between checks for new publishers, s."""


class Listener:
    """Subscribes to topics of other processes as soon as they are published.

    Args:
        session: the session of this process.
        names: topic names; without the leading slash, in the node's namespace; by default all topics of known types.
        read: returns the `read` function of a topic's subscription; by default messages stay bytes.
    """

    def __init__(
        self, session: Session, names: Sequence[str] = (), read: Callable[[Topic], Read[Any]] = lambda topic: bytes
    ) -> None:
        self._session = session
        self._read = read
        self._names = tuple(session.node.names.full(name) for name in names)
        self._pace = Pace(_UPDATE_PERIOD)
        self.subscriptions: list[Subscription[Any]] = []
        """One subscription per published topic; `topic.qos` is the QoS that its publishers offer."""

    def update(self) -> None:
        """Subscribe to topics that have appeared. Call this often; it limits its own rate.

        Raises:
            QuadrupedError: if a requested topic has an unknown type.
        """
        if not self._pace.tick():
            return
        for name, publishers in self._published().items():
            heard = any(subscription.topic.name == name for subscription in self.subscriptions)
            if not heard and (not self._names or name in self._names):
                self._subscribe(name, publishers)

    @property
    def missing(self) -> str:
        """Description of the requested topics without a publisher; empty if there are none."""
        heard = {subscription.topic.name for subscription in self.subscriptions}
        if not self._names:
            return "" if heard else "any publisher"
        silent = [name for name in self._names if name not in heard]
        return f"a publisher of {' and of '.join(silent)}" if silent else ""

    def nothing_to(self, do: str) -> QuadrupedError:
        """The error of a tool that has received nothing; `do` is what it does with messages."""
        session, names = self._session, sorted(self._published())
        others = f"published there: {', '.join(names[:_NAMED])}{', ...' * (len(names) > _NAMED)}"
        return QuadrupedError(
            f"nothing to {do} on {session.node.network}: waited for {self.missing or 'messages'} for "
            f"{session.elapsed:.1f} s; {others if names else NO_TOPICS}"
        )

    def _published(self) -> dict[str, list[Endpoint]]:
        graph = self._session.node.graph
        found: dict[str, list[Endpoint]] = {}
        for endpoint in graph.endpoints():
            if endpoint.writes and not graph.is_own(endpoint):
                found.setdefault(endpoint.topic, []).append(endpoint)
        return found

    def _subscribe(self, name: str, publishers: Sequence[Endpoint]) -> None:
        known = [endpoint for endpoint in publishers if endpoint.type_name in MESSAGE_TYPES]
        if not known:
            problem = f"{name}: has the unknown type {publishers[0].type_name}; known types: {', '.join(MESSAGE_TYPES)}"
            if self._names:
                raise QuadrupedError(problem)
            self._session.say_once(f"skipped: {problem}")
            return
        offered = common_qos([endpoint.qos for endpoint in known], name)
        # The name as it is on the domain.
        topic = Topic(name, known[0].type_name, offered, is_global=True)
        subscription = self._session.node.subscribe(topic, replace(offered, depth=_DEPTH), read=self._read(topic))
        self.subscriptions.append(subscription)


def common_qos(offers: Sequence[Qos], name: str) -> Qos:
    """The QoS with which a subscription matches all publishers of a topic, as in ROS 2's tools.

    The depth is that of this robot's topic of the same name, since publishers need not announce theirs.
    """
    depth = TOPICS[name].qos.depth if name in TOPICS else _DEFAULT_DEPTH
    return Qos(
        depth,
        reliable=all(offer.reliable for offer in offers),
        transient_local=all(offer.transient_local for offer in offers),
    )
