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
    """Source joint of each joint of the mirrored robot, (J,)."""
    action_sign: NDArray[np.float32]
    """Sign of each joint of the mirrored robot, (J,); see `Robot.joint_signs`."""

    @classmethod
    def of(cls, layout: ObservationLayout) -> Self:
        """From the mirror rules of a layout's fields and its robot's joints; the same for each step of a history.

        Raises:
            QuadrupedError: if the robot's joints have no mirror images; see `Robot.joint_signs`.
        """
        robot = layout.robot
        joints = np.array(robot.joint_mirror), robot.joint_signs
        feet = np.array(robot.foot_mirror), np.ones(robot.num_legs)
        order, sign = [], []
        for field in layout.fields:
            rule, width = field.mirror, field.width(robot)
            columns = joints if rule == "joints" else feet if rule == "feet" else (np.arange(width), field.signs(robot))
            order.append(layout.slices[field.name].start + columns[0])
            sign.append(columns[1])
        steps = layout.width * np.arange(layout.history)[:, None]
        return cls(
            (steps + np.concatenate(order)).ravel(),
            np.tile(np.concatenate(sign).astype(np.float32), layout.history),
            *joints,
        )

    def observation(self, observation: NDArray[np.floating]) -> NDArray[np.floating]:
        """Mirrored observation (..., width)."""
        return observation[..., self.observation_order] * self.observation_sign

    def action(self, action: NDArray[np.floating]) -> NDArray[np.floating]:
        """Mirrored action (..., J)."""
        return action[..., self.action_order] * self.action_sign
