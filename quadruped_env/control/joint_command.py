"""What a controller may ask of the robot's motors: joint targets within their limits, or to go limp."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot

LIMP: Final = None
"""In place of joint targets: motors disabled"""

Target = NDArray[np.float64] | None
"""Joint targets, rad (J,), or `LIMP`"""


def limited(
    target: NDArray[np.float64], last: NDArray[np.float64], seconds: float, robot: Robot = MINI_QUADRUPED
) -> NDArray[np.float64]:
    """A target that a motor may be given: within the joints' range, and no faster than the robot's speed limit.

    Args:
        target: rad (J,).
        last: the target before, or where the joints were; rad (J,).
        seconds: since then.
        robot: whose limits apply.
    """
    reach = robot.velocity_limit * seconds
    low, high = robot.joint_position_low, robot.joint_position_high
    within = np.minimum(np.maximum(target, low), high)
    # The range has the last word: joints that were beyond it come back at once.
    near = np.minimum(np.maximum(within, last - reach), last + reach)
    return np.minimum(np.maximum(near, low), high)
