"""Figures of all eight joints over time, with several lines per joint."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.reporting.palette import LIMIT
from quadruped_env.reporting.plots.canvas import draw_figure
from quadruped_env.robot import JOINT_NAMES

_MAX_POINTS: Final = 1500
"""Points drawn per line: more than a figure has pixels."""


@dataclass(frozen=True)
class Line:
    """One line in each of the eight panels."""

    times: NDArray[np.floating]
    """Times of the samples, s (T,)"""
    values: NDArray[np.float64]
    """Values of the joints (T, 8), in the order of `JOINT_NAMES`; NaN leaves a gap"""
    colour: str
    dashed: bool = False


def joint_panels(
    lines: Mapping[str, Line],
    label: str,
    limits: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None,
    mark: float | None = None,
) -> str:
    """One panel per joint: hips on the left, knees on the right, one row per leg.

    Args:
        lines: title -> line.
        label: label of the vertical axes, with its unit.
        limits: minimum and maximum of each joint (8,); drawn where they are within the range of the data.
        mark: time to mark, s.
    """

    def draw(axes: Any) -> None:
        for i, name in enumerate(JOINT_NAMES):
            ax = axes[i // 2, i % 2]
            for title, line in lines.items():
                shown = _shown_rows(line.values[:, i])
                style: dict[str, Any] = {"linestyle": (0, (4, 2))} if line.dashed else {}
                ax.plot(
                    line.times[shown],
                    line.values[shown, i],
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


def _shown_rows(values: NDArray[np.float64]) -> NDArray[np.intp]:
    """Indices of the rows of values (T,) to draw: at most `_MAX_POINTS`, without losing the peaks of a long log.

    A long log is split into bins of equally many rows; the minimum and the maximum of each bin are drawn. A bin of NaN
    is drawn as NaN.
    """
    count = len(values)
    if count <= _MAX_POINTS:
        return np.arange(count)
    # Two rows per bin, and the two ends of the log.
    size = -(-count // (_MAX_POINTS // 2 - 1))
    padded = np.full(-(-count // size) * size, np.nan)
    padded[:count] = values
    bins = padded.reshape(-1, size)
    unknown = np.isnan(bins)
    lowest = np.where(unknown, np.inf, bins).argmin(axis=1)
    highest = np.where(unknown, -np.inf, bins).argmax(axis=1)
    starts = np.arange(len(bins)) * size
    return np.unique(np.concatenate([[0, count - 1], starts + lowest, starts + highest]))
