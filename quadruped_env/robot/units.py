"""Size of a robot in the units that follow from its leg length L, its mass m and gravity g.

Motions of two robots are similar if their lengths are in proportion to L, speeds to sqrt(g L), times to sqrt(L / g),
forces to m g. So a number that suits the built-in robot suits another one after multiplication by `scale_of` its unit.
"""

import functools
import re
from collections.abc import Mapping
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.plain import Plain

_EXPONENTS: Final = {
    "1": (0.0, 0.0),
    "rad": (0.0, 0.0),
    "kg": (1.0, 0.0),
    "m": (0.0, 1.0),
    "s": (0.0, 0.5),
    "Hz": (0.0, -0.5),
    "N": (1.0, 0.0),
    "W": (1.0, 0.5),
}
"""Exponents of mass and leg length in each unit, with the same gravity."""
_FACTOR: Final = re.compile(r"(?P<over>/?) *(?:\((?P<inner>[^()]+)\)|(?P<name>[A-Za-z]+|1))(?:\^(?P<power>\d+))? *")


def scale_of(unit: str, robot: Robot) -> float:
    """Return the size of a unit for a robot relative to the built-in robot; exactly 1 for the latter.

    Args:
        unit: such as `m/s`, `rad/s`, `N m` or `1/(m^2/s^2)`. Of several units, separated by commas, the first counts.
        robot: its leg length is the height of its base in the stance.

    Raises:
        QuadrupedError: if the unit is unknown.
    """
    mass, length = _sizes(robot)
    of_mass, of_length = _exponents(unit.partition(",")[0])
    return float(mass**of_mass * length**of_length)


@functools.lru_cache(maxsize=64)
def steadiness(robot: Robot) -> float:
    """Return how steady a robot stands on its feet, relative to the built-in robot; at most 1.

    A rigid robot whose centre of mass is at a height h, and at a distance w from its outermost feet on one side, tips
    over them at a speed of w sqrt(g / h), and under a horizontal force of m g w / h. Of w / h on the four sides, the
    one that is the smallest part of the built-in robot's counts.
    """
    own, built_in = (_slopes(r) for r in (robot, MINI_QUADRUPED))
    return min(1.0, _rounded(float((own / built_in).min()), 3))


def _slopes(robot: Robot) -> Floats:
    """Return the distances from the centre of mass to the outermost feet of all four sides over its height (4,)."""
    x, y, z = robot.skeleton.centre_of_mass(robot.stance)
    feet = robot.stance_feet[:, :2]
    return np.concatenate([feet.max(axis=0) - (x, y), (x, y) - feet.min(axis=0)]) / (robot.stance_height + z)


@functools.lru_cache(maxsize=64)
def motor_heat(robot: Robot) -> float:
    """Return the heat in a robot's motors while they carry its weight, relative to the built-in robot; 1 or more.

    For the same torque a motor heats in proportion to its no-load speed, so a robot with faster motors, in its own
    units, pays more for the same gait.
    """
    own, built_in = (r.motors.joule_coefficients(r.joint_kinds).mean() for r in (robot, MINI_QUADRUPED))
    return max(1.0, _rounded(float(own / built_in) / scale_of("W/(N m)^2", robot), 3))


def scaled(value: Plain, factor: float, digits: int = 6) -> Plain:
    """Return a number, or each in a list or tuple, times a factor, rounded to some digits; a factor of 1 keeps it."""
    if isinstance(value, (list, tuple)):
        return type(value)(scaled(entry, factor, digits) for entry in value)
    if factor == 1.0 or isinstance(value, bool) or not isinstance(value, (int, float)):
        return value
    return _rounded(value * factor, digits)


def scaled_values(values: Mapping[str, Plain], units: Mapping[str, Plain], robot: Robot) -> dict[str, Plain]:
    """Return nested values for the built-in robot in the units of another one.

    Args:
        values: numbers, ranges and other values by name, nested.
        units: their units, or factors for the other robot, nested in the same way; a value without one is unchanged.
        robot: the other robot.
    """
    result: dict[str, Plain] = {}
    for name, value in values.items():
        unit = units.get(name, "1")
        if isinstance(value, Mapping):
            result[name] = scaled_values(value, unit, robot) if isinstance(unit, Mapping) else dict(value)
        else:
            factor = unit if isinstance(unit, float) else None if isinstance(unit, Mapping) else scale_of(unit, robot)
            result[name] = value if factor is None else scaled(value, factor)
    return result


@functools.lru_cache(maxsize=64)
def _sizes(robot: Robot) -> tuple[float, float]:
    """Return the mass and leg length relative to the built-in robot."""
    own, built_in = ((r.total_mass, r.stance_height) for r in (robot, MINI_QUADRUPED))
    # Rounded like the heights themselves, so that half the size is one half.
    mass, length = (_rounded(x / y) for x, y in zip(own, built_in, strict=True))
    return mass, length


def _rounded(value: float, digits: int = 6) -> float:
    """Return a number with some significant digits."""
    return float(f"{value:.{digits}g}")


@functools.cache
def _exponents(unit: str) -> tuple[float, float]:
    """Return the exponents of mass and leg length in a unit."""
    mass = length = 0.0
    end = 0
    text = unit.strip() or "1"
    while end < len(text):
        match = _FACTOR.match(text, end)
        if match is None or match["name"] not in (None, *_EXPONENTS):
            raise QuadrupedError(f"unit {short(unit)}: expected products and powers of {', '.join(_EXPONENTS)}")
        own = _EXPONENTS[match["name"]] if match["name"] else _exponents(match["inner"])
        power = int(match["power"] or 1) * (-1.0 if match["over"] else 1.0)
        mass, length, end = mass + power * own[0], length + power * own[1], match.end()
    return mass, length
