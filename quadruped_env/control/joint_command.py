"""Commands to the robot's motors: joint targets within the limits, or limp (motors disabled)."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.robot import Robot

LIMP: Final = None
"""Value in place of joint targets that disables the motors."""

Target = NDArray[np.float64] | None
"""Joint targets (J,) in rad, or `LIMP`."""


def limited(
    robot: Robot, target: NDArray[np.float64], last: NDArray[np.float64], seconds: float
) -> NDArray[np.float64]:
    """Joint targets within the joints' ranges that change no faster than the robot's velocity limit.

    Args:
        robot: robot whose limits apply.
        target: joint targets (J,), rad.
        last: previous joint targets, or the measured positions (J,), rad.
        seconds: time since `last`, s.
    """
    reach = robot.velocity_limit * seconds
    low, high = robot.joint_position_low, robot.joint_position_high
    within = np.minimum(np.maximum(target, low), high)
    # The range takes precedence over the velocity limit: joints outside it return to it at once.
    near = np.minimum(np.maximum(within, last - reach), last + reach)
    return np.minimum(np.maximum(near, low), high)
