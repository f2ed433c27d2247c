"""Files of an imported robot: its MJCF, and the task file with its motors and its stance."""

import json
import re
from collections.abc import Sequence
from typing import Any, Final
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

import mujoco
import numpy as np

from quadruped_env.errors import escaped
from quadruped_env.importer.assumed_motors import AssumedMotor
from quadruped_env.importer.description import Description, Link
from quadruped_env.importer.legs import Anatomy
from quadruped_env.importer.shapes import bounds
from quadruped_env.importer.stance import Stance
from quadruped_env.robot.quadruped_files import numbers
from quadruped_env.utils.arrays import Floats

_LEAST_BOX: Final = 0.02
"""Volume of a box of the base, relative to its largest, below which it is left out."""
_MAX_BOXES: Final = 5
_THIN: Final = 0.98
"""Radius of a shank relative to its foot: the foot is the lowest."""
_FRAME: Final = """
<mujoco>
  <compiler angle="radian" autolimits="true"/>
  <option timestep="0.005" integrator="implicitfast" cone="elliptic" iterations="10" ls_iterations="20">
    <flag island="disable" midphase="disable"/>
  </option>
  <default>
    <default class="visual">
      <geom group="2" contype="0" conaffinity="0" mass="0"/>
    </default>
    <default class="collision">
      <geom group="3" contype="1" conaffinity="0" condim="3" friction="0.8 0.005 0.0001" solref="0.01 1" mass="0"
            rgba="0.9 0.4 0.1 0.4"/>
    </default>
  </default>
  <asset>
    <material name="gray" rgba="0.55 0.57 0.6 1"/>
    <material name="blue" rgba="0.2 0.3 0.8 1"/>
    <material name="black" rgba="0.12 0.12 0.13 1"/>
    <material name="yellow" rgba="0.94 0.8 0.2 1"/>
  </asset>
</mujoco>
"""
"""What all written robots share; options and collisions are the built-in robot's."""


def robot_name(name: str) -> str:
    """Return a name of letters, digits and underscores."""
    return re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_")[:40] or "robot"


def mjcf(described: Description, anatomy: Anatomy, stance: Stance, bodies: Sequence[Link]) -> str:
    """Return the robot alone, with shapes of its own: boxes of the base, balls at the hips, shanks and feet."""
    root = ElementTree.fromstring(_FRAME.strip())  # noqa: S314  the constant above
    root.set("model", robot_name(described.name))
    root.insert(0, _comment(f" {described.name}, written by 'mini-quadruped robot'. SI units. "))
    base = _add(SubElement(root, "worldbody"), "body", name=bodies[0].name, pos=[0.0, 0.0, stance.height])
    _add_inertial(base, bodies[0])
    _add(base, "freejoint", name="floating_base")
    _add_base_shapes(base, bodies, anatomy, stance)
    elements = [base]
    for body in bodies[1:]:
        place = {"pos": body.position, "quat": _quaternion(body.rotation)}
        elements.append(_add(elements[body.parent], "body", name=body.name, **place))
        _add_inertial(elements[-1], body)
        limits = [float(f"{limit:.5g}") for limit in (body.joint.low, body.joint.high)]
        _add(elements[-1], "joint", name=body.joint.name, axis=body.joint.axis, range=limits)
        _add_leg_shapes(elements[-1], body, bodies, anatomy)
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode") + "\n"


def _add(above: Element, tag: str, **values: str | float | Sequence[float] | Floats) -> Element:
    """Add an element; numbers have 15 digits, which keep positions to 1e-9 m over a chain of links."""
    return SubElement(
        above, tag, {k: v if isinstance(v, str) else numbers(*np.atleast_1d(v)) for k, v in values.items()}
    )


def _add_geom(body: Element, material: str, collides: bool, **values: str | float | Sequence[float] | Floats) -> None:
    """Add a shape that is drawn, and once more if it collides; without a material it is not drawn."""
    if material:
        _add(body, "geom", **{"class": "visual"}, **values, material=material)
    if collides:
        _add(body, "geom", **{"class": "collision"}, **values)


def _comment(text: str) -> Any:
    return ElementTree.Comment(escaped(text).replace("--", "- -"))


def _quaternion(rotation: Floats) -> Floats:
    quaternion = np.zeros(4)
    mujoco.mju_mat2Quat(quaternion, rotation.ravel())
    return quaternion


def _add_inertial(element: Element, body: Link) -> None:
    moments, axes = np.linalg.eigh(body.inertia)
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    _add(element, "inertial", pos=body.centre, quat=_quaternion(axes), mass=body.mass, diaginertia=moments)


