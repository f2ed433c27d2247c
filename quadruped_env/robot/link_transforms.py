"""Transforms between neighbouring links, as `robot_state_publisher` computes them from joint positions."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.skeleton import Skeleton
from quadruped_env.utils.rotations import from_axis_angle, multiply

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


def joint_transforms(
    skeleton: Skeleton, positions: ArrayLike, base_pose: ArrayLike | None = None
) -> tuple[Transform, ...]:
    """See `Robot.joint_transforms`."""
    num_joints = len(skeleton.joint_names)
    joints = np.asarray(positions, dtype=np.float64)
    if joints.ndim == 0 or joints.shape[-1] != num_joints or not np.isfinite(joints).all():
        raise QuadrupedError(
            f"joint_transforms: positions must be finite, of shape (..., {num_joints}); found {joints.shape}"
        )
    transforms = []
    if base_pose is not None:
        base = np.asarray(base_pose, dtype=np.float64)
        if base.shape != (*joints.shape[:-1], 7) or not np.isfinite(base).all():
            raise QuadrupedError(
                f"joint_transforms: base_pose must be finite, of shape {(*joints.shape[:-1], 7)}; found {base.shape}"
            )
        transforms.append(Transform(ODOMETRY_FRAME, skeleton.link_names[0], base[..., :3], base[..., 3:]))
    model = skeleton.model
    for column, name in enumerate(skeleton.joint_names):
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


def fixed_transforms(skeleton: Skeleton) -> tuple[Transform, ...]:
    """See `Robot.fixed_transforms`."""
    model = skeleton.model
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
