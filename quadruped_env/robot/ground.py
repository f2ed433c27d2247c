"""Resting pose of the robot on flat ground, for given joint positions."""

import itertools
from typing import Final

import mujoco
import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.robot.facts import BASE_SIZE, FOOT_RADIUS, HIP_RADIUS, LEG_LENGTH, LEG_NAMES, LEG_RADIUS
from quadruped_env.robot.kinematics import forward_kinematics, skeleton
from quadruped_env.rotations import rotate

_BALL: Final = -(LEG_LENGTH - FOOT_RADIUS)
"""Height of the centre of a foot's ball in the leg's frame, m."""
_EDGE: Final = 1e-9
"""Tolerance for rounding errors: distance that the centre of mass may lie outside the support polygon, m."""


def foot_centres(positions: ArrayLike, base_pose: ArrayLike | None = None) -> NDArray[np.float64]:
    """Centres of the foot balls (..., 4, 3) in m, in the order of `LEG_NAMES`; arguments as `forward_kinematics`."""
    return _leg_points(positions, base_pose, _BALL)


def sole_heights(positions: ArrayLike, base_pose: ArrayLike) -> NDArray[np.float64]:
    """Height of each foot's lowest point above the ground (..., 4) in m; arguments as in `forward_kinematics`."""
    return foot_centres(positions, base_pose)[..., 2] - FOOT_RADIUS


def resting_pose(positions: ArrayLike) -> NDArray[np.float64]:
    """Pose (7,) of the base with the robot resting on its feet, above the origin and facing along x.

    The three feet whose support triangle contains the centre of mass touch the ground; the fourth foot touches it or is
    in the air. If no three feet can carry the robot, its base is level. If a hip, a knee or the base would penetrate
    the ground, the robot is raised until that part rests on the ground.

    Args:
        positions: joint positions in rad (8,), in the order of `JOINT_NAMES`.

    Returns:
        Position in m and quaternion wxyz.

    Raises:
        QuadrupedError: as `forward_kinematics`.
    """
    up = _support_normal(foot_centres(positions), _centre_of_mass(positions))
    # World axes in the base frame: z is the ground's normal, and x is as close as possible to the base's x axis.
    y = np.cross(up, [1.0, 0.0, 0.0])
    y /= np.linalg.norm(y)
    rotation = np.stack([np.cross(y, up), y, up])
    pose = np.zeros(7)
    mujoco.mju_mat2Quat(pose[3:], rotation.ravel())
    pose[2] = -_lowest(positions, up)
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


def _lowest(positions: ArrayLike, up: NDArray[np.float64]) -> float:
    """Height of the robot's lowest point relative to its base's centre, along a direction (3,) in the base frame, m."""
    poses = forward_kinematics(positions)
    hips = np.stack([poses[f"{leg}_hip"][0] for leg in LEG_NAMES])
    corners = np.array(list(itertools.product(*([-0.5 * size, 0.5 * size] for size in BASE_SIZE))))
    return float(
        min(
            (foot_centres(positions) @ up).min() - FOOT_RADIUS,
            (_leg_points(positions, None, -LEG_RADIUS) @ up).min() - LEG_RADIUS,
            (hips @ up).min() - HIP_RADIUS,
            (corners @ up).min(),
        )
    )


def _leg_points(positions: ArrayLike, base_pose: ArrayLike | None, z: float) -> NDArray[np.float64]:
    """Points (..., 4, 3) on the axes of the legs, at height z in the frames of the legs, m."""
    poses = forward_kinematics(positions, base_pose)
    points = []
    for leg in LEG_NAMES:
        origin, orientation = poses[f"{leg}_leg"]
        points.append(origin + rotate(orientation, [0.0, 0.0, z]))
    return np.stack(points, axis=-2)


def _centre_of_mass(positions: ArrayLike) -> NDArray[np.float64]:
    """Centre of mass of the robot (3,) in the base frame, m."""
    model = skeleton()
    data = mujoco.MjData(model)
    data.qpos[:7], data.qpos[7:] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], positions
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    return data.subtree_com[model.body("base_link").id].copy()
