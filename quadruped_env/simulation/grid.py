"""Grid of points at which a terrain's function gives heights."""

from dataclasses import dataclass
from typing import Final, Self

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

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

    @classmethod
    def square(cls, size: float, cell: float, random: np.random.Generator, tile: bool = False) -> Self:
        """Grid of a square around the start, with points `cell` apart, m."""
        along = np.linspace(-0.5 * size, 0.5 * size, round(size / cell) + 1)
        return cls(*np.meshgrid(along, along), size, random, tile)

    @property
    def fade(self) -> Floats:
        """Factor (P, P) that is 0 around the start and at the edge, and 1 between them."""
        full, edge, border = (_TILE_FULL, _TILE_EDGE, TILE_BORDER) if self.tile else (_FULL, _EDGE, 0.0)
        from_start = np.hypot(self.x, self.y)
        return smoothstep((from_start - START) / (full - START)) * smoothstep(
            (self._to_edge - border) / (edge - border)
        )

    @property
    def descent(self) -> Floats:
        """Factor (P, P) that goes from 0 to 1 in the strip along the edge; 0 everywhere in a tile."""
        return np.zeros_like(self.x) if self.tile else 1.0 - smoothstep(self._to_edge / _EDGE)

    @property
    def first(self) -> float:
        """Sign of the first slope away from the start: 1 for up, and -1 in a tile.

        A height field's highest point decides which parts of a robot MuJoCo looks up in it. With hollows in place of
        hills, that is the base only for robots that walk through a hollow.
        """
        return -1.0 if self.tile else 1.0

    @property
    def ring(self) -> Floats:
        """Distance (P, P) from the level square around the start, m; its contour lines are squares."""
        return np.maximum(np.abs(self.x), np.abs(self.y)) - START

    @property
    def ring_end(self) -> float:
        """Largest `ring` at which the ground may be uneven, m."""
        return 0.5 * self.size - (TILE_BORDER if self.tile else _EDGE) - START

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
