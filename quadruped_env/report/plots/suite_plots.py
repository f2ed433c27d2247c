"""Figures of the suite's results."""

from collections.abc import Mapping
from typing import Any, Final

import numpy as np

from quadruped_env.control.control_config import VELOCITIES
from quadruped_env.evaluation.conditions import words
from quadruped_env.report.palette import GREY, SERIES
from quadruped_env.report.plots.canvas import REFERENCE, blank, draw_figure, quantity

_RANGES: Final = {"m/s": 0.3, "rad/s": 0.6}
"""Unit of a velocity -> error at the ends of the colour scale."""


def command_map(result: Mapping[str, Any]) -> str:
    """Draw the signed error of each velocity over the commanded yaw rate, or lateral velocity, and forward velocity.

    Crosses mark commands with falls.
    """
    commands = result["commands"]
    given = np.array(commands["commands"]).T
    fallen = np.array(commands["fall_share"]) > 0.0

    def draw(axes: Any) -> None:
        for i, (ax, entry) in enumerate(zip(axes.flat, VELOCITIES[: len(given)], strict=False)):
            error, reach = np.array(commands[f"{entry.name}_error"]["signed"], dtype=np.float64), _RANGES[entry.unit]
            across = max(1, i)
            x, y = given[across], given[0]
            mesh = ax.scatter(x, y, 22, error, cmap="RdBu_r", vmin=-reach, vmax=reach, edgecolors=GREY, linewidths=0.3)
            ax.plot(x[fallen], y[fallen], "x", color="#333333", markersize=4)
            ax.set(title=f"error of {quantity(entry)}", xlabel=f"commanded {quantity(VELOCITIES[across])}")
            ax.grid(visible=False)
            ax.figure.colorbar(mesh, ax=ax, pad=0.02, aspect=18, extend="both")
        for ax in axes[:, 0]:
            ax.set_ylabel(f"commanded\n{quantity(VELOCITIES[0])}")
        blank(axes, len(given))

    return draw_figure(rows := -(-len(given) // 2), 2, 2.9 * rows, draw)


def pushes(result: Mapping[str, Any]) -> str:
    """Draw the accuracy after a push over the size of the push, for each command."""
    sizes = result["definition"]["pushes"]["sizes"]

    def draw(axes: Any) -> None:
        ax = axes[0, 0]
        for i, entry in enumerate(result["pushes"]["commands"]):
            accuracy = [100.0 * size["mean"] for size in entry["accuracy"]]
            colour = SERIES[i % len(SERIES)]
            ax.plot(sizes, accuracy, color=colour, marker="o", markersize=4, label=words(entry["command"]))
        ax.axhline(50.0, **REFERENCE)
        ax.set(xlabel="size of the push", ylabel="accuracy (%)")
        ax.set_ylim(-3.0, 103.0)
        ax.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))

    return draw_figure(1, 1, 2.6, draw)


def crossings(result: Mapping[str, Any]) -> str:
    """Draw the share of the tiles that are crossed over the level, for each kind of terrain."""
    needed = 100.0 * result["definition"]["terrain"]["pass_share"]

    def draw(axes: Any) -> None:
        ax = axes[0, 0]
        for i, (kind, entry) in enumerate(result["terrain"]["kinds"].items()):
            share = [100.0 * level["mean"] for level in entry["crossed"]]
            colour = SERIES[i % len(SERIES)]
            ax.plot(np.arange(1, len(share) + 1), share, color=colour, marker="o", markersize=4, label=kind)
        ax.axhline(needed, **REFERENCE)
        ax.set(xlabel="level", ylabel="crossed (%)")
        ax.set_ylim(-3.0, 103.0)
        ax.set_xticks(range(1, result["definition"]["terrain"]["levels"] + 1))
        ax.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))

    return draw_figure(1, 1, 2.6, draw)
