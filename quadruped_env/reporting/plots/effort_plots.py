"""Figures of energy, motor limits and reward terms."""

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.comparison import Comparison
from quadruped_env.evaluation.measures import counted_samples, masked_mean
from quadruped_env.reporting.palette import GREY, LIMIT
from quadruped_env.reporting.plots.canvas import controller_styles, draw_figure, joint_label, label, legend_above

_BINS: Final = 90
_SHARES: Final = (50, 95, 100)
"""Percentiles of |torque| and |speed| over time and episodes that the figure shows."""


def cost_over_speed(comparison: Comparison) -> str:
    """Costs of transport and powers over the speed reached, of every controller; hollow marks are backwards.

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
                for motion, face in (("forwards", None), ("backwards", "white")):
                    rows = comparison.conditions(motion)
                    speed = np.abs([comparison.estimate(controller, "forward_velocity", [i]).mean for i in rows])
                    estimates = [comparison.estimate(controller, metric, [i]) for i in rows]
                    mean = np.array([e.mean for e in estimates])
                    reach = [[e.mean - e.low for e in estimates], [e.high - e.mean for e in estimates]]
                    # Commands that all lead to the same speed are not connected by a line.
                    known = speed[np.isfinite(speed)]
                    travels = len(known) > 1 and float(np.ptp(known)) > 0.05
                    if np.isfinite(mean).any():
                        ax.errorbar(
                            speed,
                            mean,
                            np.maximum(reach, 0.0),
                            **styles[controller],
                            linestyle="-" if travels and face is None else "none",
                            linewidth=1.0,
                            markerfacecolor=face,
                            label=label(controller) if face is None else None,
                        )
            ax.set(xlabel="speed reached (m/s)" if ax in axes[-1] else "", ylabel=quantity)
            ax.set_ylim(bottom=0.0)
            ax.set_xlim(left=-0.02)
        legend_above(axes[0, 0].figure, columns=3, handletextpad=0.4)

    return draw_figure(2, 2, 4.8, draw)


def motor_limits(comparison: Comparison) -> str:
    """Operating points of the policy's motors: torque over speed with the limits, and each joint's peak values.

    Above one panel per kind of joint, below one per quantity.
    """
    rollout = comparison.rollouts["policy"]
    robot, counted = rollout.robot, counted_samples(rollout)
    torque, speed = rollout.joint_torque[counted], rollout.joint_velocity[counted]
    strongest, fastest = robot.effort_limit, robot.velocity_limit
    kinds = robot.joints_by_kind
    reach = 1.25

    def draw(axes: Any) -> None:
        from matplotlib.colors import LogNorm

        edges = (
            np.linspace(-reach * fastest.max(), reach * fastest.max(), _BINS + 1),
            np.linspace(-1.1 * strongest.max(), 1.1 * strongest.max(), _BINS + 1),
        )
        line = np.linspace(edges[0][0], edges[0][-1], 201)
        figure, grid = axes[0, 0].figure, axes[0, 0].get_gridspec()
        for ax in axes[0]:
            ax.remove()
        upper = grid[0, :].subgridspec(1, len(kinds)).subplots(squeeze=False)[0]
        for ax, (kind, joints) in zip(upper, kinds.items(), strict=True):
            counts, _, _ = np.histogram2d(speed[:, joints].ravel(), torque[:, joints].ravel(), edges)
            share = 100.0 * counts / max(counts.sum(), 1.0)
            seen = np.where(share > 0.0, share, np.nan).T
            mesh = ax.pcolormesh(*edges, seen, cmap="viridis_r", norm=LogNorm(1e-3, 10.0), rasterized=True)
            for stall, top in dict.fromkeys(zip(strongest[joints].tolist(), fastest[joints].tolist(), strict=True)):
                for sign in (-1.0, 1.0):
                    # At full voltage the torque decreases linearly, to zero at the no-load speed; beyond it is
                    # negative.
                    most = np.clip(stall * (sign - line / top), -stall, stall)
                    ax.plot(line, most, color=LIMIT, linewidth=1.2)
            ax.set(xlabel="speed (rad/s)", title=f"{kind}s")
            ax.set_xlim(edges[0][0], edges[0][-1])
            ax.set_ylim(edges[1][0], edges[1][-1])
        upper[0].set_ylabel("torque (N m)")
        figure.colorbar(mesh, ax=upper, label="% of the time", pad=0.01, aspect=14)
        names = list(map(joint_label, robot.joint_names))
        quantities = (("torque", torque, strongest), ("speed", speed, fastest))
        for ax, (quantity, values, limit) in zip(axes[1], quantities, strict=True):
            if len(values):
                half, most, peak = 100.0 * np.percentile(np.abs(values), _SHARES, axis=0) / limit
                place = np.arange(len(names))
                ax.barh(
                    place,
                    most,
                    color=controller_styles(comparison.rollouts)["policy"]["color"],
                    height=0.6,
                    label="95 %",
                )
                ax.plot(half, place, "|", color="white", markersize=8, markeredgewidth=2, label="half")
                ax.plot(peak, place, "D", color=GREY, markersize=4, label="peak")
            ax.axvline(100.0, color=LIMIT, linewidth=1.2)
            ax.set(xlabel=f"{quantity} (% of limit)")
            ax.set_yticks(range(len(names)), names)
            ax.invert_yaxis()
            ax.grid(visible=False, axis="y")
        axes[1, 1].tick_params(labelleft=False)

    return draw_figure(2, 2, 4.8, draw)


def reward_terms(comparison: Comparison) -> str:
    """Mean weighted reward terms per second, forwards and turning: positive terms, and penalties on separate scales.

    Bars are the policy's, marks those of the other controllers.
    """
    motions: list[str | None] = [motion for motion in ("forwards", "turning") if comparison.conditions(motion)]
    motions = motions or [None]
    styles = controller_styles(comparison.rollouts)
    names = np.array(comparison.rollouts["policy"].term_names)
    means = {motion: mean_terms(comparison, motion) for motion in motions}
    pays = np.fmax.reduce([terms["policy"] for terms in means.values()]) > 0.0
    happens = np.any([np.nan_to_num(terms) != 0.0 for motion in means.values() for terms in motion.values()], axis=0)
    groups = [np.flatnonzero(group & happens) for group in (pays, ~pays) if (group & happens).any()]

    def draw(axes: Any) -> None:
        for row, group in zip(axes, groups, strict=True):
            place = np.arange(len(group))
            for ax, motion in zip(row, motions, strict=True):
                for controller, terms in means[motion].items():
                    if controller == "policy":
                        colour = styles[controller]["color"]
                        ax.barh(place, terms[group], color=colour, height=0.62, label=label(controller))
                    else:
                        ax.plot(terms[group], place, linestyle="none", label=label(controller), **styles[controller])
                ax.axvline(0.0, color="#888888", linewidth=0.8)
                ax.set_yticks(place, [name.replace("_", " ") for name in names[group]])
                ax.set_ylim(len(group) - 0.4, -0.6)
                ax.grid(visible=False, axis="y")
                ax.tick_params(labelleft=ax is row[0])
                ax.set_xlabel("reward (1/s)")
        for ax, motion in zip(axes[0], motions, strict=True):
            ax.set_title(motion or "")
        legend_above(axes[0, 0].figure, columns=3, handletextpad=0.4)

    ratios = [len(group) + 1.5 for group in groups]
    return draw_figure(len(groups), len(motions), 0.9 + 0.24 * sum(ratios), draw, height_ratios=ratios)


def mean_terms(comparison: Comparison, motion: str | None) -> dict[str, NDArray[np.float64]]:
    """Controller -> mean of each term per second (K,); NaN for a policy that always falls during the start-up.

    Other controllers that do are left out.
    """
    rows = np.concatenate([comparison.rows(i) for i in comparison.conditions(motion)])
    means = {}
    for controller, rollout in comparison.rollouts.items():
        some = rollout.select(rows)
        terms = masked_mean(some.reward_terms, counted_samples(some)) / some.timestep
        known = np.isfinite(terms).all(axis=1)
        if known.any() or controller == "policy":
            means[controller] = terms[known].mean(axis=0) if known.any() else np.full(terms.shape[1], np.nan)
    return means
