"""Mesh of uneven ground for 3D scenes in a browser."""

from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.simulation.height_field import HeightField

if TYPE_CHECKING:
    import trimesh

_SQUARE: Final = 0.5
"""Side length of the squares of the pattern, m."""
_COLOURS: Final = np.array([[226, 230, 234, 255], [206, 212, 219, 255]], np.uint8)


def ground_mesh(
    field: HeightField, around: NDArray[np.floating] | None = None, margin: float = 3.0
) -> "trimesh.Trimesh":
    """The ground as a mesh in the world frame, with a pattern of squares.

    Args:
        field: heights of the ground.
        around: positions (N, 2) whose surroundings are needed, m; None: the whole field.
        margin: distance around these positions that is covered, m.
    """
    import trimesh

    rows, columns = (slice(None), slice(None)) if around is None else _covering(field, around, margin)
    y, x = (
        np.linspace(-half, half, points)
        for half, points in zip(field.half_size[::-1], field.heights.shape, strict=True)
    )
    x, y = np.meshgrid(x[columns], y[rows])
    vertices = np.stack([x, y, field.heights[rows, columns]], axis=-1)
    # Two triangles per cell, divided as in MuJoCo.
    index = np.arange(x.size).reshape(x.shape)
    corner, right, above, opposite = index[:-1, :-1], index[:-1, 1:], index[1:, :-1], index[1:, 1:]
    faces = np.stack([np.stack([corner, right, opposite], -1), np.stack([corner, opposite, above], -1)])
    squares = (np.floor(x / _SQUARE) + np.floor(y / _SQUARE)).astype(int) % 2
    return trimesh.Trimesh(
        vertices.reshape(-1, 3), faces.reshape(-1, 3), vertex_colors=_COLOURS[squares.ravel()], process=False
    )


def _covering(field: HeightField, around: NDArray[np.floating], margin: float) -> tuple[slice, slice]:
    """Rows and columns of the grid that cover the surroundings of positions (N, 2)."""
    points = np.array(field.heights.shape[::-1])
    cell = 2.0 * field.half_size / (points - 1)
    first = np.floor((around.min(axis=0) - margin + field.half_size) / cell).astype(int)
    last = np.ceil((around.max(axis=0) + margin + field.half_size) / cell).astype(int)
    first, last = np.clip(first, 0, points - 2), np.clip(last, 1, points - 1)
    columns, rows = (slice(int(low), int(high) + 1) for low, high in zip(first, last, strict=True))
    return rows, columns
