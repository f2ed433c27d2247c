"""Figures of all eight joints over time, several lines each."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.reporting.palette import LIMIT
from quadruped_env.reporting.plots.canvas import draw_figure
from quadruped_env.robot import JOINT_NAMES

_MAX_POINTS: Final = 1500
"""of a line: more than a figure has pixels"""


@dataclass(frozen=True)
class Line:
    """One line in each of the eight panels."""

    times: NDArray[np.floating]
    """s (T,)"""
    values: NDArray[np.float64]
    """(T, 8), in the order of `JOINT_NAMES`; NaN leaves a hole"""
    colour: str
    dashed: bool = False


def joint_panels(
    lines: Mapping[str, Line],
    label: str,
    limits: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None,
    mark: float | None = None,
) -> str:
    """A panel a joint: hips on the left and knees on the right, a leg a row.

    Args:
        lines: title -> line.
        label: of the vertical axes, with its unit.
        limits: lowest and highest value of each joint (8,); drawn where the lines come close.
        mark: s, a time to mark.
    """

    def draw(axes: Any) -> None:
        for i, name in enumerate(JOINT_NAMES):
            ax = axes[i // 2, i % 2]
            for title, line in lines.items():
                step = max(1, -(-len(line.times) // _MAX_POINTS))
                style: dict[str, Any] = {"linestyle": (0, (4, 2))} if line.dashed else {}
                ax.plot(
                    line.times[::step],
                    line.values[::step, i],
                    color=line.colour,
                    linewidth=1.0,
                    label=title,
                    **style,
                )
            ax.set_ylim(*ax.get_ylim())
            for limit in () if limits is None else (limits[0][i], limits[1][i]):
                ax.axhline(limit, color=LIMIT, linewidth=1.0)
            if mark is not None:
                ax.axvline(mark, color="#888888", linewidth=0.8)
            ax.set_title(name.removesuffix("_joint").replace("_", " "))
            if i % 2 == 0:
                ax.set_ylabel(label)
        for ax in axes[-1]:
            ax.set_xlabel("time (s)")
        handles, titles = axes[0, 0].get_legend_handles_labels()
        axes[0, 0].figure.legend(handles, titles, loc="outside upper center", ncols=len(lines))

    return draw_figure(len(JOINT_NAMES) // 2, 2, 7.0, draw, sharex=True)
