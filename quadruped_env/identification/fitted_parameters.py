"""Parameters that can be fitted, by name: `delay`, or kind of joint and field of `JointMotor`, as in `hip.kp`."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import MotorConfig, Robot
from quadruped_env.utils.arrays import Floats

DELAY: Final = "delay"
MAX_FIT_DELAY: Final = 0.2
"""Maximum delay that the fit considers, s."""


@dataclass(frozen=True)
class Quantity:
    """Unit and scaling of a parameter in the fit."""

    unit: str
    scale: float
    """Typical value, in `unit`; divides the parameter so that all coordinates of the fit are near 1"""
    positive: bool = False
    """True if the parameter must not be 0"""
    torque: bool = True
    """True for torques and for torques per position or velocity"""


QUANTITIES: Final = {
    "stall_torque": Quantity("N m", 10.0, positive=True),
    "no_load_speed": Quantity("rad/s", 5.0, positive=True, torque=False),
    "kp": Quantity("N m/rad", 40.0, positive=True),
    "kd": Quantity("N m s/rad", 1.0),
    "damping": Quantity("N m s/rad", 0.1),
    "friction_loss": Quantity("N m", 0.1),
    "armature": Quantity("kg m^2", 0.01, positive=True, torque=False),
    DELAY: Quantity("s", 0.01, torque=False),
}
LOWEST: Final = 0.02
HIGHEST: Final = 50.0
"""Bounds of a coordinate, which keep the fit from diverging."""

FITTED: Final = ("stall_torque", "kp", "kd", "damping", "friction_loss", "armature", DELAY)
"""Parameters that are fitted by default. A no-load speed can be identified only from motion close to it."""


def names_of(fitted: Sequence[str], robot: Robot) -> list[str]:
    """Return names of the parameters of some quantities: one for each kind of joint, but only one delay.

    Raises:
        QuadrupedError: if a quantity is unknown.
    """
    for field in fitted:
        if field not in QUANTITIES:
            raise QuadrupedError(f"identify: cannot estimate {field!r}; valid names are {', '.join(QUANTITIES)}")
    kinds = robot.joints_by_kind
    return [name for field in fitted for name in ([DELAY] if field == DELAY else [f"{kind}.{field}" for kind in kinds])]


def quantity(name: str) -> Quantity:
    """Return the quantity of a parameter."""
    return QUANTITIES[name.rpartition(".")[2]]


def to_coordinates(values: Mapping[str, float]) -> dict[str, float]:
    """Return coordinates of the fit: scaled values, with torques relative to the armature if that is fitted too.

    Positions and velocities hardly change when all torques and the armature grow by the same factor. In these
    coordinates that is the direction of one axis instead of a narrow valley across all axes.
    """
    return {name: value / quantity(name).scale / _armature(name, values) for name, value in values.items()}


def from_coordinates(coordinates: Mapping[str, float]) -> dict[str, float]:
    """Return the inverse of `to_coordinates`."""
    armatures = {
        name: value * quantity(name).scale for name, value in coordinates.items() if name.endswith(".armature")
    }
    return {name: value * quantity(name).scale * _armature(name, armatures) for name, value in coordinates.items()}


def coordinate_derivatives(values: Mapping[str, float]) -> Floats:
    """Return derivatives of the coordinates with respect to the values, (n, n)."""
    names = list(values)
    coordinates = to_coordinates(values)
    derivatives = np.diag([1.0 / quantity(name).scale / _armature(name, values) for name in names])
    for i, name in enumerate(names):
        armature = f"{name.rpartition('.')[0]}.armature"
        if quantity(name).torque and armature in values:
            derivatives[i, names.index(armature)] = -coordinates[name] / values[armature]
    return derivatives


def _armature(name: str, values: Mapping[str, float]) -> float:
    """Return the armature by which a torque is divided, in units of its scale; 1 for other quantities."""
    armature = f"{name.rpartition('.')[0]}.armature"
    if not quantity(name).torque or armature not in values:
        return 1.0
    return values[armature] / QUANTITIES["armature"].scale


def value_of(motors: MotorConfig, name: str) -> float:
    """Return the value of a parameter of some motors."""
    kind, _, field = name.rpartition(".")
    return float(getattr(motors.of_joints([kind])[0] if kind else motors, field))


def with_values(motors: MotorConfig, values: Mapping[str, float]) -> MotorConfig:
    """Return the motors with some parameters changed."""
    changes: dict[str, Any] = {}
    for name, value in values.items():
        kind, _, field = name.rpartition(".")
        if kind:
            changes[kind] = replace(changes.get(kind) or motors.of_joints([kind])[0], **{field: value})
        else:
            changes[field] = value
    return replace(motors, **changes)
