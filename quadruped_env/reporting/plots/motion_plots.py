"""Figures of feet and joints over time."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.reporting.palette import LIMIT, joint_colours, leg_colours
from quadruped_env.reporting.plots.canvas import draw_figure, label, shown_samples


def gait_diagram(comparison: Comparison, command: int, seconds: float = 2.0) -> str:
    """Gait diagram: the times at which each foot is on the ground, for every controller except the zero action."""
    shown = [name for name in comparison.rollouts if name != "zero"]

    def draw(axes: Any) -> None:
        for ax, controller in zip(axes[:, 0], shown, strict=True):
            one = comparison.rollouts[controller].select([comparison.episode(command, controller)])
            samples = shown_samples(one.valid, one.timestep, seconds)
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


def _spans(on: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First index and length of every run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], on.astype(np.int8), [0]])))
    return [(int(begin), int(end - begin)) for begin, end in edges.reshape(-1, 2)]


def joint_traces(comparison: Comparison, command: int, seconds: float = 1.5) -> str:
    """Position, speed and torque of the policy's joints with their limits, after the start-up: one column per kind."""
    one = comparison.rollouts["policy"].select([comparison.episode(command)])
    samples = shown_samples(one.valid, one.timestep, seconds)
    time = (samples + 1) * one.timestep
    robot = one.robot
    quantities: tuple[tuple[str, NDArray[Any], NDArray[Any], NDArray[Any]], ...] = (
        ("position (rad)", one.joint_position, robot.joint_position_low, robot.joint_position_high),
        ("speed (rad/s)", one.joint_velocity, -robot.velocity_limit, robot.velocity_limit),
        ("torque (N m)", one.joint_torque, -robot.effort_limit, robot.effort_limit),
    )
    kinds, colours = robot.joints_by_kind, joint_colours(robot)

    def draw(axes: Any) -> None:
        for row, (quantity, values, low, high) in zip(axes, quantities, strict=True):
            for joints, ax in zip(kinds.values(), row, strict=True):
                for limit in {*low[joints], *high[joints]}:
                    line = ax.axhline(limit, color=LIMIT, linewidth=1.0)
                for joint in joints:
                    name, colour = colours[joint]
                    ax.plot(time, values[samples, 0, joint], color=colour, linewidth=1.2, label=name)
                least, most = low[joints].min(), high[joints].max()
                margin = 0.06 * (most - least)
                ax.set_ylim(least - margin, most + margin)
            row[0].set_ylabel(quantity)
        for kind, ax in zip(kinds, axes[0], strict=True):
            ax.set_title(f"{kind}s")
        for ax in axes[-1]:
            ax.set_xlabel("time (s)")
        handles, names = axes[0, 0].get_legend_handles_labels()
        axes[0, 0].figure.legend(
            [*handles, line], [*names, "limit"], loc="outside upper center", ncols=robot.num_legs + 1, columnspacing=1.0
        )

    return draw_figure(len(quantities), len(kinds), 4.8, draw, sharex=True)
