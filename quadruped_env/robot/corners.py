"""Geometry of robots with one leg in each corner, each with a hip and a knee."""

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot

_MIN_DETERMINANT: Final = 1e-5
"""Least determinant of a leg's Jacobian, m^2/rad^2; that of the built-in robot is 2.8e-3."""


def corners(robot: Robot) -> tuple[int, ...]:
    """Corner of each leg: 0 left fore, 1 right fore, 2 left hind, 3 right hind.

    Raises:
        QuadrupedError: if the robot has not one leg with two joints in each corner.
    """
    found = tuple((2 * ~robot.fore_legs + ~robot.left_legs).tolist())
    if sorted(found) != [0, 1, 2, 3] or robot.num_joints != 2 * robot.num_legs:
        raise QuadrupedError(
            f"gait: the scripted gaits and the gait clock are for robots with one leg in each corner, with a hip and a "
            f"knee; {robot.name!r} has {robot.num_legs} legs with {robot.num_joints} joints"
        )
    return found


def leg_jacobians(robot: Robot) -> NDArray[np.float64]:
    """Derivatives of each foot's x and z by its hip and knee in the stance (L, 2, 2), m/rad.

    Raises:
        QuadrupedError: if a leg is straight in the stance, so that the derivatives have no inverse.
    """
    whole = robot.foot_jacobians(robot.stance)[:, ::2]
    found = np.stack([whole[leg, :, 2 * leg : 2 * leg + 2] for leg in range(robot.num_legs)])
    if np.abs(np.linalg.det(found)).min() < _MIN_DETERMINANT:
        raise QuadrupedError(
            f"gait: a leg of {robot.name!r} is straight in the stance, so the scripted gaits cannot be mapped to it; "
            f"bend the knees of its stance"
        )
    return found


def half_track(robot: Robot) -> float:
    """Mean distance of the feet from the middle plane in the stance, m."""
    return math.fsum(np.abs(robot.stance_feet[:, 1])) / robot.num_legs
