"""Videos of rollouts: rendered from what was recorded, encoded as MP4 with H.264."""

import io
import itertools
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs.rendering import SceneRenderer
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.evaluation.metrics import heading_of
from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.robot import load_model

WIDTH, HEIGHT = 640, 480
FRAME_RATE: Final = 25
_GROUND: Final = 10.0
"""m from the origin to the edge of the ground in a picture"""
_ENCODER: Final = "libx264"
# Constant quality; 25 leaves no visible trace on flat colours.
_OPTIONS: Final = {"crf": "25", "preset": "veryfast", "movflags": "+faststart"}


def encode_mp4(frames: Iterable[NDArray[np.uint8]], frame_rate: int = FRAME_RATE) -> bytes:
    """A video that every browser plays, from pictures (height, width, 3) with even sides.

    Raises:
        MissingExtraError: if PyAV is not installed.
        QuadrupedError: if there is no picture, or PyAV was built without the encoder.
    """
    try:
        import av
    except ImportError as error:
        raise MissingExtraError("A video", "report") from error

    frames = iter(frames)
    first = next(frames, None)
    if first is None:
        raise QuadrupedError("encode_mp4: expected at least one picture; found none")
    file = io.BytesIO()
    with av.open(file, "w", format="mp4") as container:
        try:
            stream = container.add_stream(_ENCODER, rate=frame_rate, options=dict(_OPTIONS))
        except av.codec.codec.UnknownCodecError as error:
            raise QuadrupedError(
                f"PyAV {av.__version__} has no encoder {_ENCODER!r}; its wheel has: "
                f"pip install --force-reinstall --only-binary av av"
            ) from error
        stream.height, stream.width = first.shape[:2]
        stream.pix_fmt = "yuv420p"
        for picture in itertools.chain([first], frames):
            container.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        container.mux(stream.encode(None))
    return file.getvalue()


def write_png(path: Path, picture: NDArray[np.uint8]) -> None:
    """Write a picture (height, width, 3).

    Raises:
        MissingExtraError: if matplotlib is not installed.
    """
    try:
        from matplotlib.image import imsave
    except ImportError as error:
        raise MissingExtraError("A picture", "report") from error
    imsave(path, picture)


class RolloutRenderer:
    """Draws rows of rollouts.

    Raises:
        QuadrupedError: if there is no OpenGL.
    """

    def __init__(self) -> None:
        self._model = load_model()
        # A software renderer draws the scene once for the mirror and once for the shadow: the first goes, the
        # second gets coarser, and frames come in two thirds of the time.
        self._model.mat_reflectance[:] = 0.0
        self._model.vis.quality.shadowsize = 1024
        # On an endless plane, software renderers sometimes leave dark specks.
        self._model.geom_size[self._model.geom("ground").id, :2] = _GROUND
        self._data = mujoco.MjData(self._model)
        self._renderer = SceneRenderer(self._model, self._data, "rgb_array", WIDTH, HEIGHT)

    def clip(self, rollout: Rollout, row: int, start: float, stop: float) -> Iterator[NDArray[np.uint8]]:
        """Pictures (HEIGHT, WIDTH, 3) of a row from one time to another, s.

        The robot begins its episodes facing anywhere. On a plane that makes no difference, so the whole recording is
        turned and moved to begin at the origin, facing the +x direction of the world.
        """
        times = np.arange(start, min(stop, rollout.seconds) - 1e-9, 1.0 / FRAME_RATE)
        samples = np.round(times / rollout.timestep).astype(np.intp)
        position = rollout.base_position[samples, row].astype(np.float64)
        orientation = rollout.orientation[samples, row].astype(np.float64)
        angle = -heading_of(orientation[:, None])[0, 0]
        c, s = np.cos(angle), np.sin(angle)
        position[:, :2] -= position[0, :2]
        position[:, :2] = position[:, :2] @ np.array([[c, s], [-s, c]])
        turn = np.array([np.cos(angle / 2), 0.0, 0.0, np.sin(angle / 2)])
        for i, sample in enumerate(samples):
            self._data.qpos[:3] = position[i]
            mujoco.mju_mulQuat(self._data.qpos[3:7], turn, orientation[i])
            self._data.qpos[7:] = rollout.joint_position[sample, row]
            mujoco.mj_forward(self._model, self._data)
            picture = self._renderer.render(self._data)
            assert picture is not None
            yield picture

    def close(self) -> None:
        """Free the OpenGL context."""
        self._renderer.close()