def _add_base_shapes(element: Element, bodies: Sequence[Link], anatomy: Anatomy, stance: Stance) -> None:
    base, leg = bodies[0], anatomy.legs[0]
    first = next(body for body in bodies[1:] if body.joint is leg.joints[0])
    origin = leg.anchors[0] - first.position  # of the base, in the frame of the stance
    hips = np.array([plane.hip for plane in stance.planes]) - origin
    lowest = float(hips[:, 2].min()) - 0.7 * stance.height
    found = [bounds([shape]) for shape in [s for s in base.shapes if s.collides] or base.shapes]
    boxes = [(0.5 * (low + high), 0.5 * (high - low)) for low, high in found if low[2] > lowest]
    boxes = [(centre, half) for centre, half in boxes if np.prod(half) > 0.0]
    boxes.sort(key=lambda box: -float(np.prod(box[1])))
    boxes = [box for box in boxes if np.prod(box[1]) >= _LEAST_BOX * np.prod(boxes[0][1])][:_MAX_BOXES]
    if not boxes:
        size = np.array([0.5 * np.ptp(hips[:, 0]), 0.35 * np.ptp(hips[:, 1]), 0.15 * stance.height])
        boxes = [(0.5 * (hips.min(axis=0) + hips.max(axis=0)), size)]
    for centre, half in boxes:
        _add_geom(element, "gray", True, type="box", size=np.maximum(half, 1e-3), pos=centre)
    centre, half = boxes[0]
    front = half * [0.1, 1.0, 1.0] + 0.001
    element.append(_comment(" A mark at the front. "))
    at = centre + np.array([half[0] - front[0] + 0.001, 0.0, 0.0])
    _add_geom(element, "yellow", False, type="box", size=front, pos=at)
    away = 5.5 * stance.height
    _add(element, "camera", name="track", pos=[0.0, -away, 0.35 * away], xyaxes="1 0 0 0 0.3 1", mode="trackcom")


def _add_leg_shapes(element: Element, body: Link, bodies: Sequence[Link], anatomy: Anatomy) -> None:
    leg = next(leg for leg in anatomy.legs if body.joint.name in leg.names)
    radius, last = anatomy.foot_radius, body.joint.name == leg.names[-1]
    if body.joint.name == leg.names[0]:  # the trunk's contact sensors watch this link
        _add_geom(element, "blue", True, type="sphere", size=1.5 * radius)
    end = leg.foot_in_link if last else next(b.position for b in bodies[1:] if bodies[b.parent] is body)
    if np.linalg.norm(end) > 1e-6:
        line, color = [0.0, 0.0, 0.0, *end], "black" if last else "blue"
        _add_geom(element, color, last, type="capsule", size=_THIN * radius, fromto=line)
    if last:
        _add_geom(element, "", True, name=f"{leg.corner}_foot_ball", type="sphere", size=radius, pos=end)
        _add(element, "site", name=f"{leg.corner}_foot", pos=end, size=radius, group="4")


def task_file(
    described: Description, source: str, model_file: str, stance: Sequence[float], motors: Sequence[AssumedMotor]
) -> str:
    """Return a Python file that defines the robot.

    Args:
        described: content of the file that was read.
        source: its name.
        model_file: name of the MJCF, next to the Python file.
        stance: positions of the joints in the order of the MJCF, rad.
        motors: its motors, of each joint of a leg from the base to the foot.
    """
    shown = re.sub(r"[^\w ,.-]", "_", f"{robot_name(described.name)}, read from {source}")
    names = [motor.field.upper() for motor in motors]
    if all(motor.values == motors[0].values for motor in motors):
        names = ["MOTOR"]
    lines = [
        f'"""{shown}. Edit an assumed number here; the model is in the file next to this one."""',
        "",
        "from pathlib import Path",
        "",
        "from quadruped_env.robot import JointMotor, MotorConfig, Robot",
        "",
    ]
    for name, motor in zip(names, motors, strict=False):
        numbered = [f"    {key}={value!r},  # {escaped(comment)}" for key, (value, comment) in motor.values.items()]
        lines += [f"{name} = JointMotor(", *numbered, ")"]
    given = "MOTOR, MOTOR" if len(names) == 1 else ", ".join(f"{name.lower()}={name}" for name in names)
    legs = [list(stance[i : i + len(motors)]) for i in range(0, len(stance), len(motors))]
    alike = all(leg == legs[0] for leg in legs)
    lines += [
        "ROBOT = Robot(",
        f'    name="{robot_name(described.name)}",',
        # JSON's quotes and escapes are Python's, and a Chinese name stays readable.
        f"    mjcf=Path(__file__).with_name({json.dumps(model_file, ensure_ascii=not model_file.isprintable())}),",
        f"    stance={f'{legs[0]} * 4' if alike else list(stance)},  # rad",
        f"    motors=MotorConfig({given}),",
        ")",
    ]
    return "\n".join(lines) + "\n"
