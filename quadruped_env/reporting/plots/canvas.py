"""What all figures share: the style, the canvas, and which colour and mark a controller has."""

import io
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import MissingExtraError
from quadruped_env.evaluation.comparison import CONTROLLERS
from quadruped_env.evaluation.metrics import START_UP
from quadruped_env.reporting.palette import CONTROLLER_COLOURS, SERIES

STYLE_FILE: Final = Path(__file__).with_name("quadruped.mplstyle")
WIDTH: Final = 5.6
"""in"""
REFERENCE: Final[dict[str, Any]] = {"color": "#333333", "linewidth": 1.0, "linestyle": (0, (4, 2))}
"""Of the line that a command draws"""
_MARKERS: Final = {"policy": "o", "tuned": "s", "article": "^", "zero": "x"}
_OTHER_MARKERS: Final = "oDvP*<>"


def draw_figure(rows: int, columns: int, height: float, draw: Callable[[Any], None], **layout: Any) -> str:
    """An SVG document of a grid of axes (rows, columns), WIDTH by `height` inches, that `draw` has filled.

    Raises:
        MissingExtraError: if matplotlib is not installed.
    """
    try:
        from matplotlib import rc_context
        from matplotlib.figure import Figure
    except ImportError as error:
        raise MissingExtraError("The report", "report") from error

    with rc_context(fname=STYLE_FILE):
        figure = Figure((WIDTH, height))
        draw(figure.subplots(rows, columns, squeeze=False, **layout))
        file = io.StringIO()
        # Without the date, the same numbers give the same file.
        figure.savefig(file, format="svg", metadata={"Date": None})
    return file.getvalue()


def label(controller: str) -> str:
    """What people read for a controller: policies that are compared go by their names."""
    return CONTROLLERS.get(controller, controller)


def looks(controllers: Iterable[str]) -> dict[str, dict[str, Any]]:
    """Colour and mark of each controller: its own for those of `CONTROLLERS`, and free ones for the others."""
    taken = set(CONTROLLER_COLOURS.values())
    if "policy" not in (names := list(controllers)):
        taken.discard(CONTROLLER_COLOURS["policy"])
    others = [name for name in names if name not in CONTROLLER_COLOURS]
    # More policies than colours that can be told apart begin again, with other marks.
    free = [colour for colour in SERIES if colour not in taken]
    found = {}
    for name in names:
        i = others.index(name) if name in others else 0
        found[name] = {
            "color": CONTROLLER_COLOURS.get(name, free[i % len(free)]),
            "marker": _MARKERS.get(name, _OTHER_MARKERS[i % len(_OTHER_MARKERS)]),
        }
    return found


def colour_of(controller: str, controllers: Iterable[str]) -> str:
    """A controller's colour among those of a figure."""
    return str(looks(controllers)[controller]["color"])


def shown_samples(valid: NDArray[np.bool_], timestep: float, seconds: float) -> NDArray[np.intp]:
    """Indices of the first `seconds` after the start-up, before a fall; of the very beginning for an early fall.

    Args:
        valid: of one episode (T, 1).
        timestep: s.
        seconds: how long a piece to show.
    """
    alive = int(valid[:, 0].sum())
    length = round(seconds / timestep)
    start = max(0, min(round(START_UP / timestep), alive - length))
    return np.arange(start, min(alive, start + length), dtype=np.intp)
