"""Terrains of the tests, and heights that do not come from the package's lookup."""

import math

import mujoco
import numpy as np

from quadruped_env.task import terrain

_GROUND_ONLY = np.array([1, 0, 0, 0, 0, 0], np.uint8)


@terrain(size=8.0)
def slope(grid, angle: float = 0.2, direction: float = 0.0):
    """Plane that rises at an angle (rad) towards a direction (rad)."""
    return math.tan(angle) * (grid.x * math.cos(direction) + grid.y * math.sin(direction))


@terrain(size=8.0)
def level_field(grid):
    """Level ground, but for one corner, so that it is a height field."""
    heights = np.zeros_like(grid.x)
    heights[0, 0] = 0.01
    return heights


@terrain(size=8.0)
def platform(grid):
    """Level ground at a height of 5 cm, but for one corner."""
    heights = np.full_like(grid.x, 0.05)
    heights[0, 0] = 0.06
    return heights


def ray_heights(model, points):
    """Height of the ground at points (N, 2), from rays."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    geom = np.zeros((1, 1), dtype=np.int32)
    down = [0.0, 0.0, -1.0]
    return [3.0 - mujoco.mj_ray(model, data, [*point, 3.0], down, _GROUND_ONLY, 1, -1, geom, None) for point in points]
