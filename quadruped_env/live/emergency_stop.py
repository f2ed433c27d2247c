"""`/estop`: the emergency stop of a node that moves the robot."""

import time
from dataclasses import replace
from typing import Final

from quadruped_env.live.middleware.topics import ESTOP
from quadruped_env.live.session import Session
from quadruped_env.ros.timestamps import NS_PER_SECOND

_START: Final = 0
"""In place of a publisher's handle: the stop with which the node starts."""
_DISCOVERY: Final = 3.0
"""Time after the start in which a publisher's first message may be one from before, as a latched one is, s."""
_REORDERED: Final = NS_PER_SECOND
"""Maximum time between two messages of a publisher that may arrive in the wrong order, ns."""


class EmergencyStop:
    """Stops that publishers of any QoS have sent, on the node's topic and on the global one.

    The publisher that sent a stop releases it. Once that one has left, another one does, with the first message that it
    sends, or with false after true. So a button that keeps sending that it is not pressed releases no other one's stop.
    Messages are taken at every turn of the session's loop.

    Args:
        stopped: True to start stopped, as by a publisher that has left.
    """

    def __init__(self, session: Session, stopped: bool = False) -> None:
        node = session.node
        topics = {node.names.resolved(topic).name: topic for topic in (replace(ESTOP, is_global=True), ESTOP)}
        self._session = session
        self._subscriptions = [node.subscribe(topic) for topic in topics.values()]
        self._stops: dict[int, int] = {_START: 0} if stopped else {}
        """Publishers that stop the robot, and the source timestamps of their messages, ns."""
        self._released: set[int] = set()
        """Publishers whose last message is no stop."""
        self._begin = time.monotonic()
        self.name = " or ".join(topics)
        """The topics."""
        session.every_turn.append(self.take)

    @property
    def stopped(self) -> bool:
        """True from a stop to its release."""
        return bool(self._stops)

    @property
    def awaited(self) -> str:
        """The release that is missing, with the topics and, as far as they are there, the publishers of the stop."""
        graph = self._session.node.graph
        owners = [graph.owner(one) for one in graph.endpoints() if one.handle in self._stops]
        whose = f"by {' and '.join(owners)}" if owners else "false of a new publisher, or true and then false"
        return f"the release of the emergency stop ({self.name}: {whose})"

    def take(self) -> None:
        """Take all messages since the last call."""
        before = self.stopped
        for subscription in self._subscriptions:
            for received, message in subscription.messages(self._session.refuse):
                if message.data:
                    self._stops[received.writer] = received.sent
                    self._released.discard(received.writer)
                else:
                    self._release(received.writer, received.sent)
        if self.stopped != before:
            self._session.say(f"emergency stop{'' if self.stopped else ' released'} ({self.name})")

    def _release(self, writer: int, sent: int) -> None:
        present = {handle for subscription in self._subscriptions for handle in subscription.matched}
        first = time.monotonic() - self._begin > _DISCOVERY and writer not in self._released
        if 0 < self._stops.get(writer, 0) - sent < _REORDERED:
            return  # the stop was sent after this release, and overtook it
        if first or writer in self._stops:
            self._stops = {one: at for one, at in self._stops.items() if one in present and one != writer}
        self._released.add(writer)
