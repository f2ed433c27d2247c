"""A URDF of a robot's model, for a robot that brings none."""

from collections.abc import Iterator, Sequence
from typing import Final
from xml.sax.saxutils import escape

import mujoco
import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.motors import JointMotor
from quadruped_env.robot.quadruped_files import drives, filled, numbers
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.rotations import rotate

_UPRIGHT: Final = 1e-7
"""Cosine of a pitch below which it is 90 degrees."""


def written_urdf(name: str, model: mujoco.MjModel, motors: Sequence[JointMotor]) -> str:
    """Return the links, joints, inertia, collision shapes and drives of a model as URDF.

    A capsule becomes a cylinder and two spheres, and a mesh the box around it. The model is the robot alone, whose
    first joint is free; `motors` has one for each other joint.

    Raises:
        QuadrupedError: if a joint is no hinge at the origin of its link.
    """
    links, base, name = [], int(model.jnt_bodyid[0]), _escaped(name)
    for body in np.flatnonzero(model.body_rootid == base).tolist():
        link = _link(model, body)
        links.append(filled("link.urdf", link, shapes="\n".join(_shapes(model, body))))
        if body != base:
            pose = _pose(model.body_pos[body], model.body_quat[body])
            place = {**link, **pose, "parent": _escaped(model.body(model.body_parentid[body]).name)}
            joints = range(model.body_jntadr[body], model.body_jntadr[body] + model.body_jntnum[body])
            links += [filled("joint.urdf", place, **_joint(model, i, motors[i - 1])) for i in joints]
            links += [] if joints else [filled("fixed_joint.urdf", place)]
    joint_names = [_escaped(model.joint(i).name) for i in range(1, model.njnt)]
    parts = {"links": "".join(links).rstrip(), "drives": drives(name, joint_names, model.jnt_range[1:], motors)}
    return filled("model.urdf", {"name": name}, **parts)


def _escaped(name: str) -> str:
    """Return a name as the value of an attribute."""
    return escape(name, {'"': "&quot;"})


def _link(model: mujoco.MjModel, body: int) -> dict[str, str]:
    pose = _pose(model.body_ipos[body], model.body_iquat[body])
    inertia = dict(zip(("ixx", "iyy", "izz"), map(numbers, model.body_inertia[body]), strict=True))
    name, mass = _escaped(model.body(body).name), numbers(model.body_mass[body])
    return {"link": name, "centre": pose["xyz"], "axes": pose["rpy"], "mass": mass, **inertia}


def _joint(model: mujoco.MjModel, joint: int, motor: JointMotor) -> dict[str, str]:
    name, alone = model.joint(joint).name, model.body_jntnum[model.jnt_bodyid[joint]] == 1
    if model.jnt_type[joint] != mujoco.mjtJoint.mjJNT_HINGE or model.jnt_pos[joint].any() or not alone:
        raise QuadrupedError(
            f"a URDF cannot have the joint {name!r}, which is no hinge at the origin of its link, or not alone in it; "
            f"give the robot's URDF: urdf=..."
        )
    low, high = map(numbers, model.jnt_range[joint])
    limits = {"low": low, "high": high, "effort": numbers(motor.stall_torque), "velocity": numbers(motor.no_load_speed)}
    passive = {"damping": numbers(motor.damping), "friction": numbers(motor.friction_loss)}
    return {"joint": _escaped(name), "axis": numbers(*model.jnt_axis[joint]), **limits, **passive}


def _shapes(model: mujoco.MjModel, body: int) -> Iterator[str]:
    """Yield each colliding shape of a body, to be drawn and to collide."""
    for geom in np.flatnonzero((model.geom_bodyid == body) & ((model.geom_contype | model.geom_conaffinity) != 0)):
        size, place, turn = model.geom_size[geom], model.geom_pos[geom], model.geom_quat[geom]
        centre, half = model.geom_aabb[geom].reshape(2, 3)
        ball, rod = f'sphere radius="{numbers(size[0])}"', f'length="{numbers(2.0 * size[1])}"'
        kind = mujoco.mjtGeom(model.geom_type[geom])
        found = [(f'box size="{numbers(*2.0 * half)}"', place + rotate(turn, centre))]
        if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
            found = [(ball, place)]
        if kind in (mujoco.mjtGeom.mjGEOM_CYLINDER, mujoco.mjtGeom.mjGEOM_CAPSULE):
            found = [(f'cylinder radius="{numbers(size[0])}" {rod}', place)]
        if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
            found += [(ball, place + rotate(turn, [0.0, 0.0, half])) for half in (-size[1], size[1])]
        for shape, at in found:
            values = {**_pose(at, turn), "shape": shape}
            yield "".join(filled("shape.urdf", values, use=use) for use in ("visual", "collision")).rstrip()


def _pose(position: Floats, quaternion: Floats) -> dict[str, str]:
    """Return position (3,) in m and quaternion wxyz as the attributes of an `origin`."""
    matrix = rotate(quaternion, np.eye(3)).T
    level = np.hypot(matrix[2, 1], matrix[2, 2])
    roll, yaw = np.arctan2(matrix[2, 1], matrix[2, 2]), np.arctan2(matrix[1, 0], matrix[0, 0])
    if level < _UPRIGHT:  # only the difference of roll and yaw is defined
        roll, yaw = 0.0, np.arctan2(-matrix[0, 1], matrix[1, 1])
    return {"xyz": numbers(*position), "rpy": numbers(roll, np.arctan2(-matrix[2, 0], level), yaw)}
