"""The ground of 3D scenes in a browser, in the colours of films: meshes of the flat floor and of uneven ground."""

from typing import TYPE_CHECKING, Any, Final

import mujoco
import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.report.palette import BACKGROUND, FLOOR, SQUARE, rgb
from quadruped_env.simulation.height_field import GROUND, SURROUNDINGS, HeightField

if TYPE_CHECKING:
    import trimesh

FLOOR_PERIOD: Final = 2.0 * SQUARE
"""Distance after which the pattern of the floor repeats along x and y, m."""
_HALF_SQUARES: Final = 16
"""Half the number of squares along each side of the floor; beyond them it has their mean colour."""
_SHADE: Final = 3.0
"""Darkness of the ground where it rises: the browser's light, from all sides, shows no step of one colour."""
_FADED: Final = 60.0
"""Distance from the middle at which the floor has the colour of the sky, m."""


def linear(colours: ArrayLike) -> NDArray[np.float64]:
    """Return linear values of sRGB values, all in 0 to 1, which glTF expects of a mesh; source: IEC 61966-2-1."""
    srgb = np.asarray(colours, dtype=np.float64)
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def scene_rgb(colour: str) -> tuple[int, int, int]:
    """Return the colour `#rrggbb` as linear values in 0 to 255, for a mesh, an arrow or a line of viser's scene."""
    red, green, blue = (255.0 * linear(np.array(rgb(colour)) / 255.0)).round().astype(int).tolist()
    return red, green, blue


_COLOURS: Final = np.array([[*scene_rgb(colour), 255] for colour in FLOOR], np.uint8)


def use_film_colours(model: mujoco.MjModel) -> None:
    """Change a model's colours, which mjviser passes on as linear ones, so that the browser shows them as in films."""
    for colours in (model.mat_rgba, model.geom_rgba):
        colours[:, :3] = linear(colours[:, :3])


def robot_scene(server: Any, model: mujoco.MjModel) -> Any:
    """Return mjviser's scene of a model, which is modified: the light and colours of films, no uneven ground.

    Uneven ground is drawn by `ground_mesh`: mjviser would draw a height field again with every robot.
    """
    from mjviser import ViserMujocoScene

    if HeightField.of(model) is not None:
        model.geom(GROUND).rgba[3] = 0.0
    use_film_colours(model)
    scene = ViserMujocoScene(server, model, num_envs=1)
    scene.camera_tracking_enabled = False
    server.scene.configure_environment_map("studio", environment_intensity=0.35)
    server.scene.set_background_image(np.full((1, 1, 3), rgb(BACKGROUND), np.uint8), format="png")
    add_floor(server, floor_plane(model).name, float(floor_plane(model).pos[2]))
    return scene


def floor_plane(model: mujoco.MjModel) -> Any:
    """Return the plane of a model that is drawn as the floor: the ground, or what surrounds uneven ground."""
    return model.geom(GROUND if HeightField.of(model) is None else SURROUNDINGS)


def floor_mesh() -> "trimesh.Trimesh":
    """Return a flat floor at height 0 with a pattern of squares around the origin, which fades into the sky."""
    import trimesh

    count = 2 * _HALF_SQUARES
    corner = np.stack(np.meshgrid(np.arange(count), np.arange(count), indexing="ij"), -1).reshape(-1, 2)
    # Each square has its own corners, for a colour of its own.
    offsets = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    points = (corner[:, None] + offsets - _HALF_SQUARES).reshape(-1, 2) * SQUARE
    # Squares pale with the distance, so that the pattern has no visible edge.
    mean = _COLOURS.mean(axis=0)
    reach = np.abs(points).max(axis=1, keepdims=True) / (_HALF_SQUARES * SQUARE)
    own = np.repeat(_COLOURS[corner.sum(axis=1) % 2], 4, axis=0)
    colours = own + (mean - own) * np.clip(2.0 * reach - 1.0, 0.0, 1.0)
    faces = 4 * np.arange(len(corner))[:, None, None] + np.array([[0, 1, 2], [0, 2, 3]])
    # Around them a ring of four trapezoids.
    ring = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    first = len(points)
    points = np.concatenate([points, _HALF_SQUARES * SQUARE * ring, _FADED * ring])
    colours = np.concatenate([colours, [mean] * 4, [[*scene_rgb(BACKGROUND), 255]] * 4])
    sides = [[[i, i + 4, (i + 1) % 4 + 4], [i, (i + 1) % 4 + 4, (i + 1) % 4]] for i in range(4)]
    faces = np.concatenate([faces.reshape(-1, 3), first + np.array(sides).reshape(-1, 3)])
    vertices = np.column_stack([points, np.zeros(len(points))])
    return trimesh.Trimesh(vertices, faces, vertex_colors=colours.round().astype(np.uint8), process=False)


def add_floor(server: Any, plane: str, height: float) -> None:
    """Draw the flat floor at a height, m, in viser's scene; it replaces the grid that mjviser draws for a plane."""
    name, position = f"/fixed_bodies/world/{plane}", (0.0, 0.0, height)
    server.scene.add_mesh_trimesh(name, floor_mesh(), position=position, cast_shadow=False, receive_shadow=0.25)


def floor_offset(shift: NDArray[np.floating[Any]]) -> NDArray[np.floating[Any]]:
    """Return a displacement (..., 2) of the floor, m, less whole periods of its pattern: it looks the same."""
    return shift - FLOOR_PERIOD * np.round(shift / FLOOR_PERIOD)


def ground_mesh(
    field: HeightField, around: NDArray[np.floating] | None = None, margin: float = 3.0
) -> "trimesh.Trimesh":
    """Return the ground as a mesh in the world frame with squares, within a margin, m, of positions (N, 2)."""
    import trimesh

    points = field.points(around, margin)
    # Two triangles per cell, divided as in MuJoCo.
    index = np.arange(points[..., 0].size).reshape(points.shape[:2])
    corner, right, above, opposite = index[:-1, :-1], index[:-1, 1:], index[1:, :-1], index[1:, 1:]
    faces = np.stack([np.stack([corner, right, opposite], -1), np.stack([corner, opposite, above], -1)])
    squares = np.floor(points[..., :2] / SQUARE).sum(axis=-1).astype(int) % 2
    colours = _COLOURS[squares].astype(np.float64)
    colours[..., :3] /= 1.0 + _SHADE * _rise(points)[..., None]
    return trimesh.Trimesh(
        points.reshape(-1, 3),
        faces.reshape(-1, 3),
        vertex_colors=colours.reshape(-1, 4).round().astype(np.uint8),
        process=False,
    )


def _rise(points: NDArray[np.floating]) -> NDArray[np.floating]:
    """Return the steepest rise from each point of a grid (..., 3) to a neighbour, as a slope; 0 on level ground."""
    height = np.pad(points[..., 2], 1, mode="edge")
    highest = np.max([height[:-2, 1:-1], height[2:, 1:-1], height[1:-1, :-2], height[1:-1, 2:]], axis=0)
    return np.maximum(highest - points[..., 2], 0.0) / (points[0, 1, 0] - points[0, 0, 0])
