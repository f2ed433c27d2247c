"""The robots and what is drawn around them, in the browser's 3D scene."""

import math
import time
from typing import TYPE_CHECKING, Any, Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.measures import GRAVITY
from quadruped_env.report.films.film import size_of
from quadruped_env.report.ground_mesh import (
    add_floor,
    floor_offset,
    floor_plane,
    ground_mesh,
    robot_scene,
    scene_rgb,
)
from quadruped_env.report.palette import ACTUAL, COMMANDED, CONTACT, PUSH, leg_colours
from quadruped_env.robot import Robot
from quadruped_env.simulation import Terrain
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.viewer.snapshot import RobotView, View
from quadruped_env.viewer.viewed_robot import LANE

if TYPE_CHECKING:
    import viser

CONTACT_FORCES, VELOCITIES, TRAILS, NAMES = "contact forces", "velocity arrows", "foot trails", "names"
OVERLAYS: Final = (CONTACT_FORCES, VELOCITIES, TRAILS, NAMES)
"""Overlays of the scene, which can be hidden."""

# Lengths are for a robot of size 1.
_FOLLOW_TIME: Final = 0.3
"""Time constant of the camera, which filters the sway of each step, s."""
_JUMP_DISTANCE: Final = 0.6
"""Distance above which the camera jumps, as after a reset, m."""
_STILL_DISTANCE: Final = 1e-4
"""Distance below which the camera does not move visibly, m."""
_TRAIL_SECONDS: Final = 2.0
_TRAIL_STRIDE: Final = 2
"""Number of samples per trail segment."""
_METRES_PER_WEIGHT: Final = 0.235
"""Length of the arrow for a contact force that equals the robot's weight, m."""
_CONTACT_OFFSET: Final = 0.035
"""Outward offset of force arrows from the contact, so that the leg does not hide them, m."""
_METRES_PER_VELOCITY: Final = 0.6
"""Arrow length for 1 m/s, m."""
_METRES_PER_PUSH: Final = 0.35
"""Arrow length for a push of 1 m/s, m."""
_ARROW_HEIGHT: Final = 0.14
"""Height of velocity arrows above the base's centre, m."""
_TURN_RADII: Final = (0.30, 0.33)
"""Radii of the ground arcs that show the turn in one second, commanded and actual, m."""
_TURN_HEIGHT: Final = 0.004
"""Height of the arcs above the ground, m."""
_ARC_POINTS: Final = 16
_PUSH_SHOWN: Final = 0.8
"""Time for which a push is shown, s."""
_LABEL_HEIGHT: Final = 0.24
"""Height of labels above the base's centre, m."""
_LOOK_AT: Final = (0.0, 0.0, 0.1)
"""Point that the camera looks at, relative to the centre of the robots, m."""
_CAMERAS: Final = ((0.75, -1.45, 0.62), (1.1, -1.9, 1.0), (1.35, -2.3, 1.3))
"""Initial camera positions relative to the centre of one, two or three robots, m."""

Points = NDArray[np.float64]


