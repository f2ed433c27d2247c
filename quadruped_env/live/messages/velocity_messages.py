"""`/cmd_vel`: velocity commands as Twist or TwistStamped, whichever the other side uses."""

import time
from collections.abc import Callable
from typing import Any, Final

from quadruped_env.control.steering import Velocity
from quadruped_env.live.middleware.node import Node, Publisher, Received, Refused, Subscription
from quadruped_env.live.middleware.topics import CMD_VEL, CMD_VEL_STAMPED, Topic
from quadruped_env.live.pace import Pace
from quadruped_env.ros import Qos, cdr

_QOS: Final = Qos(depth=10, reliable=False)
"""Matches reliable and best-effort publishers."""
_LOOK_PERIOD: Final = 0.1
"""Time between checks for the type of the other side, s."""


class _Ends:
    """One publisher or subscription of `/cmd_vel`, replaced by one of the other type where only that one is used."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._pace = Pace(_LOOK_PERIOD)

    def other_type(self, used: Topic, writes: bool) -> Topic | None:
        """The topic of the other type, if others publish (`writes`) or subscribe to that one only."""
        if not self._pace.tick():
            return None
        graph = self._node.graph
        found = {one.type_name for one in graph.endpoints(used.name) if one.writes == writes and not graph.is_own(one)}
        other = CMD_VEL if used.type_name == CMD_VEL_STAMPED.type_name else CMD_VEL_STAMPED
        return other if other.type_name in found and used.type_name not in found else None


class VelocitySubscription:
    """Receives velocity commands.

    Args:
        node: the subscribing node.
        say: called with one line when the type changes.
    """

    def __init__(self, node: Node, say: Callable[[str], None] = lambda text: None) -> None:
        self._node, self._ends, self._say = node, _Ends(node), say
        self.subscription: Subscription[Any] = node.subscribe(CMD_VEL, _QOS)

    def newest(self, refused: Refused) -> tuple[Received, Velocity] | None:
        """The last valid command (m/s, rad/s) since the last call, or None."""
        if topic := self._ends.other_type(self.subscription.topic, writes=True):
            self._node.remove(self.subscription)
            self.subscription = self._node.subscribe(topic, _QOS)
            self._say(f"{topic.name}: its publisher sends {topic.type_name}, which is received from now on")
        newest = self.subscription.newest(refused)
        if newest is None:
            return None
        received, message = newest
        twist = getattr(message, "twist", message)
        return received, (twist.linear.x, twist.angular.z)


class VelocityPublisher:
    """Sends velocity commands.

    Args:
        node: the publishing node.
    """

    def __init__(self, node: Node) -> None:
        self._node, self._ends = node, _Ends(node)
        self.publisher: Publisher = node.publish(CMD_VEL)

    @property
    def readers(self) -> int:
        """Number of matched subscriptions."""
        if topic := self._ends.other_type(self.publisher.topic, writes=False):
            self._node.remove(self.publisher)
            self.publisher = self._node.publish(topic)
        return self.publisher.readers

    def send(self, command: Velocity) -> None:
        """Send a command: forward velocity in m/s and yaw rate in rad/s."""
        twist = {"linear": {"x": command[0]}, "angular": {"z": command[1]}}
        if self.publisher.topic.type_name == CMD_VEL_STAMPED.type_name:
            self.publisher.send(cdr.message(CMD_VEL_STAMPED.type_name, header=cdr.header(time.time_ns()), twist=twist))
        else:
            self.publisher.send(cdr.message(CMD_VEL.type_name, **twist))
