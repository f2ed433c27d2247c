"""Films of a robot, rendered from recordings, with overlays of command, velocity and gait."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final, Self

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs.rendering import SceneRenderer
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.evaluation.trace import Trace
from quadruped_env.report.films.overlay import Overlay
from quadruped_env.robot import Robot
from quadruped_env.simulation import Terrain, build_model, flat
from quadruped_env.simulation.height_field import GROUND, SURROUNDINGS, HeightField
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.rotations import from_yaw, multiply, rotate, yaw

Picture = NDArray[np.uint8]

WIDTH, HEIGHT = 640, 480
FRAME_RATE: Final = 25
"""Frames per second: half the control rate. A frame lasts 4 hundredths of a second, the unit of time in a GIF."""

# Chosen with tools/render_speed.py: the sharpest shadow that a software renderer draws with multisampling on one core
# at well over 40 frames per second. Reflections are off because they render the scene twice. The ground is finite
# because software renderers leave dark specks on an infinite plane. Its squares are large because MuJoCo's default
# size doubles the rendering time.
SHADOW_SIZE: Final = 1024
MULTISAMPLES: Final = 4
_SLICES, _STACKS = 20, 12
"""Facets around and along spheres and cylinders. MuJoCo's defaults, 28 and 16, look the same at this size and take 10 %
longer."""
_GROUND_HALF_SIZE: Final = 40.0
"""Half the side of the ground, m."""
_GROUND_SQUARE: Final = 10.0
"""Side of the squares into which MuJoCo divides the ground, m."""

_FAR: Final = 12.0
"""Far clipping plane, in model extents. Farther away, the shadow map's depth is so coarse that the robot casts false
shadows on itself."""

_UNIT_HEIGHT: Final = 0.184
"""Height of the base in the stance of a robot of size 1, m."""
_VIEW: Final = (115.0, -17.0, 0.95, 0.08)
"""Azimuth and elevation of the camera in degrees, its distance from the point that it looks at in m, and the height of
this point over the ground in m, for a robot of size 1. The robot walks slightly towards the viewer, no leg hides
another, and there is room for the overlay."""
_SMOOTHING: Final = 0.25
"""Half the window over which the camera's position is averaged, s: it follows the robot without shaking with each
stride."""


def size_of(robot: Robot) -> float:
    """Return the size of a robot, which scales lengths of pictures: the height of its base over `_UNIT_HEIGHT`."""
    return robot.stance_height / _UNIT_HEIGHT


@dataclass(frozen=True)
class Clip:
    """Part of a film: the trace of one env, and its title."""

    title: str
    trace: Trace

    @classmethod
    def of_rollout(cls, rollout: Rollout, row: int, title: str, start: float = 0.0, stop: float = np.inf) -> Self:
        """Return the part of an episode (its index in the rollout) from `start` to `stop`, s, or to its fall."""
        one = rollout.env(row)
        last = min(int(one.valid.sum()) + 1, len(one))
        first = min(round(start / one.timestep), last - 1)
        return cls(title, facing_ahead(one.window(first, round(min(stop / one.timestep, last)))))

    def frame_samples(self) -> NDArray[np.intp]:
        """Return the indices of the samples that a film at `FRAME_RATE` shows."""
        times = np.arange(0.0, self.trace.seconds - 1e-9, 1.0 / FRAME_RATE)
        return np.minimum(np.round(times / self.trace.timestep), len(self.trace) - 1).astype(np.intp)


def facing_ahead(trace: Trace) -> Trace:
    """Return a trace of one env, rotated and translated in the plane so that it begins at the origin and faces along x.

    A trace on uneven ground stays where it is.
    """
    if trace.terrain != flat:
        return trace
    pose = trace.base_pose.astype(np.float64)
    back = from_yaw(-yaw(pose[0, 3:]))
    pose[:, :2] -= pose[0, :2]
    pose[:, :3] = rotate(back, pose[:, :3])
    pose[:, 3:] = multiply(back, pose[:, 3:])
    return replace(trace, base_pose=pose)


def smoothed_position(trace: Trace, sample: int) -> NDArray[np.float64]:
    """Return x and y of the base around a sample, averaged over time so that a camera can follow it, m (2,)."""
    around = round(_SMOOTHING / trace.timestep)
    return trace.base_pose[max(0, sample - around) : sample + around + 1, :2].mean(axis=0, dtype=np.float64)


class Camera:
    """Renders clips with a camera that follows the robot; a QuadrupedError if OpenGL is not available.

    The shadow map's side is in pixels, 0 for no shadow.
    """

    def __init__(self, robot: Robot, shadow_size: int = SHADOW_SIZE, multisamples: int = MULTISAMPLES) -> None:
        self._robot = robot
        self._quality = shadow_size, multisamples
        self._set_up(flat)

    def _set_up(self, terrain: Terrain) -> None:
        """Create the model and the renderer for a terrain."""
        shadow_size, multisamples = self._quality
        self._terrain = terrain
        self._model = build_model(terrain=terrain, robot=self._robot)
        self._height_field = HeightField.of(self._model)
        self._model.mat_reflectance[:] = 0.0
        self._model.vis.quality.shadowsize = shadow_size
        self._model.vis.quality.offsamples = multisamples
        self._model.vis.quality.numslices, self._model.vis.quality.numstacks = _SLICES, _STACKS
        self._model.vis.map.zfar = _FAR
        self._ground = self._model.geom(GROUND if self._height_field is None else SURROUNDINGS).id
        self._model.geom_size[self._ground] = _GROUND_HALF_SIZE, _GROUND_HALF_SIZE, _GROUND_SQUARE
        # A plane's uniform texture repeats over 2 m.
        self._ground_step = 2.0 / self._model.mat_texrepeat[self._model.geom_matid[self._ground]]
        # Without this MuJoCo uses the ground's position at compile time and ignores `geom_pos`.
        self._model.geom_sameframe[self._ground] = mujoco.mjtSameFrame.mjSAMEFRAME_NONE
        self._data = mujoco.MjData(self._model)
        self._view = mujoco.MjvCamera()
        self._renderer = SceneRenderer(self._model, self._data, "rgb_array", WIDTH, HEIGHT)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Free the OpenGL context."""
        self._renderer.close()

    def picture(self, trace: Trace, sample: int) -> Picture:
        """Return the picture of the robot (HEIGHT, WIDTH, 3) at a sample (its index) of a trace of one env."""
        if trace.terrain != self._terrain:
            self.close()
            self._set_up(trace.terrain)
        self._data.qpos[:7] = trace.base_pose[sample]
        self._data.qpos[7:] = trace.joint_position[sample]
        # The ground follows the robot in steps of its texture's period, which are invisible, so that it never ends.
        steps = np.round(self._data.qpos[:2] / self._ground_step)
        self._model.geom_pos[self._ground, :2] = steps * self._ground_step
        mujoco.mj_forward(self._model, self._data)
        centre = smoothed_position(trace, sample)
        size = size_of(self._robot)
        self._view.azimuth, self._view.elevation, distance, height = _VIEW
        self._view.distance = size * distance
        self._view.lookat[:] = *centre, size * height
        if self._height_field is not None:
            self._view.lookat[2] += self._height_field.at(centre)
            # The robot of a trace on uneven ground begins with any heading.
            self._view.azimuth += math.degrees(yaw(trace.base_pose[0, 3:]))
        picture = self._renderer.render(self._data, self._view)
        assert picture is not None
        return picture

    def film(self, clips: Sequence[Clip], progress: Progress | None = None) -> Iterator[Picture]:
        """Yield the pictures (HEIGHT, WIDTH, 3) of clips one after another at `FRAME_RATE`, with overlays.

        `progress` is called with the fraction done.
        """
        total, done = sum(len(clip.frame_samples()) for clip in clips), 0
        for clip in clips:
            overlay = Overlay(clip.title, clip.trace)
            for sample in clip.frame_samples():
                yield overlay.draw(self.picture(clip.trace, sample), sample)
                done += 1
                if progress is not None:
                    progress(done / total)
