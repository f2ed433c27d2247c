"""Model files of a `QuadrupedDesign`: MJCF for MuJoCo and URDF for ROS, from the files in `templates/`.

assets/mini_quadruped/README.md explains the choices for motors, contacts, sensors and the solver.
"""

import functools
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING, Final

from quadruped_env.robot.motors import GEAR_RATIO, JOINT_KINDS, VOLTAGE, JointMotor

if TYPE_CHECKING:
    from quadruped_env.robot.quadruped_design import QuadrupedDesign

_FRONT_SHARE: Final = 0.1
"""Length of the mark at the front of the base, relative to the base."""
_PROUD: Final = 0.001
"""Distance by which the mark stands out from the base, so that it is drawn in front of it, m."""
_TOUCH_MARGIN: Final = 0.005
"""Distance by which the zone of a touch sensor is larger than the surface it watches, m; twice that for the base."""


def mjcf(design: "QuadrupedDesign") -> str:
    """Return the robot alone: bodies, joints, motors, sensors, home keyframe; the ground is in scene.xml."""
    values, legs, joints = _values(design), design.leg_names, design.joint_names
    pairs = [[leg for leg in legs if leg[0] == side] for side in sorted({leg[0] for leg in legs})]
    short = {name.removesuffix("_joint"): name for name in joints}
    return filled(
        "robot.xml",
        values,
        legs=_legs("leg.xml", design, values, "\n"),
        pairs=_join(f'    <pair geom1="{a}_leg_collision" geom2="{b}_leg_collision" condim="1"/>' for a, b in pairs),
        motors=_join(f'    <dcmotor name="{name}" joint="{name}" class="{_kind(name)}"/>' for name in joints),
        joint_positions=_join(f'    <jointpos name="{key}_position" joint="{name}"/>' for key, name in short.items()),
        joint_velocities=_join(f'    <jointvel name="{key}_velocity" joint="{name}"/>' for key, name in short.items()),
        joint_torques=_join(f'    <actuatorfrc name="{key}_torque" actuator="{name}"/>' for key, name in short.items()),
        foot_forces=_join(f'    <touch name="{leg}_foot_force" site="{leg}_foot"/>' for leg in legs),
        hip_forces=_join(f'    <touch name="{leg}_hip_contact_force" site="{leg}_hip_touch"/>' for leg in legs),
        foot_positions=_foot_sensors("framepos", legs, "position"),
        foot_velocities=_foot_sensors("framelinvel", legs, "velocity"),
        foot_angular_velocities=_foot_sensors("frameangvel", legs, "angular_velocity"),
        stance="  ".join(numbers(*design.stance_angles) for _ in legs),
    )


def urdf(design: "QuadrupedDesign") -> str:
    """Return the robot for ROS and other simulators: links, joints, limits, inertia, collision, and its drives."""
    values = _values(design)
    motors = design.motors.of_joints([_kind(name) for name in design.joint_names])
    ranges = [getattr(design, f"{_kind(name)}_range") for name in design.joint_names]
    return filled(
        "robot.urdf",
        values,
        legs=_legs("leg.urdf", design, values, "\n\n"),
        drives=drives(design.name, design.joint_names, ranges, motors),
    )


def drives(
    name: str, joint_names: Sequence[str], ranges: Iterable[Sequence[float]], motors: Iterable[JointMotor]
) -> str:
    """Return a URDF's transmissions for Drake, and its system for ros2_control; ranges of the joints in rad."""
    values = [
        {
            "joint": joint,
            "low": numbers(low),
            "high": numbers(high),
            "kp": numbers(motor.kp),
            "kd": numbers(motor.kd),
            "rotor_inertia": numbers(motor.rotor_inertia),
            "gear_ratio": numbers(GEAR_RATIO),
        }
        for joint, (low, high), motor in zip(joint_names, ranges, motors, strict=True)
    ]
    return filled(
        "drives.urdf",
        {"name": name},
        transmissions=_join(filled("transmission.urdf", drive).rstrip() for drive in values),
        control_joints=_join(filled("control_joint.urdf", drive).rstrip() for drive in values),
        control_transmissions=_join(filled("control_transmission.urdf", drive).rstrip() for drive in values),
    ).rstrip()


