"""A URDF of a robot's model, for a robot that brings none."""

from collections.abc import Sequence
from typing import Final
from xml.sax.saxutils import quoteattr

import mujoco
import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.motors import JointMotor
from quadruped_env.robot.quadruped_files import drives, numbers
from quadruped_env.utils.arrays import Floats

_HINGE: Final = mujoco.mjtJoint.mjJNT_HINGE
_UPRIGHT: Final = 1e-7
"""Cosine of a pitch below which it is 90 degrees."""


def written_urdf(name: str, model: mujoco.MjModel, motors: Sequence[JointMotor]) -> str:
    """Return the links, joints, inertia, collision shapes and drives of a model as URDF.

    A capsule becomes a cylinder and two spheres, and a mesh the box around it.

    Args:
        name: name of the robot.
        model: the robot alone, whose first joint is free.
        motors: motor of each other joint.

    Raises:
        QuadrupedError: if a URDF cannot have such joints.
    """
    joints = {int(model.jnt_bodyid[i]): i for i in range(1, model.njnt)}
    parts, base = [], model.jnt_bodyid[0]
    for body in range(base, model.nbody):
        if model.body_rootid[body] != base:
            continue
        link = quoteattr(model.body(body).name or f"body_{body}")
        parts += [f"  <link name={link}>", _inertial(model, body), *_shapes(model, body), "  </link>"]
        if body == base:
            continue
        parent = model.body_parentid[body]
        joint = joints.get(body)
        kind = "fixed" if joint is None else "revolute" if model.jnt_type[joint] == _HINGE else "prismatic"
        title = f"fixed_{body}" if joint is None else model.joint(joint).name
        if model.body_jntnum[body] > 1 or (joint is not None and model.jnt_pos[joint].any()):
            raise QuadrupedError(
                f"a URDF cannot have the joint {title!r}, which is not at the origin of its link, or not alone in it; "
                f"give the robot's URDF: urdf=..."
            )
        parts += [
            f"  <joint name={quoteattr(title)} type={kind!r}>",
            f"    <parent link={quoteattr(model.body(parent).name or f'body_{parent}')}/><child link={link}/>",
            f"    {_origin(model.body_pos[body], model.body_quat[body])}",
        ]
        if joint is not None:
            low, high = model.jnt_range[joint]
            motor = motors[joint - 1]
            parts += [
                f'    <axis xyz="{numbers(*model.jnt_axis[joint])}"/>',
                f'    <limit lower="{numbers(low)}" upper="{numbers(high)}" effort="{numbers(motor.stall_torque)}" '
                f'velocity="{numbers(motor.no_load_speed)}"/>',
                f'    <dynamics damping="{numbers(motor.damping)}" friction="{numbers(motor.friction_loss)}"/>',
            ]
        parts.append("  </joint>")
    names = [model.joint(i).name for i in range(1, model.njnt)]
    parts.append(drives(name, names, model.jnt_range[1:], motors))
    head = f'<?xml version="1.0"?>\n<robot name={quoteattr(name)} xmlns:drake="http://drake.mit.edu">'
    return "\n".join([head, *parts, "</robot>\n"])


def _inertial(model: mujoco.MjModel, body: int) -> str:
    moments = dict(zip(("ixx", "iyy", "izz"), model.body_inertia[body], strict=True))
    inertia = " ".join(f'{key}="{numbers(value)}"' for key, value in moments.items())
    return (
        f"    <inertial>{_origin(model.body_ipos[body], model.body_iquat[body])}"
        f'<mass value="{numbers(model.body_mass[body])}"/><inertia {inertia} ixy="0" ixz="0" iyz="0"/></inertial>'
    )


def _shapes(model: mujoco.MjModel, body: int) -> list[str]:
    """Return each colliding shape of a body, to be drawn and to collide."""
    found = []
    for geom in np.flatnonzero((model.geom_bodyid == body) & ((model.geom_contype | model.geom_conaffinity) != 0)):
        kind, size, place = mujoco.mjtGeom(model.geom_type[geom]), model.geom_size[geom], model.geom_pos[geom]
        box, centre = f'<box size="{numbers(*(2.0 * model.geom_aabb[geom, 3:]))}"/>', model.geom_aabb[geom, :3]
        axes = _matrix(model.geom_quat[geom])
        shapes = [(box, place + axes @ centre)]
        if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
            shapes = [(f'<sphere radius="{numbers(size[0])}"/>', place)]
        elif kind in (mujoco.mjtGeom.mjGEOM_CYLINDER, mujoco.mjtGeom.mjGEOM_CAPSULE):
            shapes = [(f'<cylinder radius="{numbers(size[0])}" length="{numbers(2.0 * size[1])}"/>', place)]
        if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
            ball = f'<sphere radius="{numbers(size[0])}"/>'
            shapes += [(ball, place + side * size[1] * axes[:, 2]) for side in (-1.0, 1.0)]
        for shape, at in shapes:
            whole = f"{_origin(at, model.geom_quat[geom])}<geometry>{shape}</geometry>"
            found += [f"    <{use}>{whole}</{use}>" for use in ("visual", "collision")]
    return found


def _origin(position: Floats, quaternion: Floats) -> str:
    """Return the tag of a pose: position (3,) in m and quaternion wxyz."""
    matrix = _matrix(quaternion)
    level = np.hypot(matrix[2, 1], matrix[2, 2])
    roll, yaw = np.arctan2(matrix[2, 1], matrix[2, 2]), np.arctan2(matrix[1, 0], matrix[0, 0])
    if level < _UPRIGHT:  # only the difference of roll and yaw is defined
        roll, yaw = 0.0, np.arctan2(-matrix[0, 1], matrix[1, 1])
    angles = numbers(roll, np.arctan2(-matrix[2, 0], level), yaw)
    return f'<origin xyz="{numbers(*position)}" rpy="{angles}"/>'


def _matrix(quaternion: Floats) -> Floats:
    matrix = np.zeros(9)
    mujoco.mju_quat2Mat(matrix, quaternion)
    return matrix.reshape(3, 3)
