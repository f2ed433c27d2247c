"""Dimensions, masses, limits and motors of a quadruped with two joints per leg, and what follows from them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.motors import JOINT_KINDS, MotorConfig
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.parameters import is_quantity
from quadruped_env.utils.plain import PlainFields

LEGS: Final = ("LF", "RF", "LH", "RH")
"""Names of the legs: left (L) or right (R), front (F) or hind (H)."""

_OF_THE_LINKS: Final[Any] = None
"""Default of the angles that follow from the links."""
_STANCE_HIP: Final = 0.6
"""Angle of the hip in a stance that follows from the links, rad."""

_LENGTHS: Final = ("hip_radius", "leg_radius", "leg_length", "hip_to_knee", "base_mass", "hip_mass", "leg_mass")


@dataclass(frozen=True)
class QuadrupedDimensions(PlainFields):
    """A box with four legs, each with a hip and a knee that turn about the y axis.

    The defaults are the built-in robot. Its geometry, joint order and limits come from the ROS 2 tutorial that this
    project is based on, its masses are this project's budget (assets/mini_quadruped/README.md). Units: m, kg, rad, N m.
    """

    name: str = "mini_quadruped"
    leg_names: tuple[str, ...] = LEGS
    """Order of the legs, and so of all joints, in every array."""
    base_size: tuple[float, float, float] = (0.30, 0.15, 0.08)
    """Size of the base along x, y and z, m."""
    hip_offset: tuple[float, float] = (0.15, 0.10)
    """Distance of the hips from the base's centre, forward and sideways, m."""
    hip_radius: float = 0.03
    hip_to_knee: float = 0.03
    """Distance of the knee's axis below the hip's, m."""
    leg_radius: float = 0.02
    """Radius of the lower leg, and of the ball at its end, m."""
    leg_length: float = 0.16
    """Length of the lower leg from the knee's axis to the sole, m."""
    base_mass: float = 2.2
    hip_mass: float = 0.25
    leg_mass: float = 0.20
    hip_range: tuple[float, float] = (-1.5, 1.5)
    knee_range: tuple[float, float] = (-2.0, 0.0)
    stance_angles: tuple[float, float] = _OF_THE_LINKS
    """Hip and knee in the stance, rad. None: the hip at 0.6, and the knee so that the foot is under it, to 0.01."""
    friction: float = 0.8
    """Coefficient of sliding friction of all surfaces."""
    motors: MotorConfig = field(default_factory=MotorConfig)

    def __post_init__(self) -> None:
        super().__post_init__()
        if not (isinstance(self.name, str) and self.name.isidentifier()):
            raise _error("name", self.name, "letters, digits and underscores, not beginning with a digit")
        if not isinstance(self.leg_names, tuple) or sorted(self.leg_names) != sorted(LEGS):
            raise _error("leg_names", self.leg_names, f"{', '.join(LEGS)} in any order")
        for name, length in (("base_size", 3), ("hip_offset", 2)):
            values = getattr(self, name)
            if not (_are_numbers(values, length) and min(values) > 0):
                raise _error(name, values, f"{length} positive numbers (m)")
        for name in (*_LENGTHS, "friction"):
            if not (is_quantity(getattr(self, name)) and getattr(self, name) > 0):
                raise _error(name, getattr(self, name), "a positive number")
        if self.leg_length <= 2.0 * self.leg_radius:
            raise _error("leg_length", self.leg_length, f"longer than twice leg_radius ({self.leg_radius:g} m)")
        if self.hip_offset[1] - self.leg_radius <= 0.5 * self.base_size[1]:
            raise _error(
                "hip_offset",
                self.hip_offset,
                "so far out that the legs clear the base: they are not checked to collide",
            )
        if not isinstance(self.motors, MotorConfig):
            raise _error("motors", self.motors, "a MotorConfig")
        derived = self.stance_angles is None
        if derived:
            object.__setattr__(self, "stance_angles", self._stance_under_hip())
        if not _are_numbers(self.stance_angles, 2):
            raise _error("stance_angles", self.stance_angles, "two numbers (rad)")
        self._check_ranges("; these follow from the links, so give others" if derived else "")

    def _stance_under_hip(self) -> tuple[float, float]:
        """Hip and knee with the foot under the hip, rad."""
        offset = self.hip_to_knee * math.sin(_STANCE_HIP) / -self.foot_height
        if offset > 1.0:
            raise _error(
                "stance_angles", None, f"given: with the hip at {_STANCE_HIP} rad the foot does not reach under it"
            )
        return _STANCE_HIP, round(-_STANCE_HIP - math.asin(offset), 2)

    def _check_ranges(self, origin: str) -> None:
        for kind, angle in zip(JOINT_KINDS, self.stance_angles, strict=True):
            limits = getattr(self, f"{kind}_range")
            if not (_are_numbers(limits, 2) and limits[0] < limits[1]):
                raise _error(f"{kind}_range", limits, "a pair (low, high) with low < high (rad)")
            if not limits[0] < angle < limits[1]:
                raise _error("stance_angles", self.stance_angles, f"within {kind}_range {limits}{origin}")

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Names of the joints, in the order of every array."""
        return tuple(f"{leg}_{kind}_joint" for leg in self.leg_names for kind in JOINT_KINDS)

    @property
    def link_names(self) -> tuple[str, ...]:
        """Names of the links, the base first."""
        return ("base_link", *(f"{leg}_{link}" for leg in self.leg_names for link in ("hip", "leg")))

    @property
    def foot_height(self) -> float:
        """Height of the centre of a foot's ball in the frame of its leg, m; it is negative."""
        return -(self.leg_length - self.leg_radius)

    @property
    def stance_height(self) -> float:
        """Height of the base's centre in the stance, with the feet on the ground, rounded to 0.1 um, m."""
        hip, knee = self.stance_angles
        height = self.hip_to_knee * math.cos(hip) - self.foot_height * math.cos(hip + knee) + self.leg_radius
        return round(height, 7)

    def hip_position(self, leg: str) -> tuple[float, float]:
        """Position (x, y) of a hip in the base frame, m."""
        x, y = self.hip_offset
        return (x if leg[1] == "F" else -x, y if leg[0] == "L" else -y)

    @property
    def base_inertia(self) -> Floats:
        """Principal moments of inertia of the base, a homogeneous box, about its centre (3,), kg m^2."""
        x, y, z = self.base_size
        return self.base_mass / 12.0 * np.array([y * y + z * z, x * x + z * z, x * x + y * y])

    @property
    def hip_inertia(self) -> Floats:
        """Principal moments of inertia of a hip, a homogeneous ball, about its centre (3,), kg m^2."""
        return np.full(3, 0.4 * self.hip_mass * self.hip_radius * self.hip_radius)

    @property
    def leg_inertia(self) -> Floats:
        """Principal moments of inertia of a lower leg, a homogeneous cylinder, about its centre (3,), kg m^2."""
        mass, radius, length = self.leg_mass, self.leg_radius, self.leg_length
        transverse = mass / 12.0 * (3.0 * radius * radius + length * length)
        return np.array([transverse, transverse, 0.5 * mass * radius * radius])


def _are_numbers(values: Any, length: int) -> bool:
    return isinstance(values, Sequence) and len(values) == length and all(is_quantity(value) for value in values)


def _error(name: str, value: Any, rule: str) -> QuadrupedError:
    return QuadrupedError(f"QuadrupedDesign: {name} must be {rule}; found {short(value)}")
