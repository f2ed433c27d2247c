"""Transforms between neighbouring links, as `robot_state_publisher` computes them from joint positions."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.facts import JOINT_NAMES, LINK_NAMES
from quadruped_env.robot.kinematics import skeleton
from quadruped_env.rotations import from_axis_angle, multiply

ODOMETRY_FRAME: Final = "odom"
"""Parent frame of `base_link` if the pose of the base is known; the name is from REP 105."""


@dataclass(frozen=True)
class Transform:
    """Pose of a link in the frame of its parent, over time or constant."""

    parent: str
    child: str
    translation: NDArray[np.float64]
    """Translation (..., 3), m."""
    rotation: NDArray[np.float64]
    """Quaternion wxyz (..., 4); ROS messages use the order xyzw."""


def joint_transforms(positions: ArrayLike, base_pose: ArrayLike | None = None) -> tuple[Transform, ...]:
    """Transforms that `robot_state_publisher` sends on `/tf`: one per moving joint, from parent to child link.

    Args:
        positions: joint positions in rad, shape (..., 8), in the order of `JOINT_NAMES`.
        base_pose: position in m and quaternion wxyz of `base_link` in the world, shape (..., 7). With it the first
            transform is that of `base_link` in `ODOMETRY_FRAME`, which `robot_state_publisher` does not send.

    Returns:
        Transforms with leading axes (...), in the order of `JOINT_NAMES`.

    Raises:
        QuadrupedError: if a shape is wrong or a value is not finite.
    """
    joints = np.asarray(positions, dtype=np.float64)
    if joints.ndim == 0 or joints.shape[-1] != len(JOINT_NAMES) or not np.isfinite(joints).all():
        raise QuadrupedError(
            f"joint_transforms: positions must be finite, of shape (..., {len(JOINT_NAMES)}); found {joints.shape}"
        )
    transforms = []
    if base_pose is not None:
        base = np.asarray(base_pose, dtype=np.float64)
        if base.shape != (*joints.shape[:-1], 7) or not np.isfinite(base).all():
            raise QuadrupedError(
                f"joint_transforms: base_pose must be finite, of shape {(*joints.shape[:-1], 7)}; found {base.shape}"
            )
        transforms.append(Transform(ODOMETRY_FRAME, LINK_NAMES[0], base[..., :3], base[..., 3:]))
    model = skeleton()
    for column, name in enumerate(JOINT_NAMES):
        joint = model.joint(name)
        body = int(joint.bodyid[0])
        rotation = from_axis_angle(model.jnt_axis[joint.id], joints[..., column])
        transforms.append(
            Transform(
                model.body(model.body_parentid[body]).name,
                model.body(body).name,
                np.tile(model.body_pos[body], (*joints.shape[:-1], 1)),
                multiply(model.body_quat[body], rotation),
            )
        )
    return tuple(transforms)


def fixed_transforms() -> tuple[Transform, ...]:
    """Transforms that `robot_state_publisher` sends once on `/tf_static`: one per link without a joint.

    Every link of this robot has a joint, so the result is empty; the publisher then sends an empty message.
    """
    model = skeleton()
    return tuple(
        Transform(
            model.body(model.body_parentid[body]).name,
            model.body(body).name,
            model.body_pos[body].copy(),
            model.body_quat[body].copy(),
        )
        for body in range(1, model.nbody)
        if not model.body_jntnum[body]
    )
