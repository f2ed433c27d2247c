"""Figures of commanded and achieved velocities."""

from typing import Any

import numpy as np

from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.measures import window_means
from quadruped_env.report.palette import GREY, LIMIT
from quadruped_env.report.plots.canvas import REFERENCE, controller_styles, draw_figure, label, legend_above
from quadruped_env.utils.rotations import tilt


def tracking(comparison: Comparison) -> str:
    """Achieved over commanded forward velocity and yaw rate of every controller; curves are hollow marks."""
    panels = []
    commands = np.array(comparison.commands)
    straight = [row for motion in ("forwards", "standing", "backwards") for row in comparison.conditions(motion)]
    turning = comparison.conditions("turning")
    if straight:
        panels.append((straight, 0, "forward_velocity", "forward velocity (m/s)"))
    if turning:
        panels.append((turning, 1, "yaw_rate", "yaw rate (rad/s)"))
    styles = controller_styles(comparison.values)

    def draw(axes: Any) -> None:
        for ax, (rows, column, metric, quantity) in zip(axes[0], panels, strict=True):
            target = commands[rows, column]
            span = np.array([target.min(), target.max()])
            ax.plot(span, span, **REFERENCE, label="command")
            # Offset horizontally, so that equal results of several controllers do not overlap.
            offsets = np.linspace(-1, 1, len(styles)) * 0.012 * max(float(np.ptp(span)), 0.1)
            for offset, controller in zip(offsets, styles, strict=True):
                estimates = [comparison.estimate(controller, metric, [row]) for row in rows]
                for hollow in (False, True):
                    chosen = [i for i, row in enumerate(rows) if bool(column and comparison.commands[row][0]) is hollow]
                    if chosen:
                        mean = np.array([estimates[i].mean for i in chosen])
                        low, high = (np.array([getattr(estimates[i], end) for i in chosen]) for end in ("low", "high"))
                        ax.errorbar(
                            target[chosen] + offset,
                            mean,
                            np.maximum([mean - low, high - mean], 0.0),
                            **styles[controller],
                            linestyle="none",
                            elinewidth=1.0,
                            markerfacecolor="white" if hollow else None,
                            zorder=3 if controller == "policy" else 2,
                            label=None if hollow else label(controller),
                        )
            ax.set(title=quantity, xlabel="commanded", ylabel="achieved")
        legend_above(axes[0, 0].figure, columns=3, handletextpad=0.4)

    return draw_figure(1, len(panels), 3.1 + 0.18 * (len(styles) // 3), draw)


def episode(comparison: Comparison, controller: str, row: int) -> str:
    """One episode of a controller from its start: both velocities with their commands, and the tilt of the base."""
    one = comparison.rollouts[controller].select([row])
    alive = min(int(one.valid[:, 0].sum()) + 1, len(one.valid))
    time = (np.arange(alive) + 1) * one.timestep
    colour = controller_styles(comparison.rollouts)[controller]["color"]
    panels = (
        ("forward velocity (m/s)", one.velocity[..., 0], one.command[0, 0, 0]),
        ("yaw rate (rad/s)", one.velocity[..., 1], one.command[0, 0, 1]),
        ("tilt of the base (°)", np.degrees(tilt(one.orientation)), None),
    )

    def draw(axes: Any) -> None:
        for ax, (quantity, values, command) in zip(axes[:, 0], panels, strict=True):
            raw = {"color": colour} if command is None else {"color": GREY, "alpha": 0.6}
            ax.plot(time, values[:alive, 0], linewidth=0.6, **raw)
            means, _ = window_means(values[:alive], one.valid[:alive], one.timestep)
            if command is not None:
                half = (alive - len(means)) // 2
                ax.plot(time[half : half + len(means)], means[:, 0], color=colour)
                ax.axhline(command, **REFERENCE)
            if one.fallen[0]:
                ax.axvline(time[-1], color=LIMIT, linewidth=1.0)
            ax.set(title=quantity)
        axes[-1, 0].set_xlabel("time (s)")

    return draw_figure(len(panels), 1, 3.9, draw, sharex=True)
