"""Figures of the suite's results."""

from collections.abc import Mapping
from typing import Any, Final

import numpy as np

from quadruped_env.evaluation.comparison import words
from quadruped_env.report.palette import BLUE, GREY, SERIES
from quadruped_env.report.plots.canvas import REFERENCE, draw_figure

_RANGES: Final = (0.3, 0.6)
"""Errors at the ends of the colour scales, m/s and rad/s."""


def command_map(result: Mapping[str, Any]) -> str:
    """Signed errors of forward velocity and yaw rate over all commands; crosses mark commands with falls."""
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
    """Share of the robots that do what was asked after a push, and the push that half survive in each direction."""
    found, sizes = result["pushes"], result["definition"]["pushes"]["sizes"]
    horizontal = found["horizontal"]
    largest = max(horizontal["sizes"])

    def draw(axes: Any) -> None:
        left, right = axes[0]
        for i, entry in enumerate(found["commands"]):
            share = [100.0 * size["mean"] for size in entry["obeyed"]]
            colour = SERIES[i % len(SERIES)]
            left.plot(sizes, share, color=colour, marker="o", markersize=4, label=words(entry["command"]))
        left.axhline(50.0, **REFERENCE)
        left.set(xlabel="size of the push", ylabel="does what was asked (%)", title="six components")
        left.set_ylim(-3.0, 103.0)
        left.legend()
        place, figure = right.get_subplotspec(), right.figure
        right.remove()
        round_ax = figure.add_subplot(place, projection="polar")
        angle = np.radians([*horizontal["directions"], horizontal["directions"][0]])
        half = [*horizontal["half_survival"], horizontal["half_survival"][0]]
        low, high, mean = (np.array([entry[end] for entry in half]) for end in ("low", "high", "mean"))
        round_ax.fill_between(angle, low, high, color=BLUE, alpha=0.2, linewidth=0.0)
        round_ax.plot(angle, mean, color=BLUE, marker="o", markersize=4)
        round_ax.set_theta_zero_location("N")
        round_ax.set_ylim(0.0, largest)
        round_ax.set_yticks(np.linspace(0.0, largest, 5)[1:])
        round_ax.set_rlabel_position(22.5)
        ends = zip((0, 90, 180, 270), ("forwards", "left", "backwards", "right"), strict=True)
        round_ax.set_xticks(np.radians([0, 90, 180, 270]), [name for _, name in ends])
        round_ax.set_title("50 % survive (m/s)")

    return draw_figure(1, 2, 3.2, draw)


def crossings(result: Mapping[str, Any]) -> str:
    """Share of the tiles that are crossed over the level, for each kind of terrain."""
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
