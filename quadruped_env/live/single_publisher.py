"""One robot on a domain: whoever publishes joint states makes sure to be the only one."""

import time
from typing import Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.session import Session
from quadruped_env.live.topics import JOINT_STATES, Topic
from quadruped_env.ros import SENSOR_DATA_QOS

LISTEN: Final = 1.0
"""s before the first message; who publishes is heard in that time"""
CONTEST: Final = 3.0
"""s after that, in which two that began together decide who stays"""


class SinglePublisherGuard:
    """Listens for others on a topic that this process is about to publish.

    Args:
        session: of the process.
        topic: that has one publisher.
    """

    def __init__(self, session: Session, topic: Topic = JOINT_STATES) -> None:
        self._session = session
        self._topic = topic
        self._others = session.node.subscribe(topic, SENSOR_DATA_QOS, ignore_own=True, read=bytes)
        self._contest_until = 0.0

    def check(self) -> None:
        """Listen for a while.

        Raises:
            QuadrupedError: if somebody is publishing; one whose process was killed is not.
        """
        end = time.monotonic() + LISTEN
        while self._session.running and time.monotonic() < end:
            self._session.wait(end - time.monotonic())
            if received := self._others.take():
                raise QuadrupedError(
                    f"{self._topic.name}: {self._owner(received[0].writer)} publishes it already on domain "
                    f"{self._session.node.network.domain_id}; end that first, or take another domain (--domain-id)"
                )
        self._contest_until = time.monotonic() + CONTEST

    def watch(self) -> None:
        """Look whether somebody else has begun; to be called often.

        Raises:
            QuadrupedError: if the two began together and the other one stays.
        """
        for received in self._others.take():
            graph = self._session.node.graph
            other = next((one for one in graph.endpoints(self._topic.name) if one.handle == received.writer), None)
            if other is None:
                continue
            if time.monotonic() < self._contest_until and other.participant < graph.participant:
                raise QuadrupedError(f"{self._topic.name}: {graph.owner(other)} began to publish it at the same time")
            self._session.say_once(
                f"{graph.owner(other)} publishes {self._topic.name} too; whoever listens hears two robots"
            )

    def _owner(self, writer: int) -> str:
        graph = self._session.node.graph
        return next((graph.owner(one) for one in graph.endpoints() if one.handle == writer), "another process")
