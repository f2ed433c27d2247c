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
from quadruped_env.utils.arrays import Floats

_LEAST_BOX: Final = 0.02
"""Volume of a box of the base, relative to its largest, below which it is left out."""
_MAX_BOXES: Final = 5
_THIN: Final = 0.98
"""Radius of a shank relative to its foot: the foot is the lowest."""
_COLORS: Final = {
    "gray": "0.55 0.57 0.6 1",
    "blue": "0.2 0.3 0.8 1",
    "black": "0.12 0.12 0.13 1",
    "yellow": "0.94 0.8 0.2 1",
}


def numbers(values: Sequence[float] | Floats) -> str:
    """Return numbers with 15 digits, which keep positions to 1e-9 m over a chain of links."""
    return " ".join(f"{float(value) + 0.0:.15g}" for value in values)


def robot_name(name: str) -> str:
    """Return a name of letters, digits and underscores."""
    return re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_")[:40] or "robot"


def mjcf(described: Description, anatomy: Anatomy, stance: Stance, bodies: Sequence[Link]) -> str:
    """Return the robot alone, with shapes of its own: boxes of the base, balls at the hips, shanks and feet."""
    root = Element("mujoco", model=robot_name(described.name))
    root.append(_comment(f" {described.name}, written by 'mini-quadruped robot'. SI units. "))
    SubElement(root, "compiler", angle="radian", autolimits="true")
    option = SubElement(
        root,
        "option",
        timestep="0.005",
        integrator="implicitfast",
        cone="elliptic",
        iterations="10",
        ls_iterations="20",
    )
    SubElement(option, "flag", island="disable", midphase="disable")
    _defaults(SubElement(root, "default"))
    assets = SubElement(root, "asset")
    for color, rgba in _COLORS.items():
        SubElement(assets, "material", name=color, rgba=rgba)
    elements: list[Element] = []
    for i, body in enumerate(bodies):
        above = SubElement(root, "worldbody") if i == 0 else elements[body.parent]
        element = _body(above, body, stance.height if i == 0 else None)
        if i == 0:
            _base_shapes(element, body, anatomy, stance)
        else:
            _leg_shapes(element, body, bodies, anatomy)
        elements.append(element)
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode") + "\n"


def _comment(text: str) -> Any:
    return ElementTree.Comment(escaped(text).replace("--", "- -"))


def _defaults(element: Element) -> None:
    for name, group, values in (
        ("visual", "2", {"contype": "0", "conaffinity": "0", "mass": "0"}),
        (
            "collision",
            "3",
            {
                "contype": "1",
                "conaffinity": "0",
                "condim": "3",
                "friction": "0.8 0.005 0.0001",
                "solref": "0.01 1",
                "mass": "0",
                "rgba": "0.9 0.4 0.1 0.4",
            },
        ),
    ):
        SubElement(SubElement(element, "default", {"class": name}), "geom", {"group": group, **values})


def _body(above: Element, body: Link, height: float | None) -> Element:
    quaternion = np.zeros(4)
    mujoco.mju_mat2Quat(quaternion, body.rotation.ravel())
    place = body.position if height is None else [0.0, 0.0, height]
    element = SubElement(above, "body", name=body.name, pos=numbers(place))
    if height is None:
        element.set("quat", numbers(quaternion))
        joint = body.joint
        assert joint.low is not None
        assert joint.high is not None
    moments, axes = np.linalg.eigh(body.inertia)
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    mujoco.mju_mat2Quat(quaternion, axes.ravel())
    SubElement(
        element,
        "inertial",
        pos=numbers(body.centre),
        quat=numbers(quaternion),
        mass=numbers([body.mass]),
        diaginertia=numbers(moments),
    )
    if height is None:
        limits = numbers([float(f"{joint.low:.5g}"), float(f"{joint.high:.5g}")])
        SubElement(element, "joint", name=joint.name, axis=numbers(joint.axis), range=limits)
    else:
        SubElement(element, "freejoint", name="floating_base")
    return element


def _base_shapes(element: Element, base: Link, anatomy: Anatomy, stance: Stance) -> None:
    hips = np.array([plane.hip for plane in stance.planes])
    lowest = float(hips[:, 2].min()) - 0.7 * stance.height
    shapes = [s for s in base.shapes if s.collides] or base.shapes
    found = [bounds([shape]) for shape in shapes]
    boxes = [(low, high) for low, high in found if low[2] > lowest and np.prod(high - low) > 0.0]
    boxes.sort(key=lambda box: -float(np.prod(box[1] - box[0])))
    boxes = [box for box in boxes if np.prod(box[1] - box[0]) >= _LEAST_BOX * np.prod(boxes[0][1] - boxes[0][0])][
        :_MAX_BOXES
    ]
    if not boxes:
        half = np.array([0.5 * np.ptp(hips[:, 0]), 0.35 * np.ptp(hips[:, 1]), 0.15 * stance.height])
        centre = 0.5 * (hips.min(axis=0) + hips.max(axis=0))
        boxes = [(centre - half, centre + half)]
    for low, high in boxes:
        half, centre = np.maximum(0.5 * (high - low), 1e-3), 0.5 * (low + high)
        for kind in ("visual", "collision"):
            geom = SubElement(element, "geom", {"class": kind}, type="box", size=numbers(half), pos=numbers(centre))
            if kind == "visual":
                geom.set("material", "gray")
    low, high = boxes[0]
    half = np.array(
        [0.05 * (high[0] - low[0]) + 0.001, 0.5 * (high[1] - low[1]) + 0.001, 0.5 * (high[2] - low[2]) + 0.001]
    )
    centre = np.array([high[0] - half[0] + 0.001, *(0.5 * (low + high))[1:]])
    element.append(_comment(" A mark at the front. "))
    SubElement(
        element, "geom", {"class": "visual"}, type="box", size=numbers(half), pos=numbers(centre), material="yellow"
    )
    away = 5.5 * stance.height
    SubElement(
        element, "camera", name="track", pos=numbers([0.0, -away, 0.35 * away]), xyaxes="1 0 0 0 0.3 1", mode="trackcom"
    )


