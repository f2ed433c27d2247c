"""Terrains: named shapes of the ground on a grid of points, their parameters and levels, and tiles of several."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated, Any, Final, Self, overload

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.fields import check, check_names, converted
from quadruped_env.utils.parameters import Parameter, described, parameters_of, stay_importable
from quadruped_env.utils.provenance import TERRAIN_FILE, TaskFile

SIZE: Final = 40.0
"""Default side length of the square around the start, m; the ground is level beyond it."""
CELL: Final = 0.1
"""Default grid spacing, m. Contacts at the edges between cells slow a turning robot down: by 2 %, at 0.05 m by 6 %."""
MAX_POINTS: Final = 2001
"""Maximum number of grid points per side."""

START: Final = 0.4
"""Half the side of the level square around the start, m."""
TILE_BORDER: Final = 0.25
"""Width of the level strip along the edge of a tile, m."""
_FULL: Final = 1.2
"""Distance from the start from which `Grid.fade` is 1, m."""
_TILE_FULL: Final = 0.7
"""The same in a tile, m."""
_EDGE: Final = 1.0
"""Width of the strip along the edge in which `Grid.fade` goes to 0, m."""
_TILE_EDGE: Final = 0.5
"""The same in a tile, with its level border, m."""
ROUNDING: Final = 1e-9
"""Tolerance for rounding errors of coordinates, m."""

LEVELS: Final = 10
"""Number of levels of a terrain that has levels, from 1 to the hardest."""
Level = Annotated[int, Parameter(low=1, high=LEVELS)]
FIELDS: Final = ("name", "seed", "level")
"""Fields of every terrain in the config."""

TILE: Final = 4.0
"""Side length of a tile, m: 13 times the length of the built-in robot's base."""
_MARGIN: Final = 1.0
"""Width of the strip around the tiles in which the ground goes down to their lowest point, m."""


@dataclass(frozen=True, eq=False)
class Grid:
    """Input of a terrain's function: P x P points, and random numbers."""

    x: Floats
    """Coordinate along x of each point (P, P), m, from the start; it changes along the second axis."""
    y: Floats
    """Coordinate along y of each point (P, P), m, from the start; it changes along the first axis."""
    size: float
    """Side length of the square, m; the start is in its middle."""
    random: np.random.Generator
    """Random generator from the terrain's seed."""
    tile: bool = False
    """True for a tile of `tiles`, whose edge must be level at height 0."""
    scale: float = 1.0
    """Leg length relative to the built-in robot's: factor on the lengths of this module."""

    @classmethod
    def square(
        cls, size: float, cell: float, random: np.random.Generator, tile: bool = False, scale: float = 1.0
    ) -> Self:
        """Grid of a square around the start, with points `cell` apart, m."""
        along = np.linspace(-0.5 * size, 0.5 * size, round(size / cell) + 1)
        return cls(*np.meshgrid(along, along), size, random, tile, scale)

    @property
    def fade(self) -> Floats:
        """Factor (P, P) that is 0 around the start and at the edge, and 1 between them."""
        full, edge, border = (_TILE_FULL, _TILE_EDGE, TILE_BORDER) if self.tile else (_FULL, _EDGE, 0.0)
        from_start, to_edge = np.hypot(self.x, self.y) / self.scale, self._to_edge / self.scale
        return smoothstep((from_start - START) / (full - START)) * smoothstep((to_edge - border) / (edge - border))

    @property
    def descent(self) -> Floats:
        """Factor (P, P) that goes from 0 to 1 in the strip along the edge; 0 everywhere in a tile."""
        return np.zeros_like(self.x) if self.tile else 1.0 - smoothstep(self._to_edge / (_EDGE * self.scale))

    @property
    def first(self) -> float:
        """Sign of the first slope away from the start: 1 for up, and -1 in a tile.

        A height field's highest point decides which parts of a robot MuJoCo looks up in it. With hollows instead of
        hills, it is the base only for robots that walk through a hollow.
        """
        return -1.0 if self.tile else 1.0

    @property
    def ring(self) -> Floats:
        """Distance (P, P) from the level square around the start, m; its contour lines are squares."""
        return np.maximum(np.abs(self.x), np.abs(self.y)) - START * self.scale

    @property
    def ring_end(self) -> float:
        """Largest `ring` at which the ground may be uneven, m."""
        return 0.5 * self.size - ((TILE_BORDER if self.tile else _EDGE) + START) * self.scale

    def inside(self, width: float) -> NDArray[np.bool_]:
        """Mask (P, P) of the points whose `ring` is from 0 up to a width, m."""
        ring = self.ring
        return (ring > -ROUNDING) & (ring < width - ROUNDING)

    def smooth_noise(self, distance: float) -> Floats:
        """Random numbers in [0, 1) at points `distance` apart, m, smoothly interpolated: (P, P)."""
        knots = self.random.random((round(self.size / distance) + 2,) * 2)
        at = (self.x[0] + 0.5 * self.size) / distance
        index = np.minimum(at.astype(int), len(knots) - 2)
        share = smoothstep(at - index)
        along = knots[index] * (1.0 - share[:, None]) + knots[index + 1] * share[:, None]
        return along[:, index] * (1.0 - share) + along[:, index + 1] * share

    @property
    def _to_edge(self) -> Floats:
        return 0.5 * self.size - np.maximum(np.abs(self.x), np.abs(self.y))


