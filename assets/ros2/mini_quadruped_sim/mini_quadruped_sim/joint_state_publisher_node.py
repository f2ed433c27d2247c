"""The tutorial's node: the gait on /joint_states at 20 Hz.

    ros2 run mini_quadruped_sim joint_state_publisher_node
    ros2 run mini_quadruped_sim joint_state_publisher_node --ros-args -p angular_frequency:=4.0 -r __ns:=/r1
    ros2 param set /joint_state_publisher hip_amplitude 0.6       # while it runs

Timestamps lie on a grid of 1 / rate seconds from the node's start, and a message holds the gait's positions and
velocities at exactly its timestamp. On a machine that is too busy, messages are left out; the gait stays on time.
"""

import math
import sys
from dataclasses import replace
from typing import Any, TypeVar, cast

import rclpy
from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.exceptions import InvalidParameterTypeException
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.time import Time
from sensor_msgs.msg import JointState

from mini_quadruped_sim.gait import JOINT_NAMES, Gait

Value = TypeVar("Value", float, list[float])

RATE = 20.0
"""Hz"""
MAXIMUM_RATE = 1000.0
"""Hz"""
NANOSECONDS = 1_000_000_000


class JointStatePublisher(Node):
    """Publishes the gait on joint_states.

    Its parameters are `rate` (Hz), which is read when the node starts, and the fields of `Gait`, which may change while
    it runs; the phase stays continuous when the frequency changes.

    Raises:
        ValueError: if a parameter is out of range.
    """

    def __init__(self) -> None:
        super().__init__("joint_state_publisher")
        defaults = Gait()
        self._gait = Gait(
            hip_amplitude=self._parameter("hip_amplitude", defaults.hip_amplitude, "rad"),
            knee_amplitude=self._parameter("knee_amplitude", defaults.knee_amplitude, "rad"),
            knee_offset=self._parameter("knee_offset", defaults.knee_offset, "rad"),
            angular_frequency=self._parameter("angular_frequency", defaults.angular_frequency, "rad/s"),
            phases=tuple(self._parameter("phases", list(defaults.phases), "rad, one per joint")),
        )
        self._time_offset = 0.0
        """Added to the time since the start to keep the phase continuous, s."""
        rate = self._parameter("rate", RATE, "Hz", read_only=True)
        if not 0.0 < rate <= MAXIMUM_RATE:
            raise ValueError(f"rate: expected more than 0 and at most {MAXIMUM_RATE:g} Hz; found {rate:g}")
        self._period = 1.0 / rate
        self._publisher = self.create_publisher(JointState, "joint_states", 10)
        self._start = self.get_clock().now().nanoseconds
        self._last_tick = -1
        self._timer = self.create_timer(self._period, self._publish)
        self.add_on_set_parameters_callback(self._set_parameters)
        self.get_logger().info(f"publishing {len(JOINT_NAMES)} joints on {self._publisher.topic_name} at {rate:g} Hz")

    def _parameter(self, name: str, default: Value, unit: str, read_only: bool = False) -> Value:
        descriptor = ParameterDescriptor(description=unit, read_only=read_only)
        return cast(Value, self.declare_parameter(name, default, descriptor).value)

    def _set_parameters(self, parameters: list[Parameter]) -> SetParametersResult:
        """Change the gait from now on, unless a value is invalid."""
        values: dict[str, Any] = {one.name: one.value for one in parameters}
        if "phases" in values:
            values["phases"] = tuple(values["phases"])
        try:
            # use_sim_time is a parameter of every node.
            gait = replace(self._gait, **{name: value for name, value in values.items() if hasattr(self._gait, name)})
        except ValueError as error:
            return SetParametersResult(successful=False, reason=str(error))
        if gait.angular_frequency:
            t = max(self._last_tick, 0) * self._period
            cycle = self._gait.angular_frequency * (t + self._time_offset)
            self._time_offset = cycle / gait.angular_frequency - t
        self._gait = gait
        return SetParametersResult(successful=True)

    def _publish(self) -> None:
        # Rounded down: a callback that comes late belongs to the tick that it was meant for.
        elapsed = (self.get_clock().now().nanoseconds - self._start) / NANOSECONDS
        tick = math.floor(elapsed / self._period)
        if tick <= self._last_tick:
            return
        self._last_tick = tick
        t = tick * self._period
        message = JointState()
        message.header.stamp = Time(nanoseconds=self._start + round(t * NANOSECONDS)).to_msg()
        message.name = list(JOINT_NAMES)
        message.position = self._gait.positions(t + self._time_offset)
        message.velocity = self._gait.velocities(t + self._time_offset)
        message.effort = [0.0] * len(JOINT_NAMES)
        self._publisher.publish(message)


def main(arguments: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    rclpy.init(args=arguments)
    try:
        try:
            node = JointStatePublisher()
        except (ValueError, InvalidParameterTypeException) as error:
            sys.exit(f"error: {error}")
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        if rclpy.ok():
            rclpy.shutdown()


if __name__ == "__main__":
    main()