def _leg_shapes(element: Element, body: Link, bodies: Sequence[Link], anatomy: Anatomy) -> None:
    leg = next(leg for leg in anatomy.legs if body.joint.name in leg.names)
    place = leg.names.index(body.joint.name)
    radius = anatomy.foot_radius
    if place == 0:  # the trunk's contact sensors watch this link
        for kind in ("visual", "collision"):
            geom = SubElement(element, "geom", {"class": kind}, type="sphere", size=numbers([1.5 * radius]))
            if kind == "visual":
                geom.set("material", "blue")
    last = place == len(leg.names) - 1
    child = next((other for other in bodies if other.parent >= 0 and bodies[other.parent] is body), None)
    end = leg.foot_in_link if last else child.position if child is not None else None
    if end is None or np.linalg.norm(end) < 1e-6:
        return
    for kind in ("visual", "collision") if last else ("visual",):
        geom = SubElement(
            element,
            "geom",
            {"class": kind},
            type="capsule",
            size=numbers([_THIN * radius]),
            fromto=numbers([0.0, 0.0, 0.0, *end]),
        )
        if kind == "visual":
            geom.set("material", "black" if last else "blue")
    if last:
        SubElement(
            element,
            "geom",
            {"class": "collision"},
            name=f"{leg.corner}_foot_ball",
            type="sphere",
            size=numbers([radius]),
            pos=numbers(end),
        )
        SubElement(element, "site", name=f"{leg.corner}_foot", pos=numbers(end), size=numbers([radius]), group="4")


def task_file(
    described: Description,
    source: str,
    model_file: str,
    anatomy: Anatomy,
    stance: Stance,
    motors: Sequence[AssumedMotor],
    order: Sequence[str],
) -> str:
    """Return a Python file that defines the robot.

    Args:
        described: content of the file that was read.
        source: its name.
        model_file: name of the MJCF, next to the Python file.
        anatomy: legs of the robot.
        stance: its stance.
        motors: its motors, of each joint of a leg from the base to the foot.
        order: names of the joints in the order of the MJCF.
    """
    names = motor_kinds(anatomy)
    by_kind = dict(zip(names, motors, strict=True))
    if len({tuple(motor.values.items()) for motor in motors}) == 1:
        by_kind = {"motor": motors[0]}
        names = ["motor"]
    lines = [
        _docstring(described, source),
        "",
        "from pathlib import Path",
        "",
        "from quadruped_env.robot import JointMotor, MotorConfig, Robot",
        "",
    ]
    for kind, motor in by_kind.items():
        lines.append(f"{kind.upper()} = JointMotor(")
        lines += [f"    {name}={value!r},  # {escaped(comment)}" for name, (value, comment) in motor.values.items()]
        lines.append(")")
    given = ", ".join(f"{kind}={kind.upper()}" for kind in names) if len(by_kind) > 1 else "MOTOR, MOTOR"
    lines += [
        "ROBOT = Robot(",
        f'    name="{robot_name(described.name)}",',
        f"    mjcf=Path(__file__).with_name({_quoted(model_file)}),",
        f"    stance={_stance_text(stance, order, len(anatomy.kinds))},  # rad",
        f"    motors=MotorConfig({given}),",
        ")",
    ]
    return "\n".join(lines) + "\n"


def motor_kinds(anatomy: Anatomy) -> list[str]:
    """Return the field of `MotorConfig` for each joint of a leg."""
    kinds = {"roll": "abduction", "pitch": "hip"}
    return [*(kinds[kind] for kind in anatomy.kinds[:-1]), "knee"]


def _docstring(described: Description, source: str) -> str:
    shown = re.sub(r"[^\w ,.-]", "_", f"{robot_name(described.name)}, read from {source}")
    return f'"""{shown}. Edit an assumed number here; the model is in the file next to this one."""'


def _quoted(name: str) -> str:
    """Return a file's name as a Python string; a Chinese name stays readable."""
    return json.dumps(name, ensure_ascii=not name.isprintable())


def _stance_text(stance: Stance, order: Sequence[str], count: int) -> str:
    """Return the stance in the order of the joints, on one line if all legs have the same."""
    values = [stance.positions[name] + 0.0 for name in order]
    legs = [values[i : i + count] for i in range(0, len(values), count)]
    if all(leg == legs[0] for leg in legs):
        return f"{legs[0]} * 4"
    return "[" + ", ".join(repr(value) for value in values) + "]"
