"""Subscriptions to topics as their publishers appear: of their type, and of the quality that all of them offer."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.graph import Endpoint
from quadruped_env.live.node import Read, Subscription
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session
from quadruped_env.live.topics import TOPICS, Topic
from quadruped_env.ros import MESSAGE_TYPES, Qos

DISCOVERY: Final = 1.5
"""s in which those who are on the domain already are found, with time to spare"""
_DEPTH: Final = 1000
"""Messages that may wait to be taken"""
_DEFAULT_DEPTH: Final = 10
_UPDATE_PERIOD: Final = 0.1
"""s"""


class Listener:
    """Subscribes to topics of others, whenever they appear.

    Args:
        session: of the process.
        names: of the topics, with or without the leading slash; none stands for all whose types are known here.
        read: makes the `read` of a topic's subscription; without it messages stay bytes.
    """

    def __init__(
        self, session: Session, names: Sequence[str] = (), read: Callable[[Topic], Read[Any]] = lambda topic: bytes
    ) -> None:
        self._session = session
        self._read = read
        self._names = tuple(f"/{name.lstrip('/')}" for name in names)
        self._pace = Pace(_UPDATE_PERIOD)
        self.subscriptions: list[Subscription[Any]] = []
        """One a topic that is published; each says what its publishers offer as `topic.qos`"""

    def update(self) -> None:
        """Subscribe to what has appeared. To be called often: it looks at the time itself.

        Raises:
            QuadrupedError: if a topic that was asked for has a type that is not known here.
        """
        if not self._pace.tick():
            return
        for name, publishers in self._published().items():
            heard = any(subscription.topic.name == name for subscription in self.subscriptions)
            if not heard and (not self._names or name in self._names):
                self._subscribe(name, publishers)

    @property
    def missing(self) -> str:
        """What there is to wait for, in words: the topics that nobody publishes; empty if there are none."""
        heard = {subscription.topic.name for subscription in self.subscriptions}
        if not self._names:
            return "" if heard else "any publisher"
        silent = [name for name in self._names if name not in heard]
        return f"a publisher of {' and of '.join(silent)}" if silent else ""

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
            problem = f"{name}: is of type {publishers[0].type_name}; known here are {', '.join(MESSAGE_TYPES)}"
            if self._names:
                raise QuadrupedError(problem)
            self._session.say_once(f"left out: {problem}")
            return
        offered = common_qos([endpoint.qos for endpoint in known], name)
        topic = Topic(name, known[0].type_name, offered)
        subscription = self._session.node.subscribe(topic, replace(offered, depth=_DEPTH), read=self._read(topic))
        self.subscriptions.append(subscription)


def common_qos(offers: Sequence[Qos], name: str) -> Qos:
    """What a subscription may ask for to hear all publishers of a topic, as ROS 2's tools do.

    The depth is that of this robot's topic of the name: publishers need not tell theirs.
    """
    depth = TOPICS[name].qos.depth if name in TOPICS else _DEFAULT_DEPTH
    return Qos(
        depth,
        reliable=all(offer.reliable for offer in offers),
        transient_local=all(offer.transient_local for offer in offers),
    )
