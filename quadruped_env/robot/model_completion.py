"""A robot's MJCF as it is simulated: with the files that it names, with motors, and with sensors if it brings none."""

import math
import os
from collections.abc import Mapping, Sequence
from contextvars import ContextVar
from pathlib import Path
from typing import Final
from xml.etree import ElementTree

import mujoco
import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.documents import read_bytes

_DIRECTORIES: Final = ("meshdir", "texturedir", "assetdir")
_FREE: Final = mujoco.mjtJoint.mjJNT_FREE
_TOUCH_MARGIN: Final = 0.005
"""Distance by which the zone of a foot's touch sensor is larger than the foot, m."""
_WHOLE_LINK: Final = 10.0
"""Radius of a zone that holds any link, m: a touch sensor counts the contacts of its own link only."""
_IMU: Final = "sensed_base"
_SENSORS: Final = {
    "joint_position": ("JOINTPOS", "JOINT"),
    "joint_velocity": ("JOINTVEL", "JOINT"),
    "joint_torque": ("ACTUATORFRC", "ACTUATOR"),
    "orientation": ("FRAMEQUAT", "base"),
    "angular_velocity_b": ("GYRO", "base"),
    "linear_acceleration_b": ("ACCELEROMETER", "base"),
    "base_position": ("FRAMEPOS", "base"),
    "linear_velocity_b": ("VELOCIMETER", "base"),
    "up_b": ("FRAMEZAXIS", "world"),
    "foot_force": ("TOUCH", "feet"),
    "foot_position": ("FRAMEPOS", "feet"),
    "foot_velocity": ("FRAMELINVEL", "feet"),
    "foot_angular_velocity": ("FRAMEANGVEL", "feet"),
    "trunk_force": ("TOUCH", "trunk"),
}
"""Field of `Readings` -> type of MuJoCo's sensor, and what it is on: each joint, the base, each foot, or the base and
the first link of each leg."""


read_files: Final[ContextVar[dict[Path, bytes] | None]] = ContextVar("read_files", default=None)
"""Files of models that were read, by path, for a caller that sets a dict."""


def read_model(path: Path) -> tuple[str, dict[str, bytes]]:
    """Return an MJCF, and the files that it names: meshes, textures and included MJCF, searched next to it.

    Raises:
        QuadrupedError: if a file is missing or cannot be read, or the MJCF is not XML.
    """
    assets: dict[str, bytes] = {}
    return _read(path, path.parent, assets, "name the robot's MJCF").decode(errors="replace"), assets


def _read(path: Path, folder: Path, assets: dict[str, bytes], fix: str) -> bytes:
    content = read_bytes(path, fix)
    try:
        root = ElementTree.fromstring(content) if path.suffix == ".xml" else None  # noqa: S314  the user's own file
    except ElementTree.ParseError as error:
        raise QuadrupedError(f"{path}: cannot be read ({error}); {fix}") from error
    if (files := read_files.get()) is not None:
        files[path] = content
    if root is None:
        return content
    directories = [text for element in root.iter("compiler") for name in _DIRECTORIES if (text := element.get(name))]
    for element in root.iter():
        name = element.get("file")
        if name is None or name in assets:
            continue
        places = [folder / directory / name for directory in ("", *directories)]
        found = next((place for place in places if os.path.isfile(place)), places[-1])
        assets[name] = b""  # a file that includes itself
        assets[name] = _read(found, folder, assets, f"put the file that {path.name} names there")
    return content


def parsed(text: str, assets: Mapping[str, bytes] | None, main: Mapping[str, str] | None = None) -> mujoco.MjSpec:
    """Return the specification of an MJCF that names the files `assets`, and includes the MJCF files `main`.

    Raises:
        ValueError: if MuJoCo cannot read it.
    """
    files = {**(assets or {}), **{name: content.encode() for name, content in (main or {}).items()}}
    included = {name: content for name, content in files.items() if name.endswith(".xml")}
    return mujoco.MjSpec.from_string(
        text, include=included, assets={k: v for k, v in files.items() if k not in included}
    )


def check_structure(spec: mujoco.MjSpec, joint_names: Sequence[str] | None) -> None:
    """Check base, joints and actuators of a robot's specification; None accepts the names and the order of its joints.

    Raises:
        QuadrupedError: if it has not one free joint, the first; has geoms that are fixed to the world; has other joints
            than these; a joint has no range; or there are actuators, but not one per joint in their order.
    """
    joints = list(spec.joints)
    free = [i for i, joint in enumerate(joints) if joint.type == _FREE]
    if free != [0]:
        raise QuadrupedError(f"its model must have one free joint, the first; found free joints at {free}")
    if not joints[0].parent.name:
        raise QuadrupedError("the body of its free joint has no name; name it, such as base_link")
    if fixed := _fixed_geoms(spec.worldbody):
        raise QuadrupedError(
            f"its MJCF must hold the robot alone, because the scene adds the ground, and a second one would double "
            f"every contact; found a {fixed[0].type.name[7:].lower()} {fixed[0].name!r} fixed to the world: "
            f"remove it, and choose the ground with terrain=... or --terrain"
        )
    joint_names = [joint.name for joint in joints[1:]] if joint_names is None else joint_names
    _check_order("joints", [joint.name for joint in joints[1:]], joint_names)
    for joint in joints[1:]:
        if not joint.name:
            raise QuadrupedError(f"a joint of the body {joint.parent.name!r} of its model has no name; name it")
        if not joint.range[0] < joint.range[1]:
            raise QuadrupedError(f"the joint {joint.name!r} of its model has no range; give its limits (range, rad)")
    for actuator in spec.actuators:
        if actuator.trntype not in (mujoco.mjtTrn.mjTRN_JOINT, mujoco.mjtTrn.mjTRN_JOINTINPARENT):
            raise QuadrupedError(f"the actuator {actuator.name!r} of its model does not act on a joint; remove it")
    if spec.actuators:
        _check_order("motors", [actuator.target for actuator in spec.actuators], joint_names)


