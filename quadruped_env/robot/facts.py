"""Geometry, masses and limits of the robot, all defined here.

Geometry, joint order and limits come from the ROS 2 tutorial that this project is based on. Masses are this project's
budget (assets/mini_quadruped/README.md); inertia follows from mass and shape. The URDF and the MJCF repeat these values
in their formats, and the tests check that all three agree.

Units: m, kg, kg m^2, rad, rad/s, N m.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

LEG_NAMES: Final = ("LF", "RF", "LH", "RH")
"""Names of the legs: left (L) or right (R), front (F) or hind (H)."""

JOINT_NAMES: Final = tuple(f"{leg}_{joint}_joint" for leg in LEG_NAMES for joint in ("hip", "knee"))
"""Names of the eight joints, in the order of every array in this package."""

LINK_NAMES: Final = ("base_link", *(f"{leg}_{link}" for leg in LEG_NAMES for link in ("hip", "leg")))

BASE_SIZE: Final = (0.30, 0.15, 0.08)
HIP_RADIUS: Final = 0.03
LEG_RADIUS: Final = 0.02
LEG_LENGTH: Final = 0.16
FOOT_RADIUS: Final = LEG_RADIUS
HIP_TO_KNEE: Final = 0.03
HIP_POSITIONS: Final = {"LF": (0.15, 0.10), "RF": (0.15, -0.10), "LH": (-0.15, 0.10), "RH": (-0.15, -0.10)}
"""Position (x, y) of each hip in the base frame, m."""

BASE_MASS: Final = 2.2
HIP_MASS: Final = 0.25
LEG_MASS: Final = 0.20
TOTAL_MASS: Final = BASE_MASS + len(LEG_NAMES) * (HIP_MASS + LEG_MASS)

HIP_RANGE: Final = (-1.5, 1.5)
KNEE_RANGE: Final = (-2.0, 0.0)
EFFORT_LIMIT: Final = 10.0
VELOCITY_LIMIT: Final = 5.0


def _read_only(values: object) -> NDArray[np.float64]:
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array


JOINT_POSITION_LOW: Final = _read_only([HIP_RANGE[0], KNEE_RANGE[0]] * len(LEG_NAMES))
JOINT_POSITION_HIGH: Final = _read_only([HIP_RANGE[1], KNEE_RANGE[1]] * len(LEG_NAMES))

STANCE: Final = _read_only([0.6, -0.72] * len(LEG_NAMES))
"""Joint positions with each foot under its hip and the knees near the middle of their range (8,), rad."""

STANCE_HEIGHT: Final = 0.1837533
"""Height of the base's centre in the stance, with the feet on the ground, m."""


def solid_box_inertia(mass: float, size: tuple[float, float, float]) -> NDArray[np.float64]:
    """Principal moments of inertia (3,) of a homogeneous box about its centre."""
    x, y, z = size
    return mass / 12.0 * np.array([y * y + z * z, x * x + z * z, x * x + y * y])


def solid_sphere_inertia(mass: float, radius: float) -> NDArray[np.float64]:
    """Principal moments of inertia (3,) of a homogeneous ball about its centre."""
    return np.full(3, 0.4 * mass * radius * radius)


def solid_cylinder_inertia(mass: float, radius: float, length: float) -> NDArray[np.float64]:
    """Principal moments of inertia (3,) of a homogeneous cylinder along z about its centre."""
    transverse = mass / 12.0 * (3.0 * radius * radius + length * length)
    return np.array([transverse, transverse, 0.5 * mass * radius * radius])
