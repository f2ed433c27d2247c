"""Built-in terrains: functions that give the heights of the ground around the start."""

import math
from collections.abc import Sequence
from typing import Annotated, Final

import numpy as np

from quadruped_env.errors import QuadrupedError, did_you_mean, short
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.simulation.terrain import ROUNDING, START, Grid, Terrain, Tiles, terrain
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.parameters import Parameter

HIGHEST: Final = 0.055
"""Height at the hardest level, m: 30 % of the built-in robot's leg length of 0.184 m."""
STEEPEST: Final = math.radians(20.0)
"""Slope at the hardest level, rad."""
FINE: Final = 0.05
"""Grid spacing of the terrains with edges, m. The side of a step is one cell wide."""
_LARGE: Final = 24.0
"""Side length of these terrains, m: a robot at 0.6 m/s walks for 18 s until it reaches the edge."""
_FLIGHT: Final = 3
"""Number of steps of a flight of stairs."""

Height = Annotated[float, Parameter("m", 0.0)]
Length = Annotated[float, Parameter("m", 0.2)]


@terrain(hardest={})
def flat(grid: Grid) -> Floats:
    """Level ground."""
    return np.zeros_like(grid.x)


@terrain(hardest={"height": HIGHEST})
def rough(grid: Grid, height: Height = 0.01, distance: Length = 0.2) -> Floats:
    """Bumps of up to 1 cm, 0.2 m apart."""
    return height * grid.smooth_noise(distance) * grid.fade


@terrain
def hills(grid: Grid, height: Height = 0.08, distance: Length = 2.5) -> Floats:
    """Hills of up to 8 cm, 2.5 m apart."""
    return height * grid.smooth_noise(distance) * grid.fade


@terrain(size=_LARGE, cell=FINE, hardest={"angle": STEEPEST})
def slope(
    grid: Grid,
    angle: Annotated[float, Parameter("rad", 0.0, math.radians(45.0))] = math.radians(10.0),
    length: Length = 2.0,
) -> Floats:
    """Slopes of 10 degrees up and down in turn, 2 m long, in squares around the start."""
    pairs = max(1, math.floor(grid.ring_end / (2.0 * length) + ROUNDING))
    # In a tile there is less space than that.
    cell = FINE * grid.scale
    cells = math.floor(min(length, 0.5 * grid.ring_end / pairs) / cell + ROUNDING)
    length = cells * cell
    ring = np.where(grid.inside(2.0 * pairs * length), grid.ring, 0.0)
    return grid.first * math.tan(angle) * (length - np.abs(length - ring % (2.0 * length)))


@terrain(size=_LARGE, cell=FINE, hardest={"height": HIGHEST})
def steps(grid: Grid, height: Height = 0.02, width: Length = 0.4) -> Floats:
    """Square blocks of 0.4 m, high by 2 cm and low in turn."""
    blocks = math.floor(grid.ring_end / width + ROUNDING)
    column, line = (np.floor((np.abs(along) - START * grid.scale) / width + ROUNDING) for along in (grid.x, grid.y))
    return height * ((column + line) % 2.0) * grid.inside(blocks * width)


@terrain(size=_LARGE, cell=FINE, hardest={"height": HIGHEST})
def stairs(grid: Grid, height: Height = 0.02, run: Length = 0.2) -> Floats:
    """Stairs in squares around the start: 3 steps up and 3 down in turn, 2 cm high and 0.2 m long."""
    pairs = math.floor((grid.ring_end + run) / (2.0 * _FLIGHT * run) + ROUNDING)
    number = np.floor(grid.ring / run + ROUNDING) % (2.0 * _FLIGHT)
    treads = _FLIGHT - np.abs(_FLIGHT - 1.0 - number)
    return grid.first * height * treads * grid.inside(2.0 * _FLIGHT * pairs * run)


@terrain(size=_LARGE, cell=FINE, hardest={"depth": HIGHEST})
def gaps(
    grid: Grid, depth: Height = 0.02, width: Annotated[float, Parameter("m", 0.1)] = 0.15, distance: Length = 0.45
) -> Floats:
    """Trenches in squares around the start, 2 cm deep, 0.15 m wide and 0.45 m apart."""
    number = math.floor(grid.ring_end / distance + ROUNDING)
    trench = (grid.ring + ROUNDING) % distance >= distance - width - ROUNDING
    # At the edge the ground goes down to the bottom of the trenches, or it would end in a step of this height.
    return -depth * np.maximum(trench & grid.inside(number * distance), grid.descent)


@terrain(size=_LARGE, cell=FINE, hardest={"height": HIGHEST})
def wave(grid: Grid, height: Height = 0.02, length: Length = 0.8) -> Floats:
    """Waves of up to 2 cm along x and y, 0.8 m long."""
    along_x, along_y = (np.cos(math.tau * along / length) for along in (grid.x, grid.y))
    return 0.25 * height * (2.0 - along_x - along_y) * grid.fade


tiles: Final = Tiles(
    "tiles",
    np.zeros_like,
    parameters={},
    description="A tile for each kind of ground at each level.",
    cell=FINE,
    kinds=(flat, slope, rough, steps, stairs, gaps, wave),
)
"""All terrains with levels."""

TERRAINS: Final = (flat, rough, hills, slope, steps, stairs, gaps, wave, tiles)
"""Built-in terrains. A policy that was trained on flat ground can walk on `rough` and `hills`."""
NAMES: Final = ", ".join(entry.name for entry in TERRAINS)
"""Their names, for the help of an option."""


def terrain_scale(terrain: Terrain, robot: Robot) -> float:
    """Factor on a terrain's lengths for a robot, by its leg length; 1 for a user's terrain, whose lengths stay."""
    return scale_of("m", robot) if any(terrain.function is entry.function for entry in TERRAINS) else 1.0


def find_terrain(name: object, terrains: Sequence[Terrain] = TERRAINS) -> Terrain:
    """The terrain of a name. Raises a QuadrupedError if there is no such terrain."""
    for entry in terrains:
        if entry.name == name:
            return entry
    names = [entry.name for entry in terrains]
    raise QuadrupedError(f"terrain: {short(name)} is unknown; there are {', '.join(names)}{did_you_mean(name, names)}")
