"""Forward kinematics: where every link is, for given joint positions."""

from functools import cache

import mujoco
import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.assets import asset_path
from quadruped_env.robot.facts import JOINT_NAMES, LINK_NAMES

Pose = tuple[NDArray[np.float64], NDArray[np.float64]]


@cache
def _robot_model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_path(str(asset_path("mini_quadruped.xml")))


def forward_kinematics(positions: ArrayLike, base_pose: ArrayLike | None = None) -> dict[str, Pose]:
    """The pose of every link, from MuJoCo's own kinematics.

    Args:
        positions: joint positions in rad, shape (..., 8), in the order of `JOINT_NAMES`.
        base_pose: position in m and quaternion wxyz of `base_link` in the world, shape (..., 7); without it the
            poses are in the frame of `base_link`. Leading axes of both arguments broadcast.

    Returns:
        Link name -> (position in m (..., 3), quaternion wxyz (..., 4)), in the order of `LINK_NAMES`.

    Raises:
        QuadrupedError: if the last axis is not 8 (or 7), the other axes do not broadcast, a value is not finite, or
            a quaternion is zero.
    """
    joints = np.asarray(positions, dtype=np.float64)
    if joints.ndim == 0 or joints.shape[-1] != len(JOINT_NAMES):
        raise QuadrupedError(
            f"forward_kinematics: positions must have shape (..., {len(JOINT_NAMES)}), one value a joint; "
            f"found {joints.shape}"
        )
    base = np.array([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]) if base_pose is None else np.asarray(base_pose, np.float64)
    if base.ndim == 0 or base.shape[-1] != 7:
        raise QuadrupedError(
            f"forward_kinematics: base_pose must have shape (..., 7), xyz and wxyz; found {base.shape}"
        )
    try:
        batch = np.broadcast_shapes(joints.shape[:-1], base.shape[:-1])
    except ValueError as error:
        raise QuadrupedError(
            f"forward_kinematics: the leading axes of positions {joints.shape} and base_pose {base.shape} do not fit"
        ) from error
    parts = [np.broadcast_to(base, (*batch, 7)), np.broadcast_to(joints, (*batch, len(JOINT_NAMES)))]
    qpos = np.concatenate(parts, axis=-1).reshape(-1, 7 + len(JOINT_NAMES))
    if not np.isfinite(qpos).all():
        raise QuadrupedError("forward_kinematics: positions and base_pose must be finite; found NaN or infinity")
    if not base[..., 3:].any(axis=-1).all():
        raise QuadrupedError("forward_kinematics: base_pose has a zero quaternion; identity is (1, 0, 0, 0)")

    model = _robot_model()
    data = mujoco.MjData(model)
    links = [model.body(name).id for name in LINK_NAMES]
    xpos = np.empty((len(qpos), len(links), 3))
    xquat = np.empty((len(qpos), len(links), 4))
    for row, configuration in enumerate(qpos):
        data.qpos = configuration
        mujoco.mj_kinematics(model, data)
        xpos[row] = data.xpos[links]
        xquat[row] = data.xquat[links]
    xpos = xpos.reshape(*batch, len(links), 3)
    xquat = xquat.reshape(*batch, len(links), 4)
    return {name: (xpos[..., i, :], xquat[..., i, :]) for i, name in enumerate(LINK_NAMES)}
