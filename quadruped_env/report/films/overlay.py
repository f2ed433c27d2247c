"""Overlays of films: title and time, commanded and measured velocity, and the feet on the ground."""

import math
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import MissingExtraError
from quadruped_env.evaluation.trace import Trace
from quadruped_env.report.palette import ACTUAL, COMMANDED, GREY, INK, leg_colours
from quadruped_env.robot import Robot

AVERAGED: Final = 0.5
"""Window over which the shown velocity is averaged, about a stride, s."""
GAIT_SECONDS: Final = 2.0
"""Time span of the gait diagram, s."""

MEASURED_LEGEND: Final = f"measured, mean of {AVERAGED:g} s"
COMMANDED_LEGEND: Final = "commanded"
GAIT_LEGEND: Final = f"feet on the ground, last {GAIT_SECONDS:g} s"

_HEAD_HEIGHT, _PANEL_HEIGHT = 32, 94
_ROW_HEIGHT: Final = 28
"""Height of a velocity's row; the panel is higher for more than two, pixels."""
_MARGIN: Final = 14
_AIR: Final = 232
"""Grey level of a foot in the air."""
_LEGEND_BOTTOM: Final = 12
"""Middle of the legend, from the bottom of the panel, pixels."""
_GAIT_HEIGHT: Final = 60
"""Height of the gait diagram, pixels."""
_BAND_SHARE: Final = 0.75
"""Height of a foot's band, relative to the distance from one band to the next."""
_GAIT_TOP: Final = 10
"""Distance of the gait diagram from the top of the panel, pixels."""
_GAIT_WIDTH: Final = 250
"""Width of the gait diagram, pixels; it is narrower next to long names of legs."""
_GAIT_LEFT: Final = 325
"""Left end of the names of the legs, at the right of the velocities, pixels."""
_BAR_LEFT, _BAR_RIGHT = 78, 204
_QUANTITIES: Final = (("forward", "m/s", 0.6), ("turning", "rad/s", 1.0), ("sideways", "m/s", 0.6))
"""Label, unit, and absolute velocity at the ends of the bar, of each of the `VELOCITIES`."""


