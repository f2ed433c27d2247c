"""The robot's left/right symmetry, as the policy meets it.

Mirrored in the plane between its left and right legs, the robot is the same robot: a mirrored observation asks for the
mirrored action. The gait clock's mirror image is half a cycle away, because a trot swings the left fore with the right
hind leg.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import JOINT_NAMES
from quadruped_env.task.observations import OBSERVATION_LAYOUT

_SIDES: Final = {"L": "R", "R": "L"}

_JOINT_MIRROR: Final = tuple(JOINT_NAMES.index(_SIDES[name[0]] + name[1:]) for name in JOINT_NAMES)
"""Every joint turns about the y axis, so a mirrored joint keeps its sign and changes its side."""

_SIGNS: Final = {
    "projected_gravity": (1.0, -1.0, 1.0),
    "angular_velocity": (-1.0, 1.0, -1.0),  # an axial vector
    "command": (1.0, -1.0),
    "gait_clock": (-1.0, -1.0),
}


def _observation_mirror() -> tuple[list[int], list[float]]:
    order: list[int] = []
    signs: list[float] = []
    for field in OBSERVATION_LAYOUT:
        first = len(order)
        columns = _JOINT_MIRROR if field.width == len(JOINT_NAMES) else range(field.width)
        order += [first + column for column in columns]
        signs += _SIGNS.get(field.name, (1.0,) * field.width)
    return order, signs


_ORDER, _SIGN = _observation_mirror()
OBSERVATION_ORDER: Final = np.array(_ORDER)
"""Column of the observation that a column of the mirrored one comes from (OBSERVATION_WIDTH,)."""
OBSERVATION_SIGN: Final = np.array(_SIGN, dtype=np.float32)
"""And its sign (OBSERVATION_WIDTH,)."""
ACTION_ORDER: Final = np.array(_JOINT_MIRROR)
"""Joint that a joint of the mirrored robot is (8,)."""


def mirror_observation(observation: NDArray[np.floating]) -> NDArray[np.floating]:
    """The observation (..., OBSERVATION_WIDTH) that the mirror image would have."""
    return observation[..., OBSERVATION_ORDER] * OBSERVATION_SIGN


def mirror_action(action: NDArray[np.floating]) -> NDArray[np.floating]:
    """The action (..., 8) that moves the mirror image likewise."""
    return action[..., ACTION_ORDER]
