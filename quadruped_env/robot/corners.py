"""Geometry of robots with one leg in each corner, each with a hip and a knee."""

import math
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats

_MIN_DETERMINANT: Final = 1e-5
"""Least determinant of a leg's Jacobian, m^2/rad^2; the built-in robot has 2.8e-3."""

_INVERSE_STEPS: Final = 16
_LARGEST_CHANGE: Final = 0.2
"""Largest change of a joint in one step, rad."""
_DAMPING: Final = 0.1
"""Damping of the inverse kinematics per squared distance of a foot, 1/rad^2."""
_LEAST_DAMPING: Final = 1e-9
"""m^2/rad^2."""
_DIFFERENCE: Final = 1e-5
"""Step of numeric derivatives, rad."""


def corners(robot: Robot) -> tuple[int, ...]:
    """`Robot.corners` of a robot with one leg in each.

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


def check_bent_legs(robot: Robot) -> None:
    """Check that the derivatives of each foot's x and z by its hip and knee in the stance have an inverse.

    Raises:
        QuadrupedError: if a leg is straight in the stance, so that they have none.
    """
    whole = robot.skeleton.foot_jacobians(robot.stance)[:, ::2]
    of_legs = np.stack([whole[leg, :, 2 * leg : 2 * leg + 2] for leg in range(robot.num_legs)])
    if np.abs(np.linalg.det(of_legs)).min() < _MIN_DETERMINANT:
        raise QuadrupedError(
            f"gait: a leg of {robot.name!r} is straight in the stance, so the scripted gaits cannot be mapped to it; "
            f"bend the knees of its stance"
        )


def postures_with_feet_at(robot: Robot, feet: Floats) -> Floats:
    """Joint positions (N, J) in rad with the feet's centres at x and z (N, L, 2) in m in the base frame.

    Where a foot cannot get there within the joints' ranges, it gets near. Damped least squares from the stance.
    """
    positions = np.tile(robot.stance, (len(feet), 1))
    for _ in range(_INVERSE_STEPS):
        missing = feet - robot.skeleton.foot_centres(positions)[..., ::2]
        jacobians = np.empty((*missing.shape, 2))
        for joint in range(2):
            ahead = positions.copy()
            ahead[:, joint::2] += _DIFFERENCE
            behind = positions.copy()
            behind[:, joint::2] -= _DIFFERENCE
            difference = robot.skeleton.foot_centres(ahead) - robot.skeleton.foot_centres(behind)
            jacobians[..., joint] = difference[..., ::2] / (2.0 * _DIFFERENCE)
        transposed = jacobians.swapaxes(-1, -2)
        # Near a straight leg an undamped step is far too long.
        damping = _DAMPING * (missing * missing).sum(axis=-1)[..., None, None] + _LEAST_DAMPING
        damped = transposed @ jacobians + damping * np.eye(2)
        change = np.linalg.solve(damped, transposed @ missing[..., None]).reshape(positions.shape)
        positions += np.clip(change, -_LARGEST_CHANGE, _LARGEST_CHANGE)
        positions = np.clip(positions, robot.joint_position_low, robot.joint_position_high)
    return positions


def half_track(robot: Robot) -> float:
    """Mean distance of the feet from the middle plane in the stance, m."""
    return math.fsum(np.abs(robot.stance_feet[:, 1])) / robot.num_legs