class Overlay:
    """Draws the overlays on pictures of one clip: of the quantities that its trace knows.

    Raises:
        MissingExtraError: if Pillow is not installed.
    """

    def __init__(self, title: str, trace: Trace) -> None:
        try:
            from PIL import Image, ImageDraw, ImageFont
        except ImportError as error:
            raise MissingExtraError("A film", "report") from error
        self._to_image, self._pen_for = Image.fromarray, ImageDraw.Draw
        self._font, self._small = ImageFont.load_default(16), ImageFont.load_default(13)
        self._smallest = ImageFont.load_default(12)
        robot, velocity = trace.robot, trace.velocity
        self._robot = robot
        self._names_width = max(math.ceil(self._small.getlength(name)) for name in robot.leg_names)
        self._title = title
        self._timestep = trace.timestep
        self._command = trace.command
        self._velocity = None if velocity is None else trailing_mean(velocity, round(AVERAGED / trace.timestep))
        self._rows = 0 if velocity is None else velocity.shape[1]
        self._height = _PANEL_HEIGHT + _ROW_HEIGHT * max(0, self._rows - 2)
        self._gait = None if trace.contact is None else gait_strip(robot, trace.contact, trace.timestep)

    def draw(self, picture: NDArray[np.uint8], sample: int) -> NDArray[np.uint8]:
        """Return the picture (H, W, 3) of a sample, with overlays."""
        picture = picture.copy()
        # Only the edges are converted to Pillow images: converting the whole picture takes as long as drawing.
        head, panel = picture[:_HEAD_HEIGHT], picture[-self._height :]
        image = self._to_image(head)
        pen = self._pen_for(image)
        pen.text((_MARGIN, 10), self._title, fill=INK, font=self._font)
        clock = f"{(sample + 1) * self._timestep:.1f} s"
        pen.text((picture.shape[1] - _MARGIN, 10), clock, fill=INK, font=self._font, anchor="ra")
        head[:] = image
        if self._velocity is not None or self._gait is not None:
            # Blend with white at 7/8, in fast integer arithmetic.
            image = self._to_image((panel >> 3) + 223)
            pen = self._pen_for(image)
            for row in range(self._rows):
                self._draw_velocity(pen, row, sample, 14 + _ROW_HEIGHT * row)
            if self._gait is not None:
                width = max(1, min(_GAIT_WIDTH, image.width - _MARGIN - _GAIT_LEFT - self._names_width - 6))
                left = image.width - _MARGIN - width
                for (top, bottom), name in zip(_bands(self._robot), self._robot.leg_names, strict=True):
                    at = left - 6, _GAIT_TOP + (top + bottom) // 2
                    pen.text(at, name, fill=INK, font=self._small, anchor="rm")
                end = max(1, round((sample + 1) * self._timestep / GAIT_SECONDS * _GAIT_WIDTH))
                strip = self._to_image(np.ascontiguousarray(self._gait[:, max(0, end - width) : end]))
                image.paste(strip, (image.width - _MARGIN - strip.width, _GAIT_TOP))
                at = image.width - _MARGIN, image.height - _LEGEND_BOTTOM
                pen.text(at, GAIT_LEGEND, fill=GREY, font=self._smallest, anchor="rm")
            if self._velocity is not None:
                self._draw_legend(pen, image.height - _LEGEND_BOTTOM)
            panel[:] = image
        return picture

    def _draw_velocity(self, pen: Any, row: int, sample: int, top: int) -> None:
        """Draw a bar from zero to the velocity, a mark at its command, and both as numbers."""
        assert self._velocity is not None
        label, unit, end = _QUANTITIES[row]
        value = float(self._velocity[sample, row])
        middle = (_BAR_LEFT + _BAR_RIGHT) / 2

        def place(velocity: float) -> float:
            return middle + float(np.clip(velocity / end, -1.0, 1.0)) * (_BAR_RIGHT - _BAR_LEFT) / 2

        pen.text((_MARGIN, top + 8), label, fill=INK, font=self._small, anchor="lm")
        pen.rectangle((_BAR_LEFT, top + 1, _BAR_RIGHT, top + 15), fill=(_AIR,) * 3)
        left, right = sorted((middle, place(value)))
        pen.rectangle((left, top + 1, right, top + 15), fill=ACTUAL)
        pen.line((middle, top, middle, top + 16), fill=(150,) * 3)
        text = f"{value:z.2f} {unit}"
        if self._command is not None:
            asked = float(self._command[sample, row])
            pen.line((place(asked), top - 3, place(asked), top + 19), fill=COMMANDED, width=3)
            text = f"{value:z.2f} of {asked:z.2f} {unit}"
        pen.text((_BAR_RIGHT + 10, top + 8), text, fill=INK, font=self._small, anchor="lm")

    def _draw_legend(self, pen: Any, top: int) -> None:
        """Name the bar and the mark, in their colours."""
        at, font = (_BAR_LEFT, top), self._smallest
        pen.text(at, MEASURED_LEGEND, fill=ACTUAL, font=font, anchor="lm")
        if self._command is not None:
            right = _BAR_LEFT + 12 + font.getlength(MEASURED_LEGEND)
            pen.text((right, top), COMMANDED_LEGEND, fill=COMMANDED, font=font, anchor="lm")


def trailing_mean(values: NDArray[np.floating], window: int) -> NDArray[np.float64]:
    """Return the means over the last `window` samples of values (T, K), over fewer samples at the beginning, (T, K)."""
    total = np.concatenate([np.zeros((1, values.shape[1])), np.cumsum(values, axis=0, dtype=np.float64)])
    stop = np.arange(1, len(values) + 1)
    start = np.maximum(stop - window, 0)
    return (total[stop] - total[start]) / (stop - start)[:, None]


def _bands(robot: Robot) -> list[tuple[int, int]]:
    """Return the top and bottom of each foot's band in the gait diagram, pixels; thinner for more feet."""
    step = _GAIT_HEIGHT // robot.num_legs
    return [(step * leg, step * leg + max(1, int(_BAND_SHARE * step))) for leg in range(robot.num_legs)]


def gait_strip(robot: Robot, contact: NDArray[np.bool_], timestep: float) -> NDArray[np.uint8]:
    """Return the gait diagram of a trace as a picture: one band per foot, coloured while it is on the ground (T, L).

    `GAIT_SECONDS` are `_GAIT_WIDTH` pixels.
    """
    columns = max(1, round(len(contact) * timestep / GAIT_SECONDS * _GAIT_WIDTH))
    samples = np.arange(columns) * len(contact) // columns
    strip = np.full((_GAIT_HEIGHT, columns, 3), 255, np.uint8)
    for leg, ((top, bottom), colour) in enumerate(zip(_bands(robot), leg_colours(robot).values(), strict=True)):
        shade = np.array(list(bytes.fromhex(colour.removeprefix("#"))), np.uint8)
        strip[top:bottom] = np.where(contact[samples, leg, None], shade, np.uint8(_AIR))
    return strip
