"""Geometry of robots with one leg in each corner, all with two or all with three joints."""

from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats

_INVERSE_STEPS: Final = 24
_LARGEST_CHANGE: Final = 0.2
"""Largest change of a joint in one step, rad."""
_DAMPING: Final = 0.1
"""Damping of the inverse kinematics per squared distance of a foot, 1/rad^2."""
_LEAST_DAMPING: Final = 1e-8
"""1/rad^2, times the squared height of the stance."""
_REACHED: Final = 1e-8
"""Distance of a foot from its place that counts as none, as a part of the height of the stance."""


def corners(robot: Robot) -> tuple[int, ...]:
    """Return `Robot.corners` of a robot with one leg in each.

    Raises:
        QuadrupedError: if the robot has not one leg in each corner, all with two or all with three joints.
    """
    of_legs = {len(joints) for joints in robot.leg_joints}
    if sorted(robot.corners) != [0, 1, 2, 3] or of_legs not in ({2}, {3}) or robot.num_joints != 4 * max(of_legs):
        raise QuadrupedError(
            f"gait: the scripted gaits and the gait clock are for robots with one leg in each corner, all with two or "
            f"all with three joints; {robot.name!r} has {robot.num_legs} legs with {robot.num_joints} joints"
        )
    return robot.corners


def postures_with_feet_at(robot: Robot, feet: Floats) -> Floats:
    """Return joint positions (N, J) in rad with the feet's centres at (N, L, 3) in m in the base frame.

    Where a foot cannot get there, since its leg is too short, its joints' ranges are too small or their axes are
    parallel, it gets near. Damped least squares from the stance.
    """
    joints, height = np.array(robot.leg_joints), robot.stance_height
    positions = np.tile(robot.stance, (len(feet), 1))
    for _ in range(_INVERSE_STEPS):
        missing = feet - robot.skeleton.foot_centres(positions)
        if np.abs(missing).max() < _REACHED * height:
            break
        jacobians = np.take_along_axis(robot.skeleton.foot_jacobians(positions), joints[None, :, None], axis=-1)
        # Near a straight leg an undamped step is far too long.
        damping = _DAMPING * (missing * missing).sum(axis=-1)[..., None, None] + _LEAST_DAMPING * height**2
        change = _least_squares(jacobians, missing, damping)
        # A joint at its limit stays there, and the others go on.
        wanted = positions[:, joints] + change
        free = (wanted > robot.joint_position_low[joints]) & (wanted < robot.joint_position_high[joints])
        others = _least_squares(jacobians * free[..., None, :], missing, damping)
        positions[:, joints] += np.clip(np.where(free, others, change), -_LARGEST_CHANGE, _LARGEST_CHANGE)
        np.clip(positions, robot.joint_position_low, robot.joint_position_high, out=positions)
    return positions


def _least_squares(jacobians: Floats, missing: Floats, damping: Floats) -> Floats:
    """Return the changes of joints (..., K) that move feet by (..., 3), with Jacobians (..., 3, K)."""
    transposed = jacobians.swapaxes(-1, -2)
    damped = transposed @ jacobians + damping * np.eye(jacobians.shape[-1])
    return np.asarray(np.linalg.solve(damped, transposed @ missing[..., None])[..., 0], dtype=np.float64)
