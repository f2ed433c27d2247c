"""Terrains: named shapes of the ground, their parameters and levels, and the decorator that creates them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Final, Self, overload

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.simulation.grid import CELL, MAX_POINTS, SIZE, Grid
from quadruped_env.utils.parameters import Parameter, described, parameters_of, stay_importable
from quadruped_env.utils.provenance import TERRAIN_FILE, TaskFile

Floats = NDArray[np.float64]

LEVELS: Final = 10
"""Number of levels of a terrain that has levels, from 1 to the hardest."""
FIELDS: Final = ("name", "seed", "level")
"""Fields of every terrain in the config."""


@dataclass(frozen=True)
class Terrain:
    """A named shape of the ground. Created by `terrain`; `variant` changes its seed, level and parameters."""

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
    hardest: Mapping[str, float] | None = field(default=None, compare=False)
    """Values of some parameters at the hardest level, for the built-in robot; None: the terrain has no levels."""
    seed: int = 0
    level: int | None = None
    """Level from 1 to `LEVELS`, which determines the parameters in `hardest`; None: they have their defaults."""
    scale: float = 1.0
    """Leg length relative to the built-in robot's, a factor on the lengths of the levels."""
    values: tuple[tuple[str, float], ...] = ()
    """Name and value of the parameters that differ from their defaults, or from those of the level."""
    file: TaskFile | None = field(default=None, compare=False)
    """User's file that defines it; None for a terrain that is built in or defined in Python alone."""

    def __post_init__(self) -> None:
        reserved = sorted(set(FIELDS) & set(self.parameters))
        if reserved:
            raise QuadrupedError(
                f"terrain {self.name}: {reserved[0]!r} is a field of every terrain; rename the parameter"
            )
        if not (0.0 < self.cell <= self.size and self.size / self.cell <= MAX_POINTS - 1):
            raise QuadrupedError(
                f"terrain {self.name}: expected a size and a cell in m with 1 to {MAX_POINTS - 1} cells per side; "
                f"found size={self.size:g}, cell={self.cell:g}"
            )
        for name, value in (self.hardest or {}).items():
            if name not in self.parameters or not self.parameters[name][0].accepts(value):
                raise QuadrupedError(
                    f"terrain {self.name}: hardest must give valid values of its parameters; found {name}={value!r}"
                )

    @property
    def extent(self) -> tuple[float, float]:
        """Side lengths of the height field along x and y, m."""
        return self.size, self.size

    def defaults(self, level: int | None, scale: float = 1.0) -> dict[str, float]:
        """Values of all parameters at a level, or without one.

        Lengths are in proportion to the level and the leg length, angles to the level.

        Args:
            level: from 1 to `LEVELS`; None: the defaults of the parameters.
            scale: leg length relative to the built-in robot's.

        Raises:
            QuadrupedError: if the level is not valid, or the terrain has no levels.
        """
        values = {name: default for name, (_, default) in self.parameters.items()}
        if level is None:
            return values
        if self.hardest is None:
            raise QuadrupedError(f"terrain {self.name}: found level {short(level)}, but it has no levels; leave it out")
        if isinstance(level, bool) or not isinstance(level, (int, np.integer)) or not 1 <= level <= LEVELS:
            raise QuadrupedError(
                f"terrain {self.name}: level must be a whole number from 1 to {LEVELS}; found {short(level)}"
            )
        for name, value in self.hardest.items():
            length = scale if self.parameters[name][0].unit == "m" else 1.0
            values[name] = value * length * level / LEVELS
        return values

    def variant(self, seed: int = 0, level: int | None = None, scale: float = 1.0, **values: float) -> Self:
        """The same terrain with a seed, a level and values of its parameters; the others have their defaults.

        Args:
            seed: seed of its random numbers.
            level: from 1 to `LEVELS`; None: no level.
            scale: leg length relative to the built-in robot's; it counts only with a level.
            values: values of parameters by name.

        Raises:
            QuadrupedError: if the level is not valid, a parameter is unknown or its value is not valid.
        """
        defaults = self.defaults(level, scale)
        for name, value in values.items():
            if name not in self.parameters:
                valid = ", ".join(self.parameters) or "none"
                raise QuadrupedError(f"terrain {self.name}: unknown parameter {name!r}; its parameters are: {valid}")
            parameter = self.parameters[name][0]
            if not parameter.accepts(value):
                raise QuadrupedError(f"terrain {self.name}: {name} must be {parameter.rule()}; found {short(value)}")
        changed = ((name, float(value)) for name, value in sorted(values.items()) if value != defaults[name])
        return replace(
            self, seed=seed, level=level, scale=1.0 if level is None else float(scale), values=tuple(changed)
        )

    def provenance(self) -> dict[str, Any]:
        """Name of the terrain and, as `terrain_file`, name and SHA-256 of the file that defines it, for results."""
        return {"terrain": self.name, **({} if self.file is None else {TERRAIN_FILE: self.file.to_dict()})}

    def heights(self) -> Floats:
        """Heights (P, P) in m, first axis along y, second along x; the same seed gives the same heights.

        Raises:
            QuadrupedError: if the function raises an error or returns something else.
        """
        return self.heights_on(Grid.square(self.size, self.cell, np.random.default_rng(self.seed)))

    def heights_on(self, grid: Grid) -> Floats:
        """Heights (P, P) in m on a grid, which may be a tile's; errors as in `heights`."""
        values = self.defaults(self.level, self.scale) | dict(self.values)
        try:
            heights = np.asarray(self.function(grid, **values), dtype=np.float64)
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
def terrain(
    *, size: float = SIZE, cell: float = CELL, hardest: Mapping[str, float] | None = None
) -> Callable[[Callable[..., Any]], Terrain]: ...
def terrain(
    function: Callable[..., Any] | None = None,
    /,
    *,
    size: float = SIZE,
    cell: float = CELL,
    hardest: Mapping[str, float] | None = None,
) -> Terrain | Callable[[Callable[..., Any]], Terrain]:
    """Decorator: a function (grid) -> heights (P, P) becomes a terrain of the same name.

    Arguments with a default, after the grid, are parameters that the config can change. Use it as `@terrain`, or with
    arguments as `@terrain(cell=0.05, hardest={"height": 0.05})`.

    Args:
        function: function of a `Grid`.
        size: side length of the square around the start, m.
        cell: grid spacing, m.
        hardest: values of some parameters at the hardest level; the terrain then has levels, and can be a kind of
            `tiles` if its heights are 0 where `Grid.fade` is 0.
    """

    def decorate(function: Callable[..., Any]) -> Terrain:
        stay_importable(function)
        parameters, description = parameters_of(function), described(function)
        return Terrain(function.__name__, function, parameters, description, size, cell, hardest)

    return decorate if function is None else decorate(function)
