"""Motors of a robot: torque and speed of the file where they are plausible, all else by the robot's size."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from quadruped_env.importer.description import Description, Link, poses
from quadruped_env.importer.legs import Anatomy
from quadruped_env.importer.stance import Stance
from quadruped_env.robot import JointMotor

GRAVITY: Final = 9.81
"""Gravity, m/s^2."""
_MAX_EFFORT: Final = 1000.0
"""Torque from which on a file's is no motor's, N m."""
_MAX_SPEED: Final = 100.0
"""Speed from which on a file's is no motor's, rad/s."""
_TORQUE: Final = 1.4
"""Assumed stall torque, in m g L, as the built-in robot's."""
_SPEED: Final = 4.0
"""Assumed no-load speed, in sqrt(g / L)."""
_KP: Final = 6.0
"""Assumed position gain, in m g L per rad: in a trot, on two feet, a joint gives way by about 0.1 rad."""
_ARMATURE: Final = 0.074
"""Assumed rotor inertia at the joint, in m L^2, as the built-in robot's."""
_DAMPING_RATIO: Final = 0.8
"""Assumed damping ratio of rotor and leg about the joint."""
_FRICTION: Final = 0.02
"""Assumed damping of bearings and gears, relative to the velocity gain."""


@dataclass(frozen=True)
class AssumedMotor:
    """A motor, with the source of each number."""

    field: str
    """Field of `MotorConfig`: `abduction`, `hip` or `knee`."""
    values: dict[str, tuple[float, str]]
    """Number and its comment, for each field of `JointMotor`."""

    def motor(self) -> JointMotor:
        """Return the motor."""
        return JointMotor(**{name: value for name, (value, _) in self.values.items()})


def assumed_motors(
    described: Description, anatomy: Anatomy, stance: Stance, bodies: Sequence[Link]
) -> list[AssumedMotor]:
    """Return the motor of each joint of a leg, from the base to the foot."""
    mass, height = sum(body.mass for body in bodies), stance.height
    size = f"m {mass:.4g} kg, L {height:.4g} m"
    weight = mass * GRAVITY * height
    swung = max(_swung(bodies, leg.names) for leg in anatomy.legs)
    assumed: set[str] = set()
    motors = []
    fields = [{"roll": "abduction", "pitch": "hip"}[kind] for kind in anatomy.kinds[:-1]] + ["knee"]
    for place, field in enumerate(fields):
        joints = [leg.joints[place] for leg in anatomy.legs]

        def number(name: str, most: float, otherwise: float, unit: str, law: str) -> tuple[float, str]:
            given = [getattr(joint, name) for joint in joints]  # noqa: B023
            fit = [value for value in given if value is not None and 0.0 < value < most]
            if len(fit) == len(given):
                return round_to(min(fit)), f"{unit}, of the file"
            found = "none" if not any(value is not None for value in given) else f"{max(v or 0.0 for v in given):g}"
            assumed.add(f"{name} {round_to(otherwise):g} {unit} (the file: {found})")
            return round_to(otherwise), f"{unit}, assumed: {law}; the file: {found}"

        torque = number("effort", _MAX_EFFORT, _TORQUE * weight, "N m", f"{_TORQUE} m g L, {size}")
        speed = number("speed", _MAX_SPEED, _SPEED * math.sqrt(GRAVITY / height), "rad/s", f"{_SPEED:g} sqrt(g / L)")
        kp = round_to(_KP * weight)
        given = [joint.armature for joint in joints]
        armature = (
            (round_to(min(given)), "kg m^2, of the file")
            if min(given) > 0.0
            else (round_to(_ARMATURE * mass * height**2), f"kg m^2, assumed: {_ARMATURE} m L^2")
        )
        kd = round_to(2.0 * _DAMPING_RATIO * math.sqrt(kp * (armature[0] + swung)))
        motors.append(
            AssumedMotor(
                field,
                {
                    "stall_torque": torque,
                    "no_load_speed": speed,
                    "kp": (kp, f"N m/rad, assumed: {_KP:g} m g L, {size}"),
                    "kd": (kd, f"N m s/rad, assumed: damping ratio {_DAMPING_RATIO} of rotor and straight leg"),
                    "damping": (round_to(_FRICTION * kd), f"N m s/rad, assumed: {_FRICTION} kd"),
                    "armature": armature,
                },
            )
        )
    for text in sorted(assumed):
        described.add("assumed", "motors", text)
    gains = ", ".join(dict.fromkeys(f"{motor.values['kp'][0]:g}" for motor in motors))
    described.add(
        "assumed", "motors", f"kp {gains} N m/rad: {_KP:g} m g L, {size}; kd for a damping ratio of {_DAMPING_RATIO}"
    )
    return motors


def _swung(bodies: Sequence[Link], names: Sequence[str]) -> float:
    """Return the largest inertia about a joint of a leg of all that the joint moves, with the joints at 0, kg m^2."""
    leg = [i for i, body in enumerate(bodies) if body.joint.name in names]
    places, rotations = poses(bodies)
    largest = 0.0
    for k, first in enumerate(leg):
        axis, total = rotations[first] @ bodies[first].joint.axis, 0.0
        for i in leg[k:]:
            body, own = bodies[i], rotations[i].T @ axis
            off = np.cross(axis, places[i] + rotations[i] @ body.centre - places[first])
            total += float(own @ body.inertia @ own) + body.mass * float(off @ off)
        largest = max(largest, total)
    return largest


def round_to(value: float, digits: int = 3) -> float:
    """Return a number with some significant digits."""
    return float(f"{value:.{digits}g}")
