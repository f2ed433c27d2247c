"""Video and image files: MP4 for browsers, GIF and animated WebP for READMEs, PNG stills."""

import io
import itertools
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.report.films.film import FRAME_RATE, Camera, Clip, Picture, check_opengl
from quadruped_env.utils.files import check_free, write_whole
from quadruped_env.utils.progress import Progress

SUFFIXES: Final = (".mp4", ".gif", ".webp", ".png")
STILLS: Final = 4
"""Number of pictures side by side in a PNG."""
_PAGE_WIDTH: Final = 480
"""Maximum width of a GIF or animated WebP, pixels: small enough to load quickly in a README."""
_PALETTE_PICTURES: Final = 8
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
            f"{path}: a video's name ends in {', '.join(SUFFIXES)}; found {path.suffix or 'no ending'!r}"
        )
    check_free([path], overwrite)
    _pillow()
    if path.suffix == ".mp4":
        _pyav()
    check_opengl()


def save_film(path: Path, clips: Sequence[Clip], progress: Progress | None = None) -> None:
    """Write a film of several clips of a robot, one after another, in the format of the file's suffix.

    A PNG holds `STILLS` pictures from within the clips, side by side.

    Raises:
        QuadrupedError, MissingExtraError: as `prepare_video`, or if the file cannot be written.
    """
    with Camera(clips[0].trace.robot) as camera:
        stills = path.suffix == ".png"
        save_video(path, camera.stills(clips, STILLS) if stills else camera.films(clips, progress))


def save_video(path: Path, pictures: Iterable[Picture]) -> None:
    """Write pictures (H, W, 3) at `FRAME_RATE`, in the format of the file's suffix.

    Raises:
        MissingExtraError: if a library of the `report` extra is not installed.
        QuadrupedError: if there is no picture, the file cannot be written, or PyAV was built without the encoder.
    """
    encoders = {".mp4": encode_mp4, ".gif": _encode_gif, ".webp": _encode_moving_webp, ".png": _encode_stills}
    write_whole({path: encoders[path.suffix](pictures)})


def encode_mp4(pictures: Iterable[Picture]) -> bytes:
    """Encode pictures (H, W, 3) with even sides as an H.264 video, which every browser plays."""
    av = _pyav()
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


def _encode_gif(pictures: Iterable[Picture]) -> bytes:
    # One palette for all pictures: with a palette per picture the ground would flicker.
    images = _page_images(pictures)
    several = np.concatenate([np.asarray(image) for image in images[:: max(1, len(images) // _PALETTE_PICTURES)]])
    palette = _pillow().fromarray(several).quantize(255)
    return _animation([image.quantize(palette=palette, dither=0) for image in images], "GIF", optimize=True)


def _encode_moving_webp(pictures: Iterable[Picture]) -> bytes:
    return _animation(_page_images(pictures), "WEBP", quality=70, method=4)


def _animation(images: list[Any], kind: str, **options: Any) -> bytes:
    file = io.BytesIO()
    images[0].save(
        file, kind, save_all=True, append_images=images[1:], duration=round(1000 / FRAME_RATE), loop=0, **options
    )
    return file.getvalue()


def _page_images(pictures: Iterable[Picture]) -> list[Any]:
    """Pictures as Pillow images, scaled down to `_PAGE_WIDTH` if they are wider."""
    image = _pillow()
    _, pictures = _first(pictures)
    images = []
    for picture in pictures:
        full = image.fromarray(picture)
        scale = min(1.0, _PAGE_WIDTH / full.width)
        images.append(full.resize((round(full.width * scale), round(full.height * scale)), image.Resampling.LANCZOS))
    return images


def _encode_stills(pictures: Iterable[Picture]) -> bytes:
    """All pictures at half size, side by side."""
    _, pictures = _first(pictures)
    file = io.BytesIO()
    row = np.concatenate([halved(picture) for picture in pictures], axis=1)
    _pillow().fromarray(row).save(file, "PNG", optimize=True)
    return file.getvalue()


def halved(picture: Picture) -> Picture:
    """A picture (H, W, 3) with even sides, at half its size."""
    height, width = picture.shape[:2]
    quarters = picture.reshape(height // 2, 2, width // 2, 2, 3)
    return quarters.mean(axis=(1, 3)).round().astype(np.uint8)


def _first(pictures: Iterable[Picture]) -> tuple[Picture, Iterator[Picture]]:
    """The first of the pictures, and all of them."""
    rest = iter(pictures)
    first = next(rest, None)
    if first is None:
        raise QuadrupedError("a video needs at least one picture; found none")
    return first, itertools.chain([first], rest)


def _pillow() -> Any:
    try:
        from PIL import Image
    except ImportError as error:
        raise MissingExtraError("A video", "report") from error
    return Image


def _pyav() -> Any:
    try:
        import av
    except ImportError as error:
        raise MissingExtraError("A video", "report") from error
    return av
