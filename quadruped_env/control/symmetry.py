"""The robot's left/right symmetry, as a policy meets it.

Mirrored in the plane between its left and right legs, the robot is the same robot: a mirrored observation calls for the
mirrored action.
"""

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.observations import ObservationLayout


@dataclass(frozen=True, eq=False)
class Mirror:
    """How observations and actions change when the robot is mirrored."""

    observation_order: NDArray[np.intp]
    """Column that a column of the mirrored observation comes from (width,)"""
    observation_sign: NDArray[np.float32]
    """And its sign (width,)"""
    action_order: NDArray[np.intp]
    """Joint that a joint of the mirrored robot comes from (J,); all turn about the y axis, so their signs stay"""

    @classmethod
    def of(cls, layout: ObservationLayout) -> Self:
        """From the mirror rules of a layout's fields and its robot's joints."""
        return cls(layout.mirror_order, layout.mirror_sign, np.array(layout.robot.joint_mirror))

    def observation(self, observation: NDArray[np.floating]) -> NDArray[np.floating]:
        """The observation (..., width) that the mirror image would have."""
        return observation[..., self.observation_order] * self.observation_sign

    def action(self, action: NDArray[np.floating]) -> NDArray[np.floating]:
        """The action (..., J) that moves the mirror image in the same way."""
        return action[..., self.action_order]
