"""Figures of the motion: commanded and achieved velocities, single episodes, and the gait over time."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.conditions import MOTIONS
from quadruped_env.evaluation.measures import START_UP, window_means
from quadruped_env.report.palette import GREY, LIMIT, leg_colours
from quadruped_env.report.plots.canvas import (
    REFERENCE,
    blank,
    controller_styles,
    draw_estimates,
    draw_figure,
    label,
    legend_above,
    quantity,
)
from quadruped_env.utils.arrays import Bools
from quadruped_env.utils.rotations import tilt


def tracking(comparison: Comparison) -> str:
    """Draw the achieved over the commanded velocities of every controller; marks of curves and diagonals are hollow."""
    commands, panels = np.array(comparison.commands), []
    for column, entry in enumerate(velocity_commands(comparison.robot)):
        motions = [motion for motion, velocity in MOTIONS.items() if velocity == entry.name]
        if rows := [row for motion in motions for row in comparison.conditions(motion)]:
            panels.append((column, entry, rows))
    styles = controller_styles(comparison.values)

    def draw(axes: Any) -> None:
        for ax, (column, entry, rows) in zip(axes.flat, panels, strict=False):
            target = commands[rows, column]
            span = np.array([target.min(), target.max()])
            ax.plot(span, span, **REFERENCE, label="command")
            # Offset horizontally, so that equal results of several controllers do not overlap.
            offsets = np.linspace(-1, 1, len(styles)) * 0.012 * max(float(np.ptp(span)), 0.1)
            for offset, controller in zip(offsets, styles, strict=True):
                estimates = [comparison.estimate(controller, entry.name, [row]) for row in rows]
                for hollow in (False, True):
                    chosen = [i for i, row in enumerate(rows) if bool(column and comparison.commands[row][0]) is hollow]
                    if chosen:
                        style = {**styles[controller], "zorder": 3 if controller == "policy" else 2}
                        name = None if hollow else label(controller)
                        x = target[chosen] + offset
                        draw_estimates(ax, x, [estimates[i] for i in chosen], hollow, label=name, **style)
            ax.set(title=quantity(entry), xlabel="commanded", ylabel="achieved")
        blank(axes, len(panels))
        legend_above(axes[0, 0].figure, columns=3, handletextpad=0.4)

    lines = -(-len(panels) // 2)
    return draw_figure(lines, min(2, len(panels)), 3.1 * lines + 0.18 * (len(styles) // 3), draw)


def episode(comparison: Comparison, controller: str, row: int) -> str:
    """Draw an episode of a controller from its start: the velocities with their commands, and the tilt."""
    one = comparison.rollouts[controller].select([row])
    alive = min(int(one.valid[:, 0].sum()) + 1, len(one.valid))
    time = (np.arange(alive) + 1) * one.timestep
    colour = controller_styles(comparison.rollouts)[controller]["color"]
    panels = [
        *(
            (quantity(entry), one.velocity[..., i], one.command[0, 0, i])
            for i, entry in enumerate(velocity_commands(one.robot))
        ),
        ("tilt of the base (°)", np.degrees(tilt(one.orientation)), None),
    ]

    def draw(axes: Any) -> None:
        for ax, (title, values, command) in zip(axes[:, 0], panels, strict=True):
            raw = {"color": colour} if command is None else {"color": GREY, "alpha": 0.6}
            ax.plot(time, values[:alive, 0], linewidth=0.6, **raw)
            means, _ = window_means(values[:alive], one.valid[:alive], one.timestep)
            if command is not None:
                half = (alive - len(means)) // 2
                ax.plot(time[half : half + len(means)], means[:, 0], color=colour)
                ax.axhline(command, **REFERENCE)
            if one.fallen[0]:
                ax.axvline(time[-1], color=LIMIT, linewidth=1.0)
            ax.set(title=title)
        axes[-1, 0].set_xlabel("time (s)")

    return draw_figure(len(panels), 1, 1.3 * len(panels), draw, sharex=True)


def gait_diagram(comparison: Comparison, command: int, seconds: float = 2.0) -> str:
    """Draw the times at which each foot is on the ground, for every controller except the zero action."""
    shown = [name for name in comparison.rollouts if name != "zero"]

    def draw(axes: Any) -> None:
        for ax, controller in zip(axes[:, 0], shown, strict=True):
            one = comparison.rollouts[controller].select([comparison.episode(command, controller)])
            samples = _shown_samples(one.valid, one.timestep, seconds)
            for leg, colour in enumerate(leg_colours(one.robot).values()):
                spans = _spans(one.contact[samples, 0, leg])
                start = (samples[0] if len(samples) else 0) * one.timestep
                ax.broken_barh(
                    [(start + begin * one.timestep, length * one.timestep) for begin, length in spans],
                    (leg - 0.36, 0.72),
                    color=colour,
                )
            ax.set_yticks(range(one.robot.num_legs), one.robot.leg_names)
            ax.set_ylim(one.robot.num_legs - 0.4, -0.6)
            ax.grid(visible=False, axis="y")
            ax.set_title(label(controller))
            ax.set_ylabel("foot")
        axes[-1, 0].set_xlabel("time (s)")

    return draw_figure(len(shown), 1, 0.5 + 1.15 * len(shown), draw, sharex=True)


def _shown_samples(valid: Bools, timestep: float, seconds: float) -> NDArray[np.intp]:
    """Return the indices of `seconds` of an episode from the end of the start-up, earlier for early falls."""
    alive = int(valid[:, 0].sum())
    length = round(seconds / timestep)
    start = max(0, min(round(START_UP / timestep), alive - length))
    return np.arange(start, min(alive, start + length), dtype=np.intp)


def _spans(on: Bools) -> list[tuple[int, int]]:
    """Return the first index and length of every run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], on.astype(np.int8), [0]])))
    return [(int(begin), int(end - begin)) for begin, end in edges.reshape(-1, 2)]
