"""Heights of the ground of a compiled model, exactly as MuJoCo collides with it."""

import math
from typing import Final, Self

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.utils.arrays import Floats

GROUND: Final = "ground"
"""Name of the geom that is the ground: a plane or a height field."""
SURROUNDINGS: Final = "surroundings"
"""Name of the plane around a height field."""


class HeightField:
    """Height field of a model that has one as its ground (`build_model`).

    Elementwise operations only: the height below a point does not depend on the other points.
    """

    def __init__(self, model: mujoco.MjModel) -> None:
        ground = model.geom(GROUND)
        field = model.hfield(int(model.geom_dataid[ground.id]))
        self._rows, self._columns = int(field.nrow[0]), int(field.ncol[0])
        half_x, half_y, top, _ = field.size
        first = int(field.adr[0])
        data = model.hfield_data[first : first + self._rows * self._columns]
        self._heights = data.astype(np.float64) * top + ground.pos[2]
        self._half = np.array([half_x, half_y])
        self._last = np.array([self._columns - 1.0, self._rows - 1.0])
        self._cell = 2.0 * self._half / self._last
        self._outside = model.geom(SURROUNDINGS).pos[2]

    @classmethod
    def of(cls, model: mujoco.MjModel) -> Self | None:
        """Height field of a model; None if its ground is a plane at height 0."""
        is_field = model.geom(GROUND).type == mujoco.mjtGeom.mjGEOM_HFIELD
        return cls(model) if is_field else None

    def points(self, around: NDArray[np.floating] | None = None, margin: float = 0.0) -> Floats:
        """Grid points (along y, along x, 3) in the world, m: all, or up to a margin around positions (N, 2 or 3)."""
        rows = columns = slice(None)
        if around is not None:
            place = around[..., :2]
            first, _ = self._cell_of(place.min(axis=0) - margin)
            last, _ = self._cell_of(place.max(axis=0) + margin)
            columns, rows = (slice(int(low), int(high) + 2) for low, high in zip(first, last, strict=True))
        x, y = (
            np.linspace(-half, half, points)
            for half, points in zip(self._half, (self._columns, self._rows), strict=True)
        )
        heights = self._heights.reshape(self._rows, self._columns)
        return np.stack([*np.meshgrid(x[columns], y[rows]), heights[rows, columns]], axis=-1)

    def at(self, positions: Floats) -> Floats:
        """Height of the ground (...,) below or above positions (..., 2 or 3), m."""
        place = positions[..., :2]
        index, share = self._cell_of(place)
        first = index[..., 1] * self._columns + index[..., 0]
        # MuJoCo divides each cell by the diagonal through its first and last corner.
        s, t = share[..., 0], share[..., 1]
        below = s >= t
        side = first + np.where(below, 1, self._columns)
        heights = self._heights
        low, high = np.minimum(s, t), np.maximum(s, t)
        height = (1.0 - high) * heights[first] + low * heights[first + self._columns + 1] + (high - low) * heights[side]
        return np.where(self._inside(place, 0.0), height, self._outside)

    def highest(self, positions: Floats, radius: float) -> Floats:
        """Maximum height (...,) of the grid points in squares of half side `radius` at positions (..., 2 or 3), m."""
        place = positions[..., :2]
        first, _ = self._cell_of(place - radius)
        columns, rows = (
            np.minimum(first[..., axis, None] + np.arange(math.ceil(2.0 * radius / self._cell[axis]) + 2), last)
            for axis, last in enumerate((self._columns - 1, self._rows - 1))
        )
        around = self._heights[rows[..., :, None] * self._columns + columns[..., None, :]]
        return np.where(self._inside(place, radius), np.maximum.reduce(around, (-2, -1)), self._outside)

    def _cell_of(self, place: Floats) -> tuple[NDArray[np.intp], Floats]:
        """Index along x and y (..., 2) of the cell at positions (..., 2), and coordinates in the cell, in [0, 1]."""
        # fmin and fmax, so that the position of an env that diverged, which may be NaN, gives a valid index.
        scaled = np.fmin(np.fmax((place + self._half) / self._cell, 0.0), self._last)
        index = np.minimum(np.floor(scaled), self._last - 1.0)
        return index.astype(np.intp), scaled - index

    def _inside(self, place: Floats, margin: float) -> NDArray[np.bool_]:
        return np.logical_and.reduce(np.abs(place) <= self._half + margin, -1)
