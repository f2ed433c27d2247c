"""Figures of all joints over time, with several lines per joint."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.report.palette import LIMIT
from quadruped_env.report.plots.canvas import draw_figure, joint_label
from quadruped_env.robot import Robot


@dataclass(frozen=True)
class Line:
    """One line in each of the panels."""

    times: NDArray[np.floating]
    """Times of the samples, s (T,)"""
    values: NDArray[np.float64]
    """Values of the joints (T, J), in the order of the robot; NaN leaves a gap"""
    colour: str
    dashed: bool = False


def joint_panels(
    robot: Robot,
    lines: Mapping[str, Line],
    label: str,
    limits: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None,
    mark: float | None = None,
) -> str:
    """Draw a panel per joint: a row per leg, with its joints from the base outwards, and a last row of other joints.

    Limits (J,) are drawn where they are within the range of the data; `mark` is a time to mark, s.
    """
    on_legs = {joint for leg in robot.leg_joints for joint in leg}
    others = tuple(joint for joint in range(robot.num_joints) if joint not in on_legs)
    rows = [joints for joints in (*robot.leg_joints, others) if joints]

    def draw_joint(ax: Any, joint: int) -> None:
        for title, line in lines.items():
            style: dict[str, Any] = {"linestyle": (0, (4, 2))} if line.dashed else {}
            # Of a long log matplotlib draws the extremes at each pixel (path.simplify).
            ax.plot(line.times, line.values[:, joint], color=line.colour, linewidth=1.0, label=title, **style)
        ax.set_ylim(*ax.get_ylim())
        for limit in () if limits is None else (limits[0][joint], limits[1][joint]):
            ax.axhline(limit, color=LIMIT, linewidth=1.0)
        if mark is not None:
            ax.axvline(mark, color="#888888", linewidth=0.8)
        ax.set_title(joint_label(robot.joint_names[joint]))

    def draw(axes: Any) -> None:
        for panels, joints in zip(axes, rows, strict=True):
            for ax, joint in zip(panels, joints, strict=False):
                draw_joint(ax, joint)
            for ax in panels[len(joints) :]:
                ax.set_visible(False)
            panels[0].set_ylabel(label)
        for ax in axes[-1]:
            ax.set_xlabel("time (s)")
        handles, titles = axes[0, 0].get_legend_handles_labels()
        axes[0, 0].figure.legend(handles, titles, loc="outside upper center", ncols=len(lines))

    height = 0.6 + 1.6 * len(rows)
    return draw_figure(len(rows), max(map(len, rows)), height, draw, sharex=True)
