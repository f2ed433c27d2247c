"""The robot's left/right symmetry, as a policy meets it.

Mirrored in the plane between its left and right legs, the robot is the same robot: a mirrored observation calls for the
mirrored action.
"""

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.robot import Robot


def mirror_action(action: NDArray[np.floating], robot: Robot) -> NDArray[np.floating]:
    """The action (..., J) that moves the robot's mirror image in the same way."""
    return action[..., list(robot.joint_mirror)]
