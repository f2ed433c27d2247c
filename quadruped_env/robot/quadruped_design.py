"""Builder of quadrupeds with two joints per leg: the built-in robot, and others with other numbers."""

import math
from dataclasses import dataclass, field
from typing import Annotated, Any, Final

import numpy as np

from quadruped_env.robot import quadruped_files
from quadruped_env.robot.motors import JOINT_KINDS, MotorConfig
from quadruped_env.robot.robot import CORNERS, Robot
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.fields import Fields, Range, check
from quadruped_env.utils.parameters import Parameter, is_quantity
from quadruped_env.utils.plain import Plain, plain

_OF_THE_LINKS: Final[Any] = None
"""Default of the angles that follow from the links."""
_STANCE_HIP: Final = 0.6
"""Angle of the hip in a stance that follows from the links, rad."""

Length = Annotated[float, Parameter.positive("m")]
Mass = Annotated[float, Parameter.positive("kg")]


def _lengths(value: Plain, path: str) -> tuple[float, ...]:
    """Convert to two or three lengths in m, as many as the field's default has."""
    count = 3 if path.endswith("base_size") else 2
    check(_are_numbers(value, count) and min(value) > 0, path, value, f"{count} positive numbers (m)")
    return tuple(map(float, value))


def _angles(value: Plain, path: str) -> tuple[float, float] | None:
    check(value is None or _are_numbers(value, 2), path, value, "two numbers (rad)")
    return None if value is None else (float(value[0]), float(value[1]))


def _legs(value: Plain, path: str) -> tuple[str, ...]:
    names = plain(value)
    valid = isinstance(names, list) and sorted(map(str, names)) == sorted(CORNERS)
    check(valid, path, value, f"{', '.join(CORNERS)} in any order")
    return tuple(names)


@dataclass(frozen=True)
class QuadrupedDesign(Fields, path="QuadrupedDesign"):
    """Dimensions of a box with four legs, each with a hip and a knee that turn about the y axis, and its robot.

    ROBOT = QuadrupedDesign(name="long_legs", leg_length=0.22, leg_mass=0.3).robot()

    The defaults are the built-in robot. Its geometry, joint order and limits come from the ROS 2 tutorial that this
    project is based on, its masses are this project's budget (assets/mini_quadruped/README.md). Units: m, kg, rad, N m.
    """

    name: str = "mini_quadruped"
    leg_names: Annotated[tuple[str, ...], _legs] = CORNERS
    """Order of the legs, and so of all joints, in every array."""
    base_size: Annotated[tuple[float, float, float], _lengths] = (0.30, 0.15, 0.08)
    """Size of the base along x, y and z, m."""
    hip_offset: Annotated[tuple[float, float], _lengths] = (0.15, 0.10)
    """Distance of the hips from the base's centre, forward and sideways, m."""
    hip_radius: Length = 0.03
    hip_to_knee: Length = 0.03
    """Distance of the knee's axis below the hip's, m."""
    leg_radius: Length = 0.02
    """Radius of the lower leg, and of the ball at its end, m."""
    leg_length: Length = 0.16
    """Length of the lower leg from the knee's axis to the sole, m."""
    base_mass: Mass = 2.2
    hip_mass: Mass = 0.25
    leg_mass: Mass = 0.20
    hip_range: Annotated[Range, Parameter("rad")] = (-1.5, 1.5)
    knee_range: Annotated[Range, Parameter("rad")] = (-2.0, 0.0)
    stance_angles: Annotated[tuple[float, float], _angles] = _OF_THE_LINKS
    """Hip and knee in the stance, rad. None: the hip at 0.6, and the knee so that the foot is under it, to 0.01."""
    friction: Annotated[float, Parameter.positive()] = 0.8
    """Coefficient of sliding friction of all surfaces."""
    motors: MotorConfig = field(default_factory=MotorConfig)

    def __post_init__(self) -> None:
        super().__post_init__()
        name, reach = self.name, self.hip_offset[1] - self.leg_radius
        valid = isinstance(name, str) and name.isidentifier()
        self._check(valid, "name", "letters, digits and underscores, not beginning with a digit")
        thick = f"longer than twice leg_radius ({self.leg_radius:g} m)"
        self._check(self.leg_length > 2.0 * self.leg_radius, "leg_length", thick)
        clear = "so far out that the legs clear the base: they are not checked to collide"
        self._check(reach > 0.5 * self.base_size[1], "hip_offset", clear)
        origin = ""
        if self.stance_angles is None:
            origin = "; these follow from the links, so give others"
            object.__setattr__(self, "stance_angles", self._stance_under_hip())
        for kind, angle in zip(JOINT_KINDS, self.stance_angles, strict=True):
            low, high = getattr(self, f"{kind}_range")
            self._check(low < angle < high, "stance_angles", f"within {kind}_range {(low, high)}{origin}")

    def _check(self, condition: bool, name: str, rule: str) -> None:
        check(condition, f"{type(self).path}.{name}", getattr(self, name), rule)

    def _stance_under_hip(self) -> tuple[float, float]:
        """Return hip and knee with the foot under the hip, rad."""
        offset = self.hip_to_knee * math.sin(_STANCE_HIP) / -self.foot_height
        reaches = f"given: with the hip at {_STANCE_HIP} rad the foot does not reach under it"
        self._check(offset <= 1.0, "stance_angles", reaches)
        return _STANCE_HIP, round(-_STANCE_HIP - math.asin(offset), 2)

    def robot(self) -> Robot:
        """Return the robot, with its MJCF and its URDF."""
        return Robot(
            name=self.name,
            stance=np.tile(self.stance_angles, len(self.leg_names)),
            stance_height=self.stance_height,
            sensors=_sensors(self.joint_names, self.leg_names),
            motors=self.motors,
            mjcf=quadruped_files.mjcf(self),
            urdf=quadruped_files.urdf(self),
        )

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Names of the joints, in the order of every array."""
        return tuple(f"{leg}_{kind}_joint" for leg in self.leg_names for kind in JOINT_KINDS)

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
        """Return the position (x, y) of a hip in the base frame, m."""
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
    return (
        isinstance(values, list | tuple | np.ndarray) and len(values) == length and all(map(is_quantity, plain(values)))
    )


def _sensors(joint_names: tuple[str, ...], legs: tuple[str, ...]) -> dict[str, tuple[str, ...]]:
    """Return the sensors of the MJCF for each field of `Readings`, in order."""
    joints = [name.removesuffix("_joint") for name in joint_names]
    return {
        "joint_position": tuple(f"{joint}_position" for joint in joints),
        "joint_velocity": tuple(f"{joint}_velocity" for joint in joints),
        "joint_torque": tuple(f"{joint}_torque" for joint in joints),
        "orientation": ("imu_orientation",),
        "angular_velocity_b": ("imu_angular_velocity",),
        "linear_acceleration_b": ("imu_linear_acceleration",),
        "foot_force": tuple(f"{leg}_foot_force" for leg in legs),
        "trunk_force": ("base_contact_force", *(f"{leg}_hip_contact_force" for leg in legs)),
        "base_position": ("base_position",),
        "up_b": ("world_up",),
        "linear_velocity_b": ("base_linear_velocity",),
        "foot_position": tuple(f"{leg}_foot_position" for leg in legs),
        "foot_velocity": tuple(f"{leg}_foot_velocity" for leg in legs),
        "foot_angular_velocity": tuple(f"{leg}_foot_angular_velocity" for leg in legs),
    }
