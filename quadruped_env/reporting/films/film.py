"""Films of a robot: rendered from what was recorded, with the command, the speed and the gait drawn in."""

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final, Self

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs.rendering import SceneRenderer
from quadruped_env.evaluation.episode import Recording
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.progress import Progress
from quadruped_env.reporting.films.overlay import Overlay
from quadruped_env.robot import load_model
from quadruped_env.rotations import from_yaw, multiply, rotate, yaw

Picture = NDArray[np.uint8]

WIDTH, HEIGHT = 640, 480
FRAME_RATE: Final = 25
"""1/s; half the control rate, and a whole number of the hundredths of a second that a GIF counts in"""

# Chosen with tools/render_speed.py: on one core the sharpest shadow that a software renderer draws smoothed at well
# over 40 frames a second. Reflections would draw the scene once more. On an endless plane software renderers leave
# dark specks, and MuJoCo cuts a plane into squares of which the default size costs half of the time.
SHADOW_SIZE: Final = 1024
MULTISAMPLES: Final = 4
_SLICES, _STACKS = 20, 12
"""Around and along balls and cylinders: MuJoCo's 28 and 16 look the same in this size, and take a tenth longer"""
_GROUND_HALF_SIZE: Final = 40.0
"""m"""
_GROUND_SQUARE: Final = 10.0
"""m"""

_FAR: Final = 12.0
"""Extents of the scene that the camera and the light see: farther, the shadows become too coarse in depth for the robot
not to throw some on itself"""

_VIEW_AZIMUTH: Final = 115.0
"""Degrees, of the direction of view: the robot comes out of the picture a little, and no leg hides another"""
_VIEW_ELEVATION: Final = -17.0
_VIEW_DISTANCE: Final = 0.95
"""m"""
_VIEW_HEIGHT: Final = 0.08
"""m over the ground of the point that the camera looks at, which leaves room for the overlay"""
_STEADY: Final = 0.25
"""s before and after, over which the camera's way is a mean: it goes along, but does not shake with each stride"""


@dataclass(frozen=True)
class Motion:
    """One robot over time, as a film shows it: T samples."""

    title: str
    timestep: float
    """s between samples"""
    base_pose: NDArray[np.floating]
    """Position in m and quaternion wxyz of the base in the world (T, 7)"""
    joint_position: NDArray[np.floating]
    """rad (T, 8)"""
    velocity: NDArray[np.floating] | None = None
    """Forward velocity in m/s and yaw rate in rad/s (T, 2), if known"""
    command: NDArray[np.floating] | None = None
    """What these should be (T, 2), for a robot that follows a command"""
    contact: NDArray[np.bool_] | None = None
    """Whether each foot is on the ground (T, 4), if known"""

    @classmethod
    def of_rollout(cls, rollout: Rollout, row: int, title: str, start: float = 0.0, stop: float = np.inf) -> Self:
        """An episode of a rollout from one time (s) to another, or to its fall."""
        last = min(int(rollout.valid[:, row].sum()) + 1, len(rollout.valid))
        part = slice(min(round(start / rollout.timestep), last - 1), round(min(stop / rollout.timestep, last)))
        position, orientation = rollout.base_position[part, row], rollout.orientation[part, row]
        return cls(
            title,
            rollout.timestep,
            np.concatenate([position, orientation], axis=1),
            rollout.joint_position[part, row],
            np.stack([rollout.linear_velocity_b[part, row, 0], rollout.yaw_rate[part, row]], axis=1),
            np.broadcast_to(rollout.command[row], (len(position), 2)),
            rollout.contact[part, row],
        ).facing_ahead()

    @classmethod
    def of_recording(cls, recording: Recording, title: str) -> Self:
        """A recording, from its start."""
        joints = recording.joints
        timestep = joints.duration / max(len(joints) - 1, 1)
        return cls(
            title, timestep, recording.base_pose, joints.positions, recording.velocity, contact=recording.contact
        )

    @property
    def seconds(self) -> float:
        """How long it lasts."""
        return len(self.base_pose) * self.timestep

    def facing_ahead(self) -> Self:
        """The same motion, turned and moved on the plane to begin at the origin, facing along x."""
        pose = self.base_pose.astype(np.float64)
        back = from_yaw(-yaw(pose[0, 3:]))
        pose[:, :2] -= pose[0, :2]
        pose[:, :3] = rotate(back, pose[:, :3])
        pose[:, 3:] = multiply(back, pose[:, 3:])
        return replace(self, base_pose=pose)

    def frame_samples(self) -> NDArray[np.intp]:
        """Indices of the samples that a film at `FRAME_RATE` shows."""
        times = np.arange(0.0, self.seconds - 1e-9, 1.0 / FRAME_RATE)
        return np.minimum(np.round(times / self.timestep), len(self.base_pose) - 1).astype(np.intp)


