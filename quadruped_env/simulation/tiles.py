"""A terrain of tiles: every kind at every level, each with level ground in its middle and around it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Final, Self

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.simulation.grid import Floats, Grid, smoothstep
from quadruped_env.simulation.terrain import LEVELS, Terrain

TILE: Final = 4.0
"""Side length of a tile, m: 13 times the length of the built-in robot's base."""
_MARGIN: Final = 1.0
"""Width of the strip around the tiles in which the ground goes down to their lowest point, m."""


@dataclass(frozen=True)
class Tiles(Terrain):
    """A height field of square tiles: levels along x, from 1 on, and kinds along y. Created by `tiles_of`."""

    kinds: tuple[Terrain, ...] = ()
    """Terrains with levels, one line of tiles each."""
    levels: int = LEVELS
    """Number of levels, from 1 on."""

    @property
    def extent(self) -> tuple[float, float]:
        """See `Terrain`."""
        return self.levels * TILE + 2.0 * _MARGIN, len(self.kinds) * TILE + 2.0 * _MARGIN

    def variant(self, seed: int = 0, level: int | None = None, scale: float = 1.0, **values: float) -> Self:
        """See `Terrain`; `scale` is that of all tiles."""
        return replace(super().variant(seed, level, scale, **values), scale=float(scale))

    def of(self, kinds: Sequence[Terrain], levels: int, seed: int = 0, scale: float = 1.0) -> Self:
        """Tiles of other kinds and levels; `scale` is the leg length relative to the built-in robot's.

        Raises:
            QuadrupedError: if a kind has no levels.
        """
        for kind in kinds:
            if kind.hardest is None:
                raise QuadrupedError(f"terrain {self.name}: the kind {kind.name} has no levels")
        plain = tuple(kind.variant() for kind in kinds)
        file = next((kind.file for kind in kinds if kind.file is not None), None)
        return replace(self, kinds=plain, levels=levels, seed=seed, scale=float(scale), file=file)

    def centres(self) -> Floats:
        """Middle of each tile (K, L, 2) in the world, m: kind k at level l + 1 has index [k, l]."""
        along_x = TILE * (np.arange(self.levels) - 0.5 * (self.levels - 1))
        along_y = TILE * (np.arange(len(self.kinds)) - 0.5 * (len(self.kinds) - 1))
        return np.stack(np.meshgrid(along_x, along_y), axis=-1)

    def tile(self, kind: int, level: int) -> Floats:
        """Heights (P, P) of one tile in m, without the other tiles.

        Args:
            kind: index in `kinds`.
            level: from 1 on.

        Raises:
            QuadrupedError: if the kind's heights are not valid, or not 0 on the edge.
        """
        random = np.random.default_rng([self.seed, kind, level])
        grid = Grid.square(TILE, self.cell, random, tile=True)
        heights = self.kinds[kind].variant(level=level, scale=self.scale).heights_on(grid)
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


def tiles_of(kinds: Sequence[Terrain], cell: float) -> Tiles:
    """The terrain `tiles` of some kinds, which have levels.

    Args:
        kinds: terrains with levels.
        cell: grid spacing, m.
    """
    parts: dict[str, Any] = {
        "parameters": {},
        "description": "A tile for each kind of ground at each level.",
        "cell": cell,
    }
    return Tiles("tiles", np.zeros_like, **parts, kinds=tuple(kinds))
