"""Terrains: functions that give the heights of the ground around the start."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated, Any, Final, Self, overload

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.parameters import Parameter, described, parameters_of, stay_importable
from quadruped_env.provenance import TaskFile

Floats = NDArray[np.float64]

SIZE: Final = 40.0
"""Default side length of the square around the start, m; the ground is level beyond it."""
CELL: Final = 0.1
"""Default grid spacing, m. Contacts at the edges between cells slow a turning robot down: by 2 %, at 0.05 m by 6 %."""
MAX_POINTS: Final = 2001
"""Maximum number of grid points per side."""
TERRAIN_FILE: Final = "terrain_file"
"""Field of configs and results that names the user's file that defines the terrain."""
_START: Final = (0.4, 1.2)
"""Distances from the start up to which `Grid.fade` is 0, and from which it is 1, m."""
_EDGE: Final = 1.0
"""Width of the strip along the edge in which `Grid.fade` goes to 0, m."""


@dataclass(frozen=True, eq=False)
class Grid:
    """Input of a terrain's function: P x P points, and random numbers."""

    x: Floats
    """World coordinate along x of each point (P, P), m; it changes along the second axis."""
    y: Floats
    """World coordinate along y of each point (P, P), m; it changes along the first axis."""
    size: float
    """Side length of the square, m; the start is in its middle."""
    random: np.random.Generator
    """Random generator from the terrain's seed."""

    @classmethod
    def square(cls, size: float, cell: float, seed: int) -> Self:
        """Grid of a square around the start, with points `cell` apart, m."""
        along = np.linspace(-0.5 * size, 0.5 * size, round(size / cell) + 1)
        return cls(*np.meshgrid(along, along), size, np.random.default_rng(seed))

    @property
    def fade(self) -> Floats:
        """Factor (P, P) that is 0 around the start and at the edge, and 1 between them."""
        near, full = _START
        from_start = np.hypot(self.x, self.y)
        to_edge = 0.5 * self.size - np.maximum(np.abs(self.x), np.abs(self.y))
        return _smoothstep((from_start - near) / (full - near)) * _smoothstep(to_edge / _EDGE)

    def smooth_noise(self, distance: float) -> Floats:
        """Random numbers in [0, 1) at points `distance` apart, m, smoothly interpolated: (P, P)."""
        knots = self.random.random((round(self.size / distance) + 2,) * 2)
        at = (self.x[0] + 0.5 * self.size) / distance
        index = np.minimum(at.astype(int), len(knots) - 2)
        share = _smoothstep(at - index)
        along = knots[index] * (1.0 - share[:, None]) + knots[index + 1] * share[:, None]
        return along[:, index] * (1.0 - share) + along[:, index + 1] * share


@dataclass(frozen=True)
class Terrain:
    """A named shape of the ground. Created by `terrain`; `variant` changes its seed and parameters."""

    name: str
    function: Callable[..., Any]
    """Function (grid, parameters) -> heights (P, P), m. The start is at the origin."""
    parameters: dict[str, tuple[Parameter, float]] = field(compare=False)
    """Unit, valid range and default of each parameter."""
    description: str = field(compare=False)
    size: float = SIZE
    """Side length of the square around the start, m."""
    cell: float = CELL
    """Grid spacing, m."""
    seed: int = 0
    values: tuple[tuple[str, float], ...] = ()
    """Name and value of the parameters that differ from their defaults."""
    file: TaskFile | None = field(default=None, compare=False)
    """User's file that defines it; None for a terrain that is built in or defined in Python alone."""

    def __post_init__(self) -> None:
        reserved = sorted({"name", "seed"} & set(self.parameters))
        if reserved:
            raise QuadrupedError(
                f"terrain {self.name}: {reserved[0]!r} is a field of every terrain; rename the parameter"
            )
        if not (0.0 < self.cell <= self.size and self.size / self.cell <= MAX_POINTS - 1):
            raise QuadrupedError(
                f"terrain {self.name}: expected a size and a cell in m with 1 to {MAX_POINTS - 1} cells per side; "
                f"found size={self.size:g}, cell={self.cell:g}"
            )

    def variant(self, seed: int = 0, **values: float) -> Self:
        """The same terrain with a seed and values of its parameters; the others have their defaults.

        Raises:
            QuadrupedError: if a parameter is unknown or its value is not valid.
        """
        for name, value in values.items():
            if name not in self.parameters:
                valid = ", ".join(self.parameters) or "none"
                raise QuadrupedError(f"terrain {self.name}: unknown parameter {name!r}; its parameters are: {valid}")
            parameter = self.parameters[name][0]
            if not parameter.accepts(value):
                raise QuadrupedError(f"terrain {self.name}: {name} must be {parameter.rule()}; found {short(value)}")
        changed = ((name, float(value)) for name, value in sorted(values.items()) if value != self.parameters[name][1])
        return replace(self, seed=seed, values=tuple(changed))

    def provenance(self) -> dict[str, Any]:
        """Name of the terrain and, as `terrain_file`, name and SHA-256 of the file that defines it, for results."""
        return {"terrain": self.name, **({} if self.file is None else {TERRAIN_FILE: self.file.to_dict()})}

    def heights(self) -> Floats:
        """Heights (P, P) in m, first axis along y, second along x; the same seed gives the same heights.

        Raises:
            QuadrupedError: if the function raises an error or returns something else.
        """
        grid = Grid.square(self.size, self.cell, self.seed)
        try:
            heights = np.asarray(self.function(grid, **dict(self.values)), dtype=np.float64)
        except Exception as error:
            raise QuadrupedError(f"terrain {self.name}: {type(error).__name__}: {error}") from error
        if heights.shape != grid.x.shape or not np.isfinite(heights).all():
            found = f"shape {heights.shape}" if heights.shape != grid.x.shape else "a height that is not finite"
            raise QuadrupedError(
                f"terrain {self.name}: expected finite heights of shape {grid.x.shape}, as grid.x; found {found}"
            )
        return heights


