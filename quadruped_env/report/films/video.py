"""Video files: MP4 for browsers and presentations, animated WebP for READMEs."""

import importlib
import io
import itertools
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, Final

import mujoco

from quadruped_env.envs.rendering import SceneRenderer
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.report.films.film import FRAME_RATE, HEIGHT, WIDTH, Camera, Clip, Picture
from quadruped_env.utils.files import check_free, write_whole
from quadruped_env.utils.progress import Progress

SUFFIXES: Final = (".mp4", ".webp")
_PAGE_WIDTH: Final = 480
"""Maximum width of an animated WebP, pixels: small enough to load quickly in a README."""
_ENCODER: Final = "libx264"
# Constant quality; at 25, flat colours have no visible artefacts.
_OPTIONS: Final = {"crf": "25", "preset": "superfast", "movflags": "+faststart"}


def prepare_video(path: Path | None, overwrite: bool = False) -> None:
    """Check that a video can be written, before any long computation.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if the file's suffix is not in `SUFFIXES`, the file exists and `overwrite` is false, or OpenGL
            is not available.
    """
    if path is None:
        return
    if path.suffix not in SUFFIXES:
        raise QuadrupedError(
            f"{path}: a video's name ends in {' or '.join(SUFFIXES)}; found {path.suffix or 'no ending'!r}"
        )
    check_free([path], overwrite)
    _library("PIL.Image")
    if path.suffix == ".mp4":
        _library("av")
    model = mujoco.MjSpec().compile()
    SceneRenderer(model, mujoco.MjData(model), "rgb_array", WIDTH, HEIGHT).close()


def save_film(path: Path, clips: Sequence[Clip], progress: Progress | None = None) -> None:
    """Write a film of several clips of a robot, one after another, in the format of the file's suffix.

    Raises:
        QuadrupedError, MissingExtraError: as `prepare_video`, or if the file cannot be written.
    """
    with Camera(clips[0].trace.robot) as camera:
        save_video(path, camera.film(clips, progress))


def save_video(path: Path, pictures: Iterable[Picture]) -> None:
    """Write pictures (H, W, 3) at `FRAME_RATE`, in the format of the file's suffix.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if there is no picture, the file cannot be written, or PyAV was built without the encoder.
    """
    encode = encode_mp4 if path.suffix == ".mp4" else _encode_webp
    write_whole({path: encode(pictures)})


def encode_mp4(pictures: Iterable[Picture]) -> bytes:
    """Encode pictures (H, W, 3) with even sides as an H.264 video, which every browser plays."""
    av = _library("av")
    first, pictures = _first(pictures)
    file = io.BytesIO()
    with av.open(file, "w", format="mp4") as container:
        try:
            stream = container.add_stream(_ENCODER, rate=FRAME_RATE, options=dict(_OPTIONS))
        except av.codec.codec.UnknownCodecError as error:
            raise QuadrupedError(
                f"PyAV {av.__version__} has no encoder {_ENCODER!r}; its wheel has: "
                f"pip install --force-reinstall --only-binary av av"
            ) from error
        stream.height, stream.width = first.shape[:2]
        stream.pix_fmt = "yuv420p"
        for picture in pictures:
            container.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        container.mux(stream.encode(None))
    return file.getvalue()


def _encode_webp(pictures: Iterable[Picture]) -> bytes:
    """Encode pictures as an animated WebP, scaled down to `_PAGE_WIDTH` if they are wider."""
    image = _library("PIL.Image")
    _, pictures = _first(pictures)
    images = []
    for picture in pictures:
        full = image.fromarray(picture)
        scale = min(1.0, _PAGE_WIDTH / full.width)
        images.append(full.resize((round(full.width * scale), round(full.height * scale)), image.Resampling.LANCZOS))
    file, duration = io.BytesIO(), round(1000 / FRAME_RATE)
    images[0].save(
        file, "WEBP", save_all=True, append_images=images[1:], duration=duration, loop=0, quality=70, method=4
    )
    return file.getvalue()


def _first(pictures: Iterable[Picture]) -> tuple[Picture, Iterator[Picture]]:
    """Return the first of the pictures, and all of them."""
    rest = iter(pictures)
    first = next(rest, None)
    if first is None:
        raise QuadrupedError("a video needs at least one picture; found none")
    return first, itertools.chain([first], rest)


def _library(name: str) -> Any:
    """Import Pillow or PyAV; a MissingExtraError if it is not installed."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise MissingExtraError("A video", "report") from error
