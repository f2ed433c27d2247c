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

    points = field.points(around, margin)
    # Two triangles per cell, divided as in MuJoCo.
    index = np.arange(points[..., 0].size).reshape(points.shape[:2])
    corner, right, above, opposite = index[:-1, :-1], index[:-1, 1:], index[1:, :-1], index[1:, 1:]
    faces = np.stack([np.stack([corner, right, opposite], -1), np.stack([corner, opposite, above], -1)])
    squares = np.floor(points[..., :2] / _SQUARE).sum(axis=-1).astype(int) % 2
    return trimesh.Trimesh(
        points.reshape(-1, 3), faces.reshape(-1, 3), vertex_colors=_COLOURS[squares.ravel()], process=False
    )