def smoothstep(x: Floats) -> Floats:
    """Smoothstep function: from 0 to 1 while x goes from 0 to 1."""
    x = np.clip(x, 0.0, 1.0)
    return x * x * (3.0 - 2.0 * x)


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
    """Factor on all its lengths, which are the built-in robot's; 1 for a user's terrain."""
    values: tuple[tuple[str, float], ...] = ()
    """Name and value of the parameters that differ from their defaults, or from the level's."""
    file: TaskFile | None = field(default=None, compare=False)
    """User's file that defines it; None for a terrain that is built in or defined in Python alone."""

    def __post_init__(self) -> None:
        reserved = sorted(set(FIELDS) & set(self.parameters))
        if reserved:
            raise QuadrupedError(
                f"terrain {self.name}: {reserved[0]!r} is a field of every terrain; rename the parameter"
            )
        fine = 0.0 < self.cell <= self.size and self.size / self.cell <= MAX_POINTS - 1
        rule = f"lengths in m with 1 to {MAX_POINTS - 1} cells per side"
        check(fine, f"terrain {self.name}: size and cell", (self.size, self.cell), rule)
        for name, value in (self.hardest or {}).items():
            valid = name in self.parameters and self.parameters[name][0].accepts(value)
            check(valid, f"terrain {self.name}: hardest", {name: value}, "valid values of its parameters")

    @property
    def extent(self) -> tuple[float, float]:
        """Side lengths of the height field along x and y, m."""
        return self.size * self.scale, self.size * self.scale

    def defaults(self, level: int | None, scale: float = 1.0) -> dict[str, float]:
        """Values of all parameters at a level, in proportion to it, or without one; `scale` is a factor on lengths.

        Raises:
            QuadrupedError: if the level is not valid, or the terrain has no levels.
        """
        factors = {name: scale if entry.unit == "m" else 1.0 for name, (entry, _) in self.parameters.items()}
        values = {name: factors[name] * default for name, (_, default) in self.parameters.items()}
        if level is None:
            return values
        if self.hardest is None:
            raise QuadrupedError(f"terrain {self.name}: found level {short(level)}, but it has no levels; leave it out")
        whole = converted(level, Level, f"terrain {self.name}: level")
        for name, value in self.hardest.items():
            values[name] = value * factors[name] * whole / LEVELS
        return values

    def variant(self, seed: int = 0, level: int | None = None, scale: float = 1.0, **values: float) -> Self:
        """The same terrain with a seed, a level and values of its parameters; the others have their defaults.

        Args:
            seed: seed of its random numbers.
            level: from 1 to `LEVELS`; None: no level.
            scale: factor on all lengths except `values`.
            values: values of parameters by name.

        Raises:
            QuadrupedError: if the level is not valid, a parameter is unknown or its value is not valid.
        """
        defaults = self.defaults(level, scale)
        check_names(values, self.parameters, f"terrain {self.name}")
        own = {
            name: converted(value, Annotated[float, self.parameter(name, scale)], f"terrain {self.name}: {name}")
            for name, value in values.items()
        }
        changed = ((name, value) for name, value in sorted(own.items()) if value != defaults[name])
        return replace(self, seed=seed, level=level, scale=float(scale), values=tuple(changed))

    def parameter(self, name: str, scale: float) -> Parameter:
        """Unit and valid range of a parameter; limits of lengths are times a factor."""
        parameter = self.parameters[name][0]
        return parameter.scaled(scale) if parameter.unit == "m" else parameter

    def provenance(self) -> dict[str, Any]:
        """Name of the terrain and, as `terrain_file`, name and SHA-256 of the file that defines it, for results."""
        return {"terrain": self.name, **({} if self.file is None else {TERRAIN_FILE: self.file.to_dict()})}

    def heights(self) -> Floats:
        """Heights (P, P) in m, first axis along y, second along x; the same seed gives the same heights.

        Raises:
            QuadrupedError: if the function raises an error or returns something else.
        """
        random = np.random.default_rng(self.seed)
        return self.heights_on(Grid.square(self.extent[0], self.cell * self.scale, random, scale=self.scale))

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


