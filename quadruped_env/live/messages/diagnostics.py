"""`/diagnostics`: state and rates of a node, once per second, for rqt_robot_monitor and diagnostic_aggregator."""

import time
from collections.abc import Mapping
from typing import Final

from quadruped_env.live.middleware.node import Node
from quadruped_env.live.middleware.topics import DIAGNOSTICS
from quadruped_env.live.pace import Pace
from quadruped_env.ros import cdr

OK, WARN, ERROR = range(3)
"""Levels of `diagnostic_msgs/DiagnosticStatus`."""
_PERIOD: Final = 1.0
"""Time between messages, s."""


class Diagnostics:
    """Publishes the status of a node.

    Args:
        node: the node, whose subscriptions' and publishers' rates are sent.
        hardware: name of the robot.
    """

    def __init__(self, node: Node, hardware: str) -> None:
        self._node = node
        self._hardware = hardware
        self._publisher = node.publish(DIAGNOSTICS)
        self._pace = Pace(_PERIOD)
        self._counts: dict[object, int] = {}
        """Messages of each publisher and subscription until the last status."""
        self._sent_at = time.monotonic()

    def send(self, level: int, message: str, values: Mapping[str, object]) -> None:
        """Send a status if it is time; call it often. `level` is one of `OK`, `WARN`, `ERROR`."""
        if not self._pace.tick():
            return
        now, shown = time.monotonic(), dict(values)
        for end in self._node.ends:
            shown[f"{end.topic.name}, Hz"] = f"{(end.count - self._counts.get(end, 0)) / (now - self._sent_at):.1f}"
            self._counts[end] = end.count
        self._sent_at = now
        status = {
            "level": level,
            "name": f"{self._node.names.full_node}: robot",
            "message": message,
            "hardware_id": self._hardware,
            "values": [{"key": key, "value": str(value)} for key, value in shown.items()],
        }
        self._publisher.send(cdr.message(DIAGNOSTICS.type_name, header=cdr.header(time.time_ns()), status=[status]))
