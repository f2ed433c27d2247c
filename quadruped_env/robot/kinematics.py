"""Forward kinematics: the poses of all links for given joint positions."""

from functools import cache
from typing import Final

import mujoco
import numpy as np
from mujoco.batch import Batch
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.assets import asset_path
from quadruped_env.robot.facts import JOINT_NAMES, LINK_NAMES

Pose = tuple[NDArray[np.float64], NDArray[np.float64]]

MAX_VALUE: Final = mujoco.mjMAXVAL
"""Maximum coordinate, above which MuJoCo treats a simulation as diverged, rad or m."""

_BLOCK: Final = 4096
"""Poses per batch: enough to make Python's overhead negligible, few enough to fit in the processor's cache."""


@cache
def skeleton() -> mujoco.MjModel:
    """Model with only the robot's bodies and joints, for kinematics at a third of the cost of the full model."""
    spec = mujoco.MjSpec.from_file(str(asset_path("mini_quadruped.xml")))
    for elements in (spec.sensors, spec.actuators, spec.pairs, spec.keys, spec.sites, spec.geoms, spec.cameras):
        for element in list(elements):
            spec.delete(element)
    return spec.compile()


def forward_kinematics(positions: ArrayLike, base_pose: ArrayLike | None = None) -> dict[str, Pose]:
    """Pose of every link, computed with MuJoCo's kinematics.

    Args:
        positions: joint positions in rad, shape (..., 8), in the order of `JOINT_NAMES`.
        base_pose: position in m and quaternion wxyz of `base_link` in the world, shape (..., 7); without it the
            poses are in the frame of `base_link`. Leading axes of both arguments broadcast.

    Returns:
        Position (..., 3) in m and quaternion wxyz (..., 4) of each link by name, in the order of `LINK_NAMES`.

    Raises:
        QuadrupedError: if the last axis is not 8 (or 7), the other axes do not broadcast, a value is not finite, or
            a quaternion is zero.
    """
    joints = np.asarray(positions, dtype=np.float64)
    if joints.ndim == 0 or joints.shape[-1] != len(JOINT_NAMES):
        raise QuadrupedError(
            f"forward_kinematics: positions must have shape (..., {len(JOINT_NAMES)}), one value per joint; "
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
    joints = np.broadcast_to(joints, (*batch, len(JOINT_NAMES))).reshape(-1, len(JOINT_NAMES))
    base = np.broadcast_to(base, (*batch, 7)).reshape(-1, 7)
    for values in (joints, base):
        # The minimum and maximum of an array with NaN are NaN, and comparisons with NaN are false.
        if values.size and not (values.min() >= -MAX_VALUE and values.max() <= MAX_VALUE):
            raise QuadrupedError(
                f"forward_kinematics: positions and base_pose must be finite and within {MAX_VALUE:g}; "
                f"found {values[~(np.abs(values) <= MAX_VALUE)][0]:g}"
            )
    if not base[:, 3:].any(axis=1).all():
        raise QuadrupedError("forward_kinematics: base_pose has a zero quaternion; identity is (1, 0, 0, 0)")

    xpos = np.empty((len(joints), len(LINK_NAMES), 3))
    xquat = np.empty((len(joints), len(LINK_NAMES), 4))
    if len(joints):
        _fill_link_poses(joints, base, xpos, xquat)
    xpos = xpos.reshape(*batch, len(LINK_NAMES), 3)
    xquat = xquat.reshape(*batch, len(LINK_NAMES), 4)
    return {name: (xpos[..., i, :], xquat[..., i, :]) for i, name in enumerate(LINK_NAMES)}


def _fill_link_poses(
    joints: NDArray[np.float64], base: NDArray[np.float64], xpos: NDArray[np.float64], xquat: NDArray[np.float64]
) -> None:
    """Write the link poses (N, L, 3) and (N, L, 4) of joint positions (N, 8) and base poses (N, 7)."""
    model = skeleton()
    links = np.array([model.body(name).id for name in LINK_NAMES])
    batch = Batch(model, min(_BLOCK, len(joints)), nthread=1)
    qpos, positions, quaternions = batch.bind("qpos"), batch.bind("xpos"), batch.bind("xquat")
    for start in range(0, len(joints), batch.nsim):
        block = slice(start, min(start + batch.nsim, len(joints)))
        count = block.stop - start
        qpos[:count, :7], qpos[:count, 7:] = base[block], joints[block]
        batch.forward(None if count == batch.nsim else np.arange(count), stage=mujoco.mjtStage.mjSTAGE_POS)
        xpos[block], xquat[block] = positions[:count, links], quaternions[:count, links]
