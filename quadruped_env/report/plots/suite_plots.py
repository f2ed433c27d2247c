"""Figures of the suite's results."""

from collections.abc import Mapping
from typing import Any, Final

import numpy as np

from quadruped_env.evaluation.conditions import words
from quadruped_env.report.palette import GREY, SERIES
from quadruped_env.report.plots.canvas import REFERENCE, draw_figure

_RANGES: Final = (0.3, 0.6)
"""Errors at the ends of the colour scales, m/s and rad/s."""


def command_map(result: Mapping[str, Any]) -> str:
    """Draw the signed errors of forward velocity and yaw rate over all commands; crosses mark commands with falls."""
    commands = result["commands"]
    forward, turning = np.array(commands["commands"]).T
    fallen = np.array(commands["fall_share"]) > 0.0

    def draw(axes: Any) -> None:
        panels = (("forward_velocity", "forward velocity (m/s)"), ("yaw_rate", "yaw rate (rad/s)"))
        for ax, (name, title), reach in zip(axes[0], panels, _RANGES, strict=True):
            error = np.array(commands[f"{name}_error"]["signed"], dtype=np.float64)
            mesh = ax.scatter(
                turning, forward, 22, error, cmap="RdBu_r", vmin=-reach, vmax=reach, edgecolors=GREY, linewidths=0.3
            )
            ax.plot(turning[fallen], forward[fallen], "x", color="#333333", markersize=4)
            ax.set(title=f"error of {title}", xlabel="commanded yaw rate (rad/s)")
            ax.grid(visible=False)
            ax.figure.colorbar(mesh, ax=ax, pad=0.02, aspect=18, extend="both")
        axes[0, 0].set_ylabel("commanded\nforward velocity (m/s)")

    return draw_figure(1, 2, 2.9, draw)


def pushes(result: Mapping[str, Any]) -> str:
    """Draw the share of the robots that follow their command after a push, over the size of the push."""
    sizes = result["definition"]["pushes"]["sizes"]

    def draw(axes: Any) -> None:
        ax = axes[0, 0]
        for i, entry in enumerate(result["pushes"]["commands"]):
            share = [100.0 * size["mean"] for size in entry["obeyed"]]
            colour = SERIES[i % len(SERIES)]
            ax.plot(sizes, share, color=colour, marker="o", markersize=4, label=words(entry["command"]))
        ax.axhline(50.0, **REFERENCE)
        ax.set(xlabel="size of the push", ylabel="follow the command (%)")
        ax.set_ylim(-3.0, 103.0)
        ax.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))

    return draw_figure(1, 1, 2.6, draw)


def crossings(result: Mapping[str, Any]) -> str:
    """Draw the share of the tiles that are crossed over the level, for each kind of terrain."""
    needed = 100.0 * result["definition"]["terrain"]["pass_share"]

    def draw(axes: Any) -> None:
        ax = axes[0, 0]
        for i, (kind, entry) in enumerate(result["terrain"].items()):
            share = [100.0 * level["mean"] for level in entry["crossed"]]
            colour = SERIES[i % len(SERIES)]
            ax.plot(np.arange(1, len(share) + 1), share, color=colour, marker="o", markersize=4, label=kind)
        ax.axhline(needed, **REFERENCE)
        ax.set(xlabel="level", ylabel="crossed (%)")
        ax.set_ylim(-3.0, 103.0)
        ax.set_xticks(range(1, result["definition"]["terrain"]["levels"] + 1))
        ax.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))

    return draw_figure(1, 1, 2.6, draw)
