"""Figures of energy and motor limits, and the mean reward terms."""

import math
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.measures import counted_samples, masked_mean
from quadruped_env.report.palette import GREY, LIMIT
from quadruped_env.report.plots.canvas import (
    controller_styles,
    draw_estimates,
    draw_figure,
    joint_label,
    label,
    legend_above,
)

_SHARES: Final = (50, 95, 100)
"""Percentiles of |torque| and |speed| over time and episodes that the figure shows."""


def cost_over_speed(comparison: Comparison) -> str:
    """Draw the costs of transport and powers over the speed reached, of every controller; hollow marks are backwards.

    Above the electrical figures, below the mechanical ones.
    """
    styles = controller_styles(comparison.values)
    metrics = [
        (f"{kind}_{metric}", f"{kind} {quantity}")
        for kind in ("electrical", "mechanical")
        for metric, quantity in (("cost_of_transport", "cost (1)"), ("power", "power (W)"))
    ]

    def draw(axes: Any) -> None:
        for ax, (metric, quantity) in zip(axes.flat, metrics, strict=True):
            for controller in comparison.values:
                for motion in ("forwards", "backwards"):
                    rows = comparison.conditions(motion)
                    speed = np.abs([comparison.estimate(controller, "forward_velocity", [i]).mean for i in rows])
                    estimates = [comparison.estimate(controller, metric, [i]) for i in rows]
                    # Commands that all lead to the same speed are not connected by a line.
                    known = speed[np.isfinite(speed)]
                    travels = len(known) > 1 and float(np.ptp(known)) > 0.05 and motion == "forwards"
                    if not all(math.isnan(one.mean) for one in estimates):
                        style = {"linestyle": "-" if travels else "none", "linewidth": 1.0}
                        name = label(controller) if motion == "forwards" else None
                        hollow = motion == "backwards"
                        draw_estimates(ax, speed, estimates, hollow, label=name, **styles[controller], **style)
            ax.set(xlabel="speed reached (m/s)" if ax in axes[-1] else "", ylabel=quantity)
            ax.set_ylim(bottom=0.0)
            ax.set_xlim(left=-0.02)
        legend_above(axes[0, 0].figure, columns=3, handletextpad=0.4)

    return draw_figure(2, 2, 4.8, draw)


def motor_limits(comparison: Comparison) -> str:
    """Draw the torque and speed of each of the policy's joints over time and episodes, relative to the limits."""
    rollout = comparison.rollouts["policy"]
    robot, counted = rollout.robot, counted_samples(rollout)
    torque, speed = rollout.joint_torque[counted], rollout.joint_velocity[counted]
    names, colour = list(map(joint_label, robot.joint_names)), controller_styles(comparison.rollouts)["policy"]["color"]
    quantities = (("torque", torque, robot.effort_limit), ("speed", speed, robot.velocity_limit))

    def draw(axes: Any) -> None:
        for ax, (quantity, values, limit) in zip(axes[0], quantities, strict=True):
            if len(values):
                half, most, peak = 100.0 * np.percentile(np.abs(values), _SHARES, axis=0) / limit
                place = np.arange(len(names))
                ax.barh(place, most, color=colour, height=0.6, label="95 %")
                ax.plot(half, place, "|", color="white", markersize=8, markeredgewidth=2, label="half")
                ax.plot(peak, place, "D", color=GREY, markersize=4, label="peak")
            ax.axvline(100.0, color=LIMIT, linewidth=1.2)
            ax.set(xlabel=f"{quantity} (% of limit)")
            ax.set_yticks(range(len(names)), names)
            ax.invert_yaxis()
            ax.grid(visible=False, axis="y")
        axes[0, 1].tick_params(labelleft=False)

    return draw_figure(1, 2, 2.8, draw)


def mean_terms(comparison: Comparison) -> dict[str, NDArray[np.float64]]:
    """Return controller -> mean of each weighted reward term per second over all commands (K,).

    Controllers that always fall during the start-up are left out.
    """
    means = {}
    for controller, rollout in comparison.rollouts.items():
        terms = masked_mean(rollout.reward_terms, counted_samples(rollout)) / rollout.timestep
        known = np.isfinite(terms).all(axis=1)
        if known.any():
            means[controller] = terms[known].mean(axis=0)
    return means
