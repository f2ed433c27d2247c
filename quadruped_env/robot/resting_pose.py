"""Resting pose of a robot on flat ground, for given joint positions."""

import itertools
from typing import Final

import mujoco
import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.robot.skeleton import Skeleton

_EDGE: Final = 1e-9
"""Tolerance for rounding errors: distance that the centre of mass may lie outside the support polygon, m."""


def resting_pose(skeleton: Skeleton, positions: ArrayLike) -> NDArray[np.float64]:
    """See `Robot.resting_pose`."""
    up = _support_normal(skeleton.foot_centres(positions), skeleton.centre_of_mass(positions))
    # World axes in the base frame: z is the ground's normal, and x is as close as possible to the base's x axis.
    y = np.cross(up, [1.0, 0.0, 0.0])
    y /= np.linalg.norm(y)
    rotation = np.stack([np.cross(y, up), y, up])
    pose = np.zeros(7)
    mujoco.mju_mat2Quat(pose[3:], rotation.ravel())
    pose[2] = -skeleton.lowest(positions, up)
    return pose


def _support_normal(feet: NDArray[np.float64], centre: NDArray[np.float64]) -> NDArray[np.float64]:
    """Normal of the ground (3,) in the base frame, for feet (4, 3) and a centre of mass (3,)."""
    for i, j, k in itertools.combinations(range(len(feet)), 3):
        normal = np.cross(feet[j] - feet[i], feet[k] - feet[i])
        length = np.linalg.norm(normal)
        if length < _EDGE:
            continue
        normal *= np.sign(normal[2]) / length
        if normal[2] <= 0.0 or ((feet - feet[i]) @ normal).min() < -_EDGE:
            continue
        corners = feet[[i, j, k]]
        # In projection along the normal, the centre of mass lies on the same side of all three edges.
        sides = [np.cross(b - a, centre - a) @ normal for a, b in itertools.pairwise([*corners, corners[0]])]
        if min(sides) >= -_EDGE or max(sides) <= _EDGE:
            return normal
    return np.array([0.0, 0.0, 1.0])
