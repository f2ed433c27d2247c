"""Messages that steer: velocity commands (`/cmd_vel`), and settings of a scripted gait (`/gait`, `/gait/settings`)."""

from typing import Any

from quadruped_env.control.steering import Velocity
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait.gait_settings import GaitSettings
from quadruped_env.live.middleware.topics import CMD_VEL, GAIT
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import cdr
from quadruped_env.utils.arrays import Floats


def velocity_message(command: Velocity | Floats) -> Any:
    """Make a Twist.

    Args:
        command: forward velocity in m/s, yaw rate in rad/s and, or else 0, velocity to the left in m/s (2,) or (3,).
    """
    forward, turn, left = (*map(float, command), 0.0)[:3]
    return cdr.message(CMD_VEL.type_name, linear={"x": forward, "y": left}, angular={"z": turn})


def read_velocity(message: Any) -> Velocity:
    """Read a Twist or TwistStamped: forward velocity in m/s, yaw rate in rad/s, velocity to the left in m/s."""
    twist = getattr(message, "twist", message)
    return twist.linear.x, twist.angular.z, twist.linear.y


def settings_message(settings: GaitSettings) -> Any:
    """Make a `/gait` or `/gait/settings` message."""
    return cdr.message(GAIT.type_name, data=[settings.amplitude, settings.frequency, *settings.phases])


def read_settings(message: Any, robot: Robot) -> GaitSettings:
    """Read the settings of a `/gait` or `/gait/settings` message.

    Raises:
        QuadrupedError: if it does not hold two numbers and one per leg, or one is outside its range.
    """
    expected = 2 + robot.num_legs
    if len(message.data) != expected:
        raise QuadrupedError(
            f"holds {len(message.data)} numbers; send {expected}: amplitude as a multiple, frequency in Hz, and the "
            f"phase of {', '.join(robot.leg_names)} in cycles"
        )
    amplitude, frequency, *phases = message.data.tolist()
    return GaitSettings(amplitude, frequency, tuple(phase % 1.0 for phase in phases))
