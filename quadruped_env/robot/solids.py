"""Inertia of homogeneous solids."""

import numpy as np
from numpy.typing import NDArray


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