def steady_way(motion: Motion, sample: int) -> NDArray[np.float64]:
    """Where a camera that goes along with the base is at a sample: x and y in m, (2,)."""
    around = round(_STEADY / motion.timestep)
    return motion.base_pose[max(0, sample - around) : sample + around + 1, :2].mean(axis=0, dtype=np.float64)


class Camera:
    """Renders motions with a camera that goes along with the robot.

    Args:
        shadow_size: pixels of a side of the shadow map; 0 for no shadow.
        multisamples: samples a pixel.

    Raises:
        QuadrupedError: if there is no OpenGL.
    """

    def __init__(self, shadow_size: int = SHADOW_SIZE, multisamples: int = MULTISAMPLES) -> None:
        self._model = load_model()
        self._model.mat_reflectance[:] = 0.0
        self._model.vis.quality.shadowsize = shadow_size
        self._model.vis.quality.offsamples = multisamples
        self._model.vis.quality.numslices, self._model.vis.quality.numstacks = _SLICES, _STACKS
        self._model.vis.map.zfar = _FAR
        self._ground = self._model.geom("ground").id
        self._model.geom_size[self._ground] = _GROUND_HALF_SIZE, _GROUND_HALF_SIZE, _GROUND_SQUARE
        # A plane's uniform texture repeats over 2 m.
        self._ground_step = 2.0 / self._model.mat_texrepeat[self._model.geom_matid[self._ground]]
        # Without this MuJoCo takes the ground's place from the compiler, and not from the model's field.
        self._model.geom_sameframe[self._ground] = mujoco.mjtSameFrame.mjSAMEFRAME_NONE
        self._data = mujoco.MjData(self._model)
        self._view = mujoco.MjvCamera()
        self._view.azimuth, self._view.elevation, self._view.distance = _VIEW_AZIMUTH, _VIEW_ELEVATION, _VIEW_DISTANCE
        self._renderer = SceneRenderer(self._model, self._data, "rgb_array", WIDTH, HEIGHT)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Free the OpenGL context."""
        self._renderer.close()

    def picture(self, motion: Motion, sample: int) -> Picture:
        """The robot at one sample (HEIGHT, WIDTH, 3), without overlays."""
        self._data.qpos[:7] = motion.base_pose[sample]
        self._data.qpos[7:] = motion.joint_position[sample]
        # The ground goes along in steps of its pattern, which nobody sees, so that no robot walks over its edge.
        steps = np.round(self._data.qpos[:2] / self._ground_step)
        self._model.geom_pos[self._ground, :2] = steps * self._ground_step
        mujoco.mj_forward(self._model, self._data)
        self._view.lookat[:] = *steady_way(motion, sample), _VIEW_HEIGHT
        picture = self._renderer.render(self._data, self._view)
        assert picture is not None
        return picture

    def film(self, motion: Motion) -> Iterator[Picture]:
        """Pictures (HEIGHT, WIDTH, 3) of a motion, `FRAME_RATE` a second, with overlays.

        Raises:
            MissingExtraError: if Pillow is not installed.
        """
        overlay = Overlay(motion.title, motion.timestep, motion.velocity, motion.command, motion.contact)
        for sample in motion.frame_samples():
            yield overlay.draw(self.picture(motion, sample), sample)

    def films(self, motions: Sequence[Motion], progress: Progress | None = None) -> Iterator[Picture]:
        """One film of several motions, and how far it is."""
        total = sum(len(motion.frame_samples()) for motion in motions)
        pictures = itertools.chain.from_iterable(map(self.film, motions))
        for number, picture in enumerate(pictures, 1):
            yield picture
            if progress is not None:
                progress(number / total)
