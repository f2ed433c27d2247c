"""Figure of several recipes' learning curves."""

from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.report.palette import BLUE, GREY
from quadruped_env.report.plots.canvas import draw_figure

_SEED: Final = {"color": GREY, "linewidth": 0.7, "alpha": 0.7}
_MEDIAN: Final = {"color": BLUE, "linewidth": 1.6}
_QUANTITIES: Final = (
    ("return", "return of\nan episode (1)"),
    ("forward_velocity_error", "forward velocity\nerror (m/s)"),
)
_POINTS: Final = 40
"""Points of a curve. Each is the mean of several updates, because few episodes end in one."""


def recipe_curves(recipes: Mapping[str, Sequence[Mapping[str, NDArray[np.float64]]]]) -> str:
    """Learning curves of each training seed and their median, by recipe (columns as from `read_progress`)."""

    def draw(axes: Any) -> None:
        for column, (recipe, runs) in zip(axes.T, recipes.items(), strict=True):
            for ax, (quantity, label) in zip(column, _QUANTITIES, strict=True):
                curves = [smoothed(progress["timesteps"] / 1e6, progress[quantity]) for progress in runs]
                for x, y in curves:
                    ax.plot(x, y, **_SEED)
                ax.plot(*median_curve(curves), **_MEDIAN)
                if quantity != "return":
                    ax.set_ylim(bottom=0.0)
                if ax in axes[:, 0]:
                    ax.set_ylabel(label)
            column[0].set_title(recipe)
            column[-1].set_xlabel("steps (millions)")
        handles = [
            axes[0, 0].plot([], [], **_SEED, label="one seed")[0],
            axes[0, 0].plot([], [], **_MEDIAN, label="median")[0],
        ]
        axes[0, 0].figure.legend(handles=handles, loc="outside upper center", ncols=2)

    return draw_figure(len(_QUANTITIES), len(recipes), 3.4, draw, width=2.3 * len(recipes), sharex="col")


def smoothed(
    x: NDArray[np.float64], y: NDArray[np.float64], points: int = _POINTS
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Means of a curve's known values over equal parts of x, at their mean x: `points` of them, or fewer."""
    known = np.isfinite(y)
    x, y = x[known], y[known]
    parts = np.array_split(np.arange(len(x)), min(points, len(x))) if len(x) else []
    return np.array([x[part].mean() for part in parts]), np.array([y[part].mean() for part in parts])


def median_curve(
    curves: Sequence[tuple[NDArray[np.float64], NDArray[np.float64]]],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Median over curves (x, y) at points of x which more than half of them cover."""
    curves = [(x, y) for x, y in curves if len(x) > 1]
    if not curves:
        return np.zeros(0), np.zeros(0)
    grid = np.linspace(min(x[0] for x, _ in curves), max(x[-1] for x, _ in curves), _POINTS)
    values = np.array([np.interp(grid, x, y, left=np.nan, right=np.nan) for x, y in curves])
    covered = np.isfinite(values).sum(axis=0) * 2 > len(curves)
    return grid[covered], np.nanmedian(values[:, covered], axis=0)