class Scene:
    """Draws views in the 3D scene, with a model of the robot and its ground, which is modified."""

    def __init__(self, server: "viser.ViserServer", model: mujoco.MjModel, robot: Robot, terrain: Terrain) -> None:
        self.visible = dict.fromkeys(OVERLAYS, True)
        self.follow = True
        self._server = server
        self._size = size_of(robot)
        self._metres_per_newton = self._size * _METRES_PER_WEIGHT / (robot.total_mass * GRAVITY)
        self._leg_colours = [np.array(scene_rgb(colour), np.uint8) for colour in leg_colours(robot).values()]
        self._robots = robot_scene(server, model)
        self._floor_name = floor_plane(model).name
        self._offsets = np.zeros((1, 3))
        self._drawn_at = -math.inf
        self._drawn: tuple[Points, ...] = (np.empty(0),) * 3
        self._push: tuple[float, float, float] | None = None
        self._uneven: Any = None
        self.set_ground(model, terrain)
        self._aim(1)
        server.initial_camera.look_at = tuple(self._size * value for value in _LOOK_AT)
        server.initial_camera.fov = math.radians(45.0)
        one = np.zeros((1, 2, 3), np.float32)
        add = server.scene
        thin = {"shaft_radius": 0.004, "head_radius": 0.011, "head_length": 0.025}
        thick = {"shaft_radius": 0.008, "head_radius": 0.022, "head_length": 0.05}
        self._contacts = add.add_arrows("/overlay/contact", one, scene_rgb(CONTACT), visible=False, **thin)
        self._pushes = add.add_arrows("/overlay/push", one, scene_rgb(PUSH), visible=False, **thick)
        self._velocities = add.add_arrows("/overlay/velocity", one, scene_rgb(COMMANDED), visible=False, **thick)
        self._turns = add.add_line_segments("/overlay/turn", one, scene_rgb(COMMANDED), thickness=0.012, visible=False)
        self._turn_heads = add.add_arrows(
            "/overlay/turn_head",
            one,
            scene_rgb(COMMANDED),
            visible=False,
            shaft_radius=0.001,
            head_radius=0.022,
            head_length=0.045,
        )
        self._trails = add.add_line_segments("/overlay/trail", one, (0, 0, 0), thickness=0.004, visible=False)
        self._labels: list[Any] = []

    def set_ground(self, model: mujoco.MjModel, terrain: Terrain) -> None:
        """Draw the ground of a model, which has this terrain; it replaces the last one."""
        self.terrain = terrain
        """The ground that is drawn."""
        self._field = HeightField.of(model)
        if self._uneven is not None:
            self._uneven.remove()
            self._uneven = None
        if self._field is not None:
            mesh = ground_mesh(self._field)
            self._uneven = self._server.scene.add_mesh_trimesh("/fixed_bodies/terrain", mesh, cast_shadow=False)
        self._floor_height = float(floor_plane(model).pos[2])
        add_floor(self._server, self._floor_name, self._floor_height)
        self._drawn = (np.empty(0),) * 3

    def show_push(self, direction: float, strength: float) -> None:
        """Show an arrow for a push for a moment; see `ViewController.push`."""
        self._push = direction, strength, time.monotonic() + _PUSH_SHOWN

    def update(self, view: View) -> None:
        """Draw a view."""
        robots = view.robots
        lanes = np.zeros((len(robots), 3))
        if self._field is None:
            lanes[:, 1] = LANE * self._size * ((len(robots) - 1) / 2 - np.arange(len(robots)))
        self._go_along(np.array([robot.now.base_position[:2] for robot in robots]), view.watched)
        shift = lanes + self._offsets
        with self._server.atomic():
            self._draw_robots(robots, shift, self._offsets[view.watched])
            self._draw_contacts(robots, shift, view.offered.motion)
            self._draw_velocities(robots, shift)
            self._draw_trails(robots, shift)
            self._draw_push(robots, shift)
            self._draw_labels(robots, shift)

    def _go_along(self, positions: Points, watched: int) -> None:
        """Move each robot's world so that its position (2,) is in the middle of its lane.

        The worlds are moved instead of the cameras, which users control. Robots on uneven ground share the world of the
        watched one.
        """
        now = time.monotonic()
        if len(self._offsets) != len(positions):
            self._offsets = np.zeros((len(positions), 3))
        if self.follow:
            away = -positions - self._offsets[:, :2]
            share = 1.0 - math.exp(-(now - self._drawn_at) / _FOLLOW_TIME)
            distance = np.abs(away).max(axis=1, keepdims=True)
            # Not filtered after a reset, nor below a visible distance: the picture of a standing robot is still.
            self._offsets[:, :2] += away * np.where(
                (distance > _JUMP_DISTANCE) | (distance < _STILL_DISTANCE), 1.0, share
            )
            if self._field is not None:
                self._offsets[:] = self._offsets[watched]
        self._drawn_at = now

    def _aim(self, robots: int) -> None:
        """Set the initial camera of browsers that connect from now on."""
        self._server.initial_camera.position = tuple(self._size * value for value in _CAMERAS[robots - 1])

    def _draw_robots(self, robots: tuple[RobotView, ...], shift: Points, ground: Points) -> None:
        if self._robots.num_envs != len(robots):
            self._robots.num_envs = len(robots)
            self._robots.rebuild_visual_handles()
            add_floor(self._server, self._floor_name, self._floor_height)
            self._aim(len(robots))
        positions = np.stack([robot.body_position + shift[i] for i, robot in enumerate(robots)])
        rotations = np.stack([robot.body_rotation for robot in robots])
        ground = ground.copy()
        if self._field is None:
            ground[:2] = floor_offset(ground[:2])
        drawn = positions, rotations, ground
        if not all(map(np.array_equal, drawn, self._drawn)):
            self._robots.update_from_arrays(positions, rotations)
            self._robots.fixed_bodies_frame.position = ground
            self._drawn = drawn

    def _draw_contacts(self, robots: tuple[RobotView, ...], shift: Points, known: bool) -> None:
        arrows = []
        for i, robot in enumerate(robots):
            left = _direction(robot.heading + math.pi / 2)
            side = np.sign((robot.contact_points - robot.now.base_position) @ left)
            start = robot.contact_points + _CONTACT_OFFSET * self._size * side[:, None] * left + shift[i]
            arrows.append(np.stack([start, start + self._metres_per_newton * robot.contact_forces], axis=1))
        _draw(self._contacts, np.concatenate(arrows), visible=known and self.visible[CONTACT_FORCES])

    def _draw_velocities(self, robots: tuple[RobotView, ...], shift: Points) -> None:
        arrows, arcs, heads = [], [], []
        for i, robot in enumerate(robots):
            above = robot.now.base_position + shift[i] + (0.0, 0.0, _ARROW_HEIGHT * self._size)
            for lane, (velocity, yaw_rate, *lateral) in enumerate((robot.now.command, robot.now.smooth_velocity)):
                # Offset vertically, so that one does not hide the other.
                origin = above + np.array([0.0, 0.0, 0.028 * lane])
                tip = _METRES_PER_VELOCITY * velocity * _direction(robot.heading)
                for v in lateral:
                    tip += _METRES_PER_VELOCITY * v * _direction(robot.heading + math.pi / 2)
                arrows.append([origin, origin + tip])
                ground = 0.0 if self._field is None else self._field.at(robot.now.base_position.astype(np.float64))
                centre = np.array([*above[:2], ground + _TURN_HEIGHT])
                angles = robot.heading + yaw_rate * np.linspace(0.0, 1.0, _ARC_POINTS + 1)
                radius = _TURN_RADII[lane] * self._size
                arc = centre + radius * _direction(angles)
                arcs.append(np.stack([arc[:-1], arc[1:]], axis=1))
                # A short segment beyond the end aligns the arrowhead with the arc.
                beyond = radius * _direction(angles[-1] + math.copysign(0.17, yaw_rate))
                heads.append([arc[-1], centre + beyond])
        visible = self.visible[VELOCITIES]
        colours = np.tile(np.array([scene_rgb(COMMANDED), scene_rgb(ACTUAL)], np.uint8), (len(robots), 1))
        follows = np.array([shown for robot in robots for shown in (robot.follows_command, True)])
        velocities = np.array([v for robot in robots for v in (robot.now.command, robot.now.smooth_velocity)])
        moving = follows & (np.linalg.norm(np.delete(velocities, 1, axis=1), axis=1) > 0.03)
        turning = follows & (np.abs(velocities[:, 1]) > 0.06)
        _draw(self._velocities, np.array(arrows)[moving], colours[moving], visible)
        kept = np.repeat(colours[turning], _ARC_POINTS, axis=0)
        segments = np.array(arcs)[turning].reshape(-1, 2, 3)
        _draw(self._turns, segments, np.repeat(kept[:, None], 2, axis=1), visible)
        _draw(self._turn_heads, np.array(heads)[turning], colours[turning], visible)

    def _draw_trails(self, robots: tuple[RobotView, ...], shift: Points) -> None:
        segments, colours = [], []
        for i, robot in enumerate(robots):
            count = round(_TRAIL_SECONDS / robot.now.timestep)
            # From the present backwards, so that old points stay where they are.
            trail = robot.history[-count:][::-1][::_TRAIL_STRIDE]
            feet = np.array([sample.foot_position for sample in trail]) + shift[i]
            for leg, colour in enumerate(self._leg_colours):
                path = feet[:, leg]
                segments.append(np.stack([path[:-1], path[1:]], axis=1))
                colours.append(np.broadcast_to(colour, (len(path) - 1, 2, 3)))
        _draw(self._trails, np.concatenate(segments), np.concatenate(colours), self.visible[TRAILS])

    def _draw_push(self, robots: tuple[RobotView, ...], shift: Points) -> None:
        """Draw the arrows of the last push, for a moment; each ends at the base."""
        arrows = []
        if self._push is not None and time.monotonic() <= self._push[2]:
            direction, strength, _ = self._push
            for i, robot in enumerate(robots):
                ahead = _direction(robot.heading + direction)
                end = robot.now.base_position + shift[i] - 0.12 * self._size * ahead
                arrows.append([end - _METRES_PER_PUSH * strength * ahead, end])
        _draw(self._pushes, np.array(arrows).reshape(-1, 2, 3))

    def _draw_labels(self, robots: tuple[RobotView, ...], shift: Points) -> None:
        while len(self._labels) > len(robots):
            self._labels.pop().remove()
        while len(self._labels) < len(robots):
            self._labels.append(
                self._server.scene.add_label(f"/overlay/name_{len(self._labels)}", "", anchor="bottom-center")
            )
        for i, robot in enumerate(robots):
            velocity = robot.now.smooth_velocity[0]
            state = f"{velocity:z.1f} m/s" if robot.fell_at is None else "fell"
            text = f"{robot.name}: {state}"
            if self._labels[i].text != text:
                self._labels[i].text = text
            self._labels[i].position = robot.now.base_position + shift[i] + (0.0, 0.0, _LABEL_HEIGHT * self._size)
            self._labels[i].visible = self.visible[NAMES] and len(robots) > 1


def _direction(angle: Any) -> Any:
    """Return the horizontal unit vectors (..., 3) at angles (...,) from the x axis, rad."""
    return np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=-1)


def _draw(handle: Any, points: Points, colours: NDArray[np.uint8] | None = None, visible: bool = True) -> None:
    """Set the arrows or segments (N, 2, 3) of a handle. An empty set is hidden, since viser cannot draw empty arrays.

    Unchanged data is not sent again, so that a still picture causes no traffic.
    """
    visible = visible and bool(len(points))
    points = points.astype(np.float32)
    if visible and not np.array_equal(points, handle.points):
        handle.points = points
    if visible and colours is not None and not np.array_equal(colours, handle.colors):
        handle.colors = colours
    if handle.visible != visible:
        handle.visible = visible
