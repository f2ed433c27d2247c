"""Guard against two robots, or two controllers of one robot: states and commands must have a single publisher."""

import time
from collections.abc import Callable
from typing import Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.middleware.dds import DOMAIN_VARIABLE
from quadruped_env.live.middleware.node import Received
from quadruped_env.live.middleware.ros_graph import Endpoint
from quadruped_env.live.middleware.topics import JOINT_STATES, Topic
from quadruped_env.live.session import Session
from quadruped_env.ros import SENSOR_DATA_QOS

LISTEN: Final = 1.0
"""Time to listen for other publishers before the first message, s."""
CONTEST: Final = 3.0
"""Time after that in which one of two publishers that started together ends, s."""


class SinglePublisherGuard:
    """Listens for `LISTEN` seconds, and then watches at every turn of the session's loop for other publishers.

    Args:
        topic: the topic that must have a single publisher, and that this process is going to publish.
        publishing: returns False while this process sends no messages: any other publisher then has precedence.

    Raises:
        QuadrupedError: if another process sends messages. A publisher of a killed process sends none.
    """

    def __init__(
        self, session: Session, topic: Topic = JOINT_STATES, publishing: Callable[[], bool] = lambda: True
    ) -> None:
        self._session = session
        self._others = session.node.subscribe(topic, SENSOR_DATA_QOS, ignore_own=True, read=bytes)
        self._topic = self._others.topic
        self._publishing = publishing
        self._problem, self._problem_until = "", 0.0
        end = time.monotonic() + LISTEN
        while session.running and time.monotonic() < end:
            session.wait(end - time.monotonic())
            if received := self._others.take():
                other = self._sender(received[0])
                raise self._second("another process" if other is None else session.node.graph.owner(other))
        self._contest_until = time.monotonic() + CONTEST
        session.every_turn.append(self._watch)

    def _watch(self) -> None:
        """Raise a QuadrupedError if another publisher has started too, and has precedence."""
        graph, publishing = self._session.node.graph, self._publishing()
        if not publishing:
            self._contest_until = time.monotonic() + CONTEST
        for received in self._others.take():
            other = self._sender(received)
            if other is None:
                continue
            contested = time.monotonic() < self._contest_until and other.participant < graph.participant
            if contested or not publishing:
                raise self._second(graph.owner(other))
            self._problem = f"{graph.owner(other)} publishes {self._topic.name} too; end one of the two"
            self._problem_until = time.monotonic() + LISTEN
            self._session.say_once(self._problem)

    def _second(self, owner: str) -> QuadrupedError:
        return QuadrupedError(
            f"{self._topic.name}: {owner} publishes it already on domain {self._session.node.network.domain_id}, and "
            f"there can be one publisher only: end one of the two, or take another namespace (--namespace) or domain "
            f"({DOMAIN_VARIABLE})"
        )

    @property
    def problem(self) -> str:
        """The other publisher in the last second; empty if there was none."""
        return self._problem if time.monotonic() < self._problem_until else ""

    def _sender(self, received: Received) -> Endpoint | None:
        endpoints = self._session.node.graph.endpoints(self._topic.name)
        return next((one for one in endpoints if one.handle == received.writer), None)
