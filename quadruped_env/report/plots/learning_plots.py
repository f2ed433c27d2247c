"""The log of a training run, and its figure."""

import csv
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.report.plots.canvas import controller_styles, draw_figure, label, legend_above
from quadruped_env.training.run_directory import TERM_COLUMN
from quadruped_env.utils.documents import check_regular

LEARNING_CURVES: Final = (
    ("return", "return of\nan episode (1)"),
    ("forward_velocity_error", "forward velocity\nerror (m/s)"),
    ("fall_rate", "episodes that\nend in a fall (1)"),
)


def read_progress(path: Path) -> dict[str, NDArray[np.float64]]:
    """Read the learning curve of a training run: column -> values, NaN for empty cells.

    Raises:
        QuadrupedError: if the file is not a table of numbers with a column `timesteps`.
    """
    check_regular(path, "remove it to make the report without a learning curve")
    try:
        with path.open(newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file)
            names = list(reader.fieldnames or ())
            rows = list(reader)
            # The last line of a killed run may be incomplete; the reader fills its missing cells with None.
            columns = {name: np.array([float(row[name] or math.nan) for row in rows]) for name in names}
    except (ValueError, OSError, csv.Error) as error:
        raise QuadrupedError(f"{path}: {error}; remove the file to make the report without a learning curve") from error
    if "timesteps" not in columns:
        raise QuadrupedError(f"{path}: expected a column 'timesteps'; found {', '.join(names) or 'an empty file'}")
    return columns


def term_curves(progress: Mapping[str, Mapping[str, NDArray[np.float64]]]) -> str | None:
    """Draw the learning curve of every reward term that is not always 0; None for runs without these columns."""
    columns = dict.fromkeys(
        column
        for columns in progress.values()
        for column, values in columns.items()
        if column.startswith(TERM_COLUMN) and np.nan_to_num(values).any()
    )
    if not columns:
        return None
    styles, rows = controller_styles(progress), -(-len(columns) // 2)

    def draw(axes: Any) -> None:
        for ax, column in zip(axes.flat, columns, strict=False):
            for name, curve in progress.items():
                # Empty before a resumed training added the term.
                known = np.isfinite(curve.get(column, np.empty(0)))
                if known.any():
                    steps, colour = curve["timesteps"][known] / 1e6, styles[name]["color"]
                    ax.plot(steps, curve[column][known], color=colour, marker=".", markersize=3, label=name)
            ax.set_title(column.removeprefix(TERM_COLUMN).replace("_", " "))
            ax.locator_params(axis="x", nbins=3)
        for ax in axes.flat[len(columns) :]:
            ax.set_visible(False)
        for ax in axes.flat[: len(columns)][-2:]:
            ax.tick_params(labelbottom=True)
            ax.set_xlabel("time steps (millions)")
        legend_above(axes[0, 0].figure, columns=2)

    return draw_figure(rows, 2, 0.7 + 0.9 * rows, draw, sharex=True)


def learning_curve(
    progress: Mapping[str, Mapping[str, NDArray[np.float64]]], zero_returns: Mapping[str, float] | None = None
) -> str:
    """Draw the learning curves of runs over their time steps.

    Args:
        progress: name of a run -> columns, as from `read_progress`.
        zero_returns: name -> return of an episode of the zero action in the run's task, drawn as a dashed line.
    """
    zero_returns = zero_returns or {}
    curves = [curve for curve in LEARNING_CURVES if any(curve[0] in columns for columns in progress.values())]
    styles = controller_styles(progress)

    def draw(axes: Any) -> None:
        for ax, (quantity, axis_label) in zip(axes[:, 0], curves, strict=True):
            for name, columns in progress.items():
                if quantity not in columns:
                    continue
                # Only rows in which an episode ended have a return.
                known = np.isfinite(columns[quantity])
                steps = columns["timesteps"][known] / 1e6
                style = {"color": styles[name]["color"]}
                ax.plot(steps, columns[quantity][known], marker=".", markersize=3, label=label(name), **style)
                if quantity == "return" and name in zero_returns:
                    of_zero = f"zero action of {name}" if len(progress) > 1 else "zero action"
                    ax.axhline(zero_returns[name], linestyle="--", label=of_zero, **style)
            ax.set_ylabel(axis_label)
            if quantity == "fall_rate":
                ax.set_ylim(-0.03, 1.03)
            elif quantity != "return":
                ax.set_ylim(bottom=0.0)
        axes[-1, 0].set_xlabel("time steps (millions)")
        if len(progress) > 1 or zero_returns:
            legend_above(axes[0, 0].figure, columns=2)

    return draw_figure(len(curves), 1, 0.5 + 1.3 * len(curves), draw, sharex=True)
