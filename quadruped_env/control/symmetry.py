"""Left/right symmetry of the robot, for observations and actions.

The robot is symmetric about the plane between its left and right legs, so the right action for a mirrored observation
is the mirrored action.
"""

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.observations import ObservationLayout


@dataclass(frozen=True, eq=False)
class MirrorMap:
    """Permutation and signs of observations and actions under the left/right mirror."""

    observation_order: NDArray[np.intp]
    """Source column of each column of the mirrored observation, (width,)."""
    observation_sign: NDArray[np.float32]
    """Sign of each column of the mirrored observation, (width,)."""
    action_order: NDArray[np.intp]
    """Source joint of each joint of the mirrored robot, (J,); all joints turn about the y axis, so no sign changes."""

    @classmethod
    def of(cls, layout: ObservationLayout) -> Self:
        """From the mirror rules of a layout's fields and its robot's joints; the same for each step of a history."""
        steps = layout.width * np.arange(layout.history)[:, None]
        order = (steps + layout.mirror_order).ravel()
        return cls(order, np.tile(layout.mirror_sign, layout.history), np.array(layout.robot.joint_mirror))

    def observation(self, observation: NDArray[np.floating]) -> NDArray[np.floating]:
        """Mirrored observation (..., width)."""
        return observation[..., self.observation_order] * self.observation_sign

    def action(self, action: NDArray[np.floating]) -> NDArray[np.floating]:
        """Mirrored action (..., J)."""
        return action[..., self.action_order]