def filled(name: str, values: Mapping[str, str], **more: str) -> str:
    """Return the text of a template with its `${names}` replaced by values."""
    return _template(name).substitute(values, **more)


@functools.cache
def _template(name: str) -> Template:
    return Template((Path(__file__).parent / "templates" / name).read_text(encoding="utf-8"))


def numbers(*values: float) -> str:
    """Return numbers with spaces between, and 15 digits, enough for dimensions that are given as decimals."""
    return " ".join(f"{float(value) + 0.0:.15g}" for value in values)  # + 0.0 turns -0.0 into 0.0


def _values(design: "QuadrupedDesign") -> dict[str, str]:
    """Return the numbers of the whole robot and of each of its legs, by their names in the templates."""
    length, width, height = design.base_size
    front = _FRONT_SHARE * length + _PROUD, width + 2.0 * _PROUD, height + 2.0 * _PROUD
    values = {
        "name": design.name,
        "friction": numbers(design.friction, 0.005, 0.0001),
        "voltage": numbers(VOLTAGE),
        "stance_height": numbers(design.stance_height),
        "base_size": numbers(*design.base_size),
        "base_half": _half(design.base_size),
        "base_touch": _half(design.base_size, 2.0 * _TOUCH_MARGIN),
        "front_size": numbers(*front),
        "front_half": _half(front),
        "front": numbers(0.5 * (length - front[0]) + _PROUD, 0, 0),
        "hip_radius": numbers(design.hip_radius),
        "hip_touch": numbers(design.hip_radius + _TOUCH_MARGIN),
        "knee": numbers(0, 0, -design.hip_to_knee),
        "leg_radius": numbers(design.leg_radius),
        "leg_centre": numbers(0, 0, -0.5 * design.leg_length),
        "collision_top": numbers(0, 0, -design.leg_radius),
        "cylinder_length": numbers(design.leg_length - 2.0 * design.leg_radius),
        "shank_length": numbers(-design.foot_height),
        "shank_centre": numbers(0, 0, 0.5 * design.foot_height),
        "foot": numbers(0, 0, design.foot_height),
        "foot_touch": numbers(design.leg_radius + _TOUCH_MARGIN),
    }
    for part in ("base", "hip", "leg"):
        inertia = getattr(design, f"{part}_inertia")
        values |= {f"{part}_mass": numbers(getattr(design, f"{part}_mass")), f"{part}_inertia": numbers(*inertia)}
        values |= {
            f"{part}_{name}": numbers(moment) for name, moment in zip(("ixx", "iyy", "izz"), inertia, strict=True)
        }
    for kind, motor in zip(JOINT_KINDS, design.motors.of_joints(JOINT_KINDS), strict=True):
        low, high = getattr(design, f"{kind}_range")
        own = {
            "low": low,
            "high": high,
            "effort": motor.stall_torque,
            "velocity": motor.no_load_speed,
            "kp": motor.kp,
            "kd": motor.kd,
            "damping": motor.damping,
            "friction": motor.friction_loss,
            "armature": motor.armature,
        }
        values |= {f"{kind}_{name}": numbers(value) for name, value in own.items()}
        friction = f' frictionloss="{numbers(motor.friction_loss)}"' if motor.friction_loss else ""
        values[f"{kind}_frictionloss"] = friction
    return values


def _legs(name: str, design: "QuadrupedDesign", values: Mapping[str, str], between: str) -> str:
    places = {leg: numbers(*design.hip_position(leg), 0) for leg in design.leg_names}
    return between.join(filled(name, values, leg=leg, hip=place).rstrip() for leg, place in places.items())


def _join(lines: Iterable[str]) -> str:
    return "\n".join(lines)


def _kind(joint: str) -> str:
    return next(kind for kind in JOINT_KINDS if f"_{kind}_" in joint)


def _half(size: Sequence[float], margin: float = 0.0) -> str:
    return numbers(*(0.5 * length + margin for length in size))


def _foot_sensors(kind: str, legs: Sequence[str], reading: str) -> str:
    return _join(f'    <{kind} name="{leg}_foot_{reading}" objtype="site" objname="{leg}_foot"/>' for leg in legs)