@dataclass(frozen=True)
class Tiles(Terrain):
    """A height field of square tiles: levels along x, from 1 on, and kinds along y."""

    kinds: tuple[Terrain, ...] = ()
    """Terrains with levels, one line of tiles each."""
    levels: int = LEVELS
    """Number of levels, from 1 on."""

    @property
    def tile_size(self) -> float:
        """Side length of a tile, m."""
        return TILE * self.scale

    @property
    def extent(self) -> tuple[float, float]:
        """See `Terrain`."""
        x, y = ((count * TILE + 2.0 * _MARGIN) * self.scale for count in (self.levels, len(self.kinds)))
        return x, y

    def of(self, kinds: Sequence[Terrain], levels: int, seed: int = 0, scale: float = 1.0) -> Self:
        """Tiles of other kinds and levels; `scale` is the factor on the tiles, and the kinds keep their own.

        Raises:
            QuadrupedError: if a kind has no levels.
        """
        for kind in kinds:
            if kind.hardest is None:
                raise QuadrupedError(f"terrain {self.name}: the kind {kind.name} has no levels")
        plain = tuple(kind.variant(scale=kind.scale) for kind in kinds)
        file = next((kind.file for kind in kinds if kind.file is not None), None)
        return replace(self, kinds=plain, levels=levels, seed=seed, scale=float(scale), file=file)

    def centres(self) -> Floats:
        """Middle of each tile (K, L, 2) in the world, m: kind k at level l + 1 has index [k, l]."""
        along_x = self.tile_size * (np.arange(self.levels) - 0.5 * (self.levels - 1))
        along_y = self.tile_size * (np.arange(len(self.kinds)) - 0.5 * (len(self.kinds) - 1))
        return np.stack(np.meshgrid(along_x, along_y), axis=-1)

    def tile(self, kind: int, level: int) -> Floats:
        """Heights (P, P) of one tile in m, without the other tiles, for an index in `kinds` and a level from 1 on.

        Raises:
            QuadrupedError: if the kind's heights are not valid, or not 0 on the edge.
        """
        random = np.random.default_rng([self.seed, kind, level])
        grid = Grid.square(self.tile_size, self.cell * self.scale, random, tile=True, scale=self.scale)
        heights = self.kinds[kind].variant(level=level, scale=self.kinds[kind].scale).heights_on(grid)
        edges = np.concatenate([heights[[0, -1]].ravel(), heights[:, [0, -1]].ravel()])
        if edges.any():
            raise QuadrupedError(
                f"terrain {self.kinds[kind].name}: as a tile its edge must be at height 0, and is at up to "
                f"{np.abs(edges).max():g} m; multiply the heights by grid.fade"
            )
        return heights

    def heights(self) -> Floats:
        """Heights in m (points along y, points along x); see `Terrain.heights`."""
        cells, margin = round(TILE / self.cell), round(_MARGIN / self.cell)
        columns, lines = self.levels * cells, len(self.kinds) * cells
        inner = np.zeros((lines + 1, columns + 1))
        for kind in range(len(self.kinds)):
            for level in range(1, self.levels + 1):
                y, x = kind * cells, (level - 1) * cells
                inner[y : y + cells + 1, x : x + cells + 1] = self.tile(kind, level)
        outside = np.pad(np.zeros_like(inner), margin, "linear_ramp", end_values=_MARGIN)
        return np.pad(inner, margin) + min(inner.min(), 0.0) * smoothstep(outside / _MARGIN)