@overload
def terrain(function: Callable[..., Any], /) -> Terrain: ...
@overload
def terrain(*, size: float = SIZE, cell: float = CELL) -> Callable[[Callable[..., Any]], Terrain]: ...
def terrain(
    function: Callable[..., Any] | None = None, /, *, size: float = SIZE, cell: float = CELL
) -> Terrain | Callable[[Callable[..., Any]], Terrain]:
    """Decorator: a function (grid) -> heights (P, P) becomes a terrain of the same name.

    Arguments with a default, after the grid, are parameters that the config can change. Use it as `@terrain`, or with
    arguments as `@terrain(cell=0.05)`.

    Args:
        function: function of a `Grid`.
        size: side length of the square around the start, m.
        cell: grid spacing, m.
    """

    def decorate(function: Callable[..., Any]) -> Terrain:
        stay_importable(function)
        return Terrain(function.__name__, function, parameters_of(function), described(function), size, cell)

    return decorate if function is None else decorate(function)


@terrain
def flat(grid: Grid) -> Floats:
    """Level ground."""
    return np.zeros_like(grid.x)


@terrain
def rough(
    grid: Grid,
    height: Annotated[float, Parameter("m", 0.0)] = 0.01,
    distance: Annotated[float, Parameter("m", 0.2)] = 0.2,
) -> Floats:
    """Bumps of up to 1 cm, 0.2 m apart."""
    return height * grid.smooth_noise(distance) * grid.fade


@terrain
def hills(
    grid: Grid,
    height: Annotated[float, Parameter("m", 0.0)] = 0.08,
    distance: Annotated[float, Parameter("m", 0.2)] = 2.5,
) -> Floats:
    """Hills of up to 8 cm, 2.5 m apart."""
    return height * grid.smooth_noise(distance) * grid.fade


TERRAINS: Final = (flat, rough, hills)
"""Built-in terrains. A policy that was trained on flat ground can walk on all of them."""


def find_terrain(name: object, terrains: Sequence[Terrain] = TERRAINS) -> Terrain:
    """The terrain of a name.

    Raises:
        QuadrupedError: if there is no such terrain.
    """
    for entry in terrains:
        if entry.name == name:
            return entry
    raise QuadrupedError(f"terrain: {short(name)} is unknown; there are {', '.join(entry.name for entry in terrains)}")


def summary(terrains: Sequence[Terrain] = TERRAINS) -> str:
    """Names and descriptions in one line, for the help of an option."""
    return "; ".join(f"{entry.name}: {entry.description.removesuffix('.').lower()}" for entry in terrains)


def _smoothstep(x: Floats) -> Floats:
    """Smoothstep function: from 0 to 1 while x goes from 0 to 1."""
    x = np.clip(x, 0.0, 1.0)
    return x * x * (3.0 - 2.0 * x)