def _check_order(what: str, found: Sequence[str], joint_names: Sequence[str]) -> None:
    if tuple(found) != tuple(joint_names):
        raise QuadrupedError(
            f"the {what} of its model are in the order {', '.join(found)}; joint_names has {', '.join(joint_names)}: "
            f"give all fields in the model's order"
        )


def _fixed_geoms(body: mujoco.MjsBody) -> list[mujoco.MjsGeom]:
    """Return the geoms of a body without joints, and of all that is fixed to it."""
    return [*body.geoms, *(geom for child in body.bodies if not child.joints for geom in _fixed_geoms(child))]


def make_servos(spec: mujoco.MjSpec, joint_names: Sequence[str]) -> None:
    """Make each actuator one on its joint, in rad and without gear and limits of its own; add those that are missing.

    Whatever the model's actuators are, `MotorConfig.write` makes DC motors of them.
    """
    for name in joint_names if not spec.actuators else ():
        spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    for actuator in spec.actuators:
        joint = spec.joint(actuator.target)
        hinge = joint.type == mujoco.mjtJoint.mjJNT_HINGE
        actuator.ctrlrange = joint.range * (math.pi / 180.0 if spec.compiler.degree and hinge else 1.0)
        actuator.name = actuator.name or actuator.target
        actuator.ctrllimited, actuator.inheritrange = 1, 0.0
        actuator.forcelimited, actuator.actlimited, joint.actfrclimited = 0, 0, 0
        actuator.forcerange, actuator.actrange, joint.actfrcrange = np.zeros((3, 2))
        actuator.gear = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]
        actuator.delay, actuator.nsample = 0.0, 0


def own_sensors(joint_names: Sequence[str], leg_names: Sequence[str]) -> dict[str, tuple[str, ...]]:
    """Return the names of the sensors that `add_sensors` adds, for each field of `Readings`."""
    names = {
        **dict.fromkeys(("JOINT", "ACTUATOR"), joint_names),
        **dict.fromkeys(("base", "world"), ("base",)),
        "feet": leg_names,
        "trunk": ("base", *leg_names),
    }
    return {field: tuple(f"sensed_{field}_{name}" for name in names[of]) for field, (_, of) in _SENSORS.items()}


def add_sensors(
    spec: mujoco.MjSpec,
    sensors: Mapping[str, Sequence[str]],
    foot_sites: Sequence[str],
    foot_radius: float,
    hips: Sequence[str],
) -> None:
    """Add the sensors of `own_sensors` to a robot with actuators; `foot_radius` in m, `hips` the legs' first links."""
    base, zone = spec.joints[0].parent, mujoco.mjtGeom.mjGEOM_SPHERE
    base.add_site(name=_IMU, type=zone, size=[_WHOLE_LINK] * 3, group=5)
    feet, trunk = [], [_IMU]
    for foot, hip in zip(foot_sites, hips, strict=True):
        site = spec.site(foot)
        feet.append(f"sensed_{foot}")
        site.parent.add_site(name=feet[-1], type=zone, pos=site.pos, size=[foot_radius + _TOUCH_MARGIN] * 3, group=5)
        trunk.append(f"sensed_hip_of_{foot}")
        spec.body(hip).add_site(name=trunk[-1], type=zone, size=[_WHOLE_LINK] * 3, group=5)
    objects = {
        "JOINT": [actuator.target for actuator in spec.actuators],
        "ACTUATOR": [actuator.name for actuator in spec.actuators],
        "base": [_IMU],
        "world": ["world"],
        "feet": feet,
        "trunk": trunk,
    }
    kinds = {"JOINT": "JOINT", "ACTUATOR": "ACTUATOR", "world": "BODY"}
    for field, names in sensors.items():
        sensor, of = _SENSORS[field]
        reference = {"reftype": mujoco.mjtObj.mjOBJ_SITE, "refname": _IMU} if of == "world" else {}
        for name, on in zip(names, objects[of], strict=True):
            spec.add_sensor(
                name=name,
                type=getattr(mujoco.mjtSensor, f"mjSENS_{sensor}"),
                objtype=getattr(mujoco.mjtObj, f"mjOBJ_{kinds.get(of, 'SITE')}"),
                objname=on,
                **reference,
            )
