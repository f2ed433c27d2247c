"""Figures of a sweep: learning curves of its trials, parallel coordinates, importance of the fields."""

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.report.palette import BLUE, GREY, VERMILION
from quadruped_env.report.plots.canvas import draw_figure
from quadruped_env.report.plots.learning_plots import LEARNING_CURVES

_FAINT: Final = {"color": GREY, "linewidth": 0.7, "alpha": 0.6}
_BEST: Final = {"color": VERMILION, "linewidth": 1.6}
_BINS: Final = 40
"""Points of the median over the trials."""


def learning_curves(progress: Mapping[int, Mapping[str, NDArray[np.float64]]], best: int | None) -> str:
    """Learning curves of trials (number -> columns, as from `read_progress`), with their median and the best trial."""

    def draw(axes: Any) -> None:
        for ax, (quantity, label) in zip(axes[:, 0], LEARNING_CURVES, strict=True):
            curves = {}
            for number, columns in progress.items():
                known = np.isfinite(columns[quantity])
                curves[number] = columns["timesteps"][known] / 1e6, columns[quantity][known]
                ax.plot(*curves[number], **(_BEST if number == best else _FAINT), zorder=3 if number == best else 1)
            grid, median = median_curve(list(curves.values()))
            ax.plot(grid, median, color=BLUE, linewidth=1.6, zorder=2)
            ax.set_ylabel(label)
            if quantity == "fall_rate":
                ax.set_ylim(-0.03, 1.03)
            elif quantity != "return":
                ax.set_ylim(bottom=0.0)
        ax = axes[0, 0]
        handles = [ax.plot([], [], **_FAINT, label="trial")[0], ax.plot([], [], color=BLUE, label="median")[0]]
        if best is not None:
            handles.append(ax.plot([], [], **_BEST, label=f"best (trial {best})")[0])
        ax.figure.legend(handles=handles, loc="outside upper center", ncols=3)
        axes[-1, 0].set_xlabel("time steps (millions)")

    return draw_figure(len(LEARNING_CURVES), 1, 0.5 + 1.3 * len(LEARNING_CURVES), draw, sharex=True)


def median_curve(
    curves: Sequence[tuple[NDArray[np.float64], NDArray[np.float64]]],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Median over curves (x, y) at points of x which more than half of them cover."""
    curves = [(x, y) for x, y in curves if len(x) > 1]
    if not curves:
        return np.zeros(0), np.zeros(0)
    grid = np.linspace(min(x[0] for x, _ in curves), max(x[-1] for x, _ in curves), _BINS)
    values = np.array([np.interp(grid, x, y, left=np.nan, right=np.nan) for x, y in curves])
    covered = np.isfinite(values).sum(axis=0) * 2 > len(curves)
    return grid[covered], np.nanmedian(values[:, covered], axis=0)


def parallel_coordinates(settings: Sequence[Mapping[str, Any]], space: Mapping[str, Mapping[str, Any]]) -> str:
    """Settings, each with `values` and `score`, as lines over the fields of a space and the score."""
    names = [*space, "score"]
    scores = np.array([entry["score"] for entry in settings])
    low, high = float(scores.min()), float(scores.max())
    spread = high - low or 1.0

    def draw(axes: Any) -> None:
        from matplotlib import colormaps

        ax = axes[0, 0]
        for entry in sorted(settings, key=lambda entry: float(entry["score"])):
            share = (entry["score"] - low) / spread
            heights = [position(entry["values"][name], space[name]) for name in space]
            ax.plot(range(len(names)), [*heights, share], color=colormaps["viridis"](share), linewidth=1.2, alpha=0.85)
        for i, name in enumerate(space):
            ax.axvline(i, color=GREY, linewidth=0.8)
            for height, text in ticks(space[name]):
                ax.annotate(text, (i, height), textcoords="offset points", xytext=(3, 2), fontsize=7)
        ax.axvline(len(space), color=GREY, linewidth=0.8)
        for height, value in ((0.0, low), (1.0, high)):
            ax.annotate(
                f"{value:.3f}", (len(space), height), textcoords="offset points", xytext=(-3, 2), fontsize=7, ha="right"
            )
        ax.set_xticks(range(len(names)), [wrapped(name) for name in names], fontsize=7)
        ax.set_yticks([])
        ax.set_ylim(-0.05, 1.08)
        ax.grid(visible=False)

    return draw_figure(1, 1, 3.0, draw)


def position(value: Any, field: Mapping[str, Any]) -> float:
    """Place of a value on its axis, in [0, 1]."""
    if "choices" in field:
        choices = [json.dumps(choice) for choice in field["choices"]]
        return choices.index(json.dumps(value)) / max(1, len(choices) - 1)
    scale = math.log if field["log"] else float
    return (scale(value) - scale(field["low"])) / (scale(field["high"]) - scale(field["low"]))


def ticks(field: Mapping[str, Any]) -> list[tuple[float, str]]:
    """Places and labels of the marks on the axis of a field."""
    values = field.get("choices", (field.get("low"), field.get("high")))
    return [
        (position(value, field), f"{value:g}" if isinstance(value, float) else plain_text(value)) for value in values
    ]


def wrapped(name: str) -> str:
    """Name of a field in lines: the path of a task's field breaks at its dots."""
    return name.replace(".", ".\n")


def plain_text(value: Any) -> str:
    """A value of a field that is no fraction: widths of layers as 64x64."""
    if isinstance(value, list):
        return "x".join(map(str, value))
    return value if isinstance(value, str) else json.dumps(value)


def importances(fields: Mapping[str, float]) -> str:
    """Importance of the fields as bars, the largest first."""
    order = sorted(fields, key=lambda name: fields[name])

    def draw(axes: Any) -> None:
        ax = axes[0, 0]
        ax.barh(range(len(order)), [fields[name] for name in order], color=BLUE)
        ax.set_yticks(range(len(order)), [wrapped(name) for name in order])
        ax.set(xlabel="importance (1)", xlim=(0.0, 1.0))

    return draw_figure(1, 1, 0.9 + 0.45 * len(order), draw)
