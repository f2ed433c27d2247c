"""Common parts of all figures: style, canvas, and the colour and marker of each controller."""

import io
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_config import Command
from quadruped_env.errors import MissingExtraError
from quadruped_env.evaluation.comparison import CONTROLLERS
from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.report.palette import CONTROLLER_COLOURS, SERIES

STYLE_FILE: Final = Path(__file__).with_name("quadruped.mplstyle")
WIDTH: Final = 4.2
"""Width of a figure, in. On a page 400 px wide, text of 9 pt is then 11 px high."""
REFERENCE: Final[dict[str, Any]] = {"color": "#333333", "linewidth": 1.0, "linestyle": (0, (4, 2))}
"""Line style of commands."""
_MARKERS: Final = {"policy": "o", "tuned": "s", "article": "^", "zero": "x"}
_OTHER_MARKERS: Final = "oDvP*<>"


def draw_figure(
    rows: int, columns: int, height: float, draw: Callable[[Any], None], width: float = WIDTH, **layout: Any
) -> str:
    """Draw a figure of `width` by `height` inches as an SVG document; `draw` receives its axes (rows, columns).

    Raises:
        MissingExtraError: if matplotlib is not installed.
    """
    try:
        from matplotlib import rc_context
        from matplotlib.figure import Figure
    except ImportError as error:
        raise MissingExtraError("The report", "report") from error

    with rc_context(fname=STYLE_FILE):
        figure = Figure((width, height))
        draw(figure.subplots(rows, columns, squeeze=False, **layout))
        file = io.StringIO()
        # Without the date, the same numbers give the same file.
        figure.savefig(file, format="svg", metadata={"Date": None})
    return file.getvalue()


def legend_above(figure: Any, columns: int, reverse: bool = False, **options: Any) -> None:
    """Draw the legend of all axes above them, with fewer columns where long names would leave the figure."""
    entries = [entry for ax in figure.axes for entry in zip(*ax.get_legend_handles_labels(), strict=True)]
    by_name = {name: handle for handle, name in (reversed(entries) if reverse else entries)}
    handles, names = list(by_name.values()), list(by_name)
    for count in range(columns, 0, -1):
        legend = figure.legend(handles, names, loc="outside upper center", ncols=count, **options)
        if count == 1 or legend.get_window_extent().width <= figure.bbox.width:
            break
        legend.remove()


def blank(axes: Any, used: int) -> None:
    """Hide the axes (rows, columns) of a figure after the first `used` ones."""
    for ax in axes.flat[used:]:
        ax.set_axis_off()


def quantity(entry: Command) -> str:
    """Return the name and unit of a component of the command, as titles and labels of axes show it."""
    return f"{entry.name.replace('_', ' ')} ({entry.unit})"


def label(controller: str) -> str:
    """Return the label of a controller. Policies of a comparison have their own names."""
    return CONTROLLERS.get(controller, controller)


def joint_label(name: str) -> str:
    """Return the label of a joint, from its name."""
    return name.removesuffix("_joint").replace("_", " ")


def controller_styles(controllers: Iterable[str]) -> dict[str, dict[str, Any]]:
    """Return the colour and marker of each controller: a fixed one for the names in `CONTROLLERS`, else a free one."""
    taken = set(CONTROLLER_COLOURS.values())
    if "policy" not in (names := list(controllers)):
        taken.discard(CONTROLLER_COLOURS["policy"])
    others = [name for name in names if name not in CONTROLLER_COLOURS]
    # With more policies than distinguishable colours, the colours repeat with other markers.
    free = [colour for colour in SERIES if colour not in taken]
    found = {}
    for name in names:
        i = others.index(name) if name in others else 0
        found[name] = {
            "color": CONTROLLER_COLOURS.get(name, free[i % len(free)]),
            "marker": _MARKERS.get(name, _OTHER_MARKERS[i % len(_OTHER_MARKERS)]),
        }
    return found


def draw_estimates(
    ax: Any, x: NDArray[np.floating[Any]], estimates: Sequence[Estimate], hollow: bool = False, **style: Any
) -> None:
    """Draw means over x (N,) as marks with the bars of their intervals, hollow ones for a second kind of motion."""
    mean, low, high = (np.array([getattr(one, end) for one in estimates]) for end in ("mean", "low", "high"))
    reach, face = np.maximum([mean - low, high - mean], 0.0), "white" if hollow else None
    ax.errorbar(x, mean, reach, markerfacecolor=face, **{"linestyle": "none", "elinewidth": 1.0, **style})
