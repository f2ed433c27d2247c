"""The live plots: velocities, the gait diagram, joints with their limits, and reward terms."""

import math
from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_config import Command
from quadruped_env.report import palette
from quadruped_env.robot import Robot
from quadruped_env.viewer.snapshot import View
from quadruped_env.viewer.viewed_robot import HISTORY_SECONDS, ViewedTrace

if TYPE_CHECKING:
    import viser

GAIT_SECONDS: Final = 2.5
"""Time span of the gait diagram, s."""
_WIDTH: Final = 350
"""Panel width, pixels."""
_CHART_HEIGHT: Final = 150
_REWARD_SECONDS: Final = 1.0
"""Averaging time of the reward bars, s."""
_POINTS: Final = 125
"""Maximum number of points per line of a chart."""


class Plots:
    """A panel of charts at the left edge, for the velocity command with its ranges; `reward` is False without terms."""

    def __init__(
        self, server: "viser.ViserServer", commands: Sequence[Command], robot: Robot, reward: bool = True
    ) -> None:
        panel = server.gui.add_panel()
        panel.dock_left()
        panel.set_width(_WIDTH)
        self._shown: tuple[str, float, int] | None = None
        with panel.add_tab("Walk"):
            self._unknown = server.gui.add_html(_NO_MOTION, visible=False)
            self._velocities = [
                _Chart(server, f"{name.capitalize()}, {entry.unit}", _VELOCITY_LINES, _padded(entry.range))
                for name, entry in ((entry.name.replace("_", " "), entry) for entry in commands)
            ]
            self._gait = server.gui.add_html(gait_diagram(robot, np.zeros((0, robot.num_legs), np.bool_), 0.02))
        with panel.add_tab("Joints"):
            self._kinds = [self._add_kind(server, robot, kind) for kind in robot.joints_by_kind]
            self._fastest = float(robot.velocity_limit.max())
            lines: list[_Line] = [(leg, colour, ()) for leg, colour in palette.leg_colours(robot).items()]
            lines.append(("limit", palette.LIMIT, (4, 4)))
            self._speeds = _Chart(server, "Fastest joint of each leg, rad/s", lines, (0.0, 1.2 * self._fastest))
        self._reward = None
        if reward:
            with panel.add_tab("Reward"):
                self._reward = server.gui.add_html("")

    @staticmethod
    def _add_kind(server: "viser.ViserServer", robot: Robot, kind: str) -> tuple["_Chart", Any, tuple[float, float]]:
        """Return a chart of the positions of the joints of a kind, its joints, and the outermost of their limits."""
        joints = robot.joints_by_kind[kind]
        limits = float(robot.joint_position_low[joints].min()), float(robot.joint_position_high[joints].max())
        colours = palette.joint_colours(robot)
        lines: list[_Line] = [(*colours[joint], ()) for joint in joints]
        lines += [("limits", palette.LIMIT, (4, 4)), ("", palette.LIMIT, (4, 4))]
        return _Chart(server, f"{kind.capitalize()} positions, rad", lines, _padded(limits)), joints, limits

    def update(self, view: View) -> None:
        """Show the last seconds of the watched robot."""
        robot, motion = view.robots[view.watched], view.offered.motion
        if self._unknown.visible == motion:
            self._unknown.visible = not motion
            for shown in (*(handle for chart in self._velocities for handle in chart.handles), self._gait):
                shown.visible = motion
        shown = robot.name, float(robot.now.time), len(robot.history)
        if shown == self._shown:
            return
        self._shown = shown
        timestep, description = robot.now.timestep, robot.now.robot
        # Counted from the present, so that the drawn samples do not change as they age.
        drawn = ViewedTrace.stack(robot.history, max(1, round(HISTORY_SECONDS / timestep / _POINTS)))
        times = drawn.time
        # NaN is not drawn.
        command = drawn.command if robot.follows_command else np.full_like(drawn.command, np.nan)
        for i, chart in enumerate(self._velocities):
            chart.show(times, drawn.velocity[:, i], drawn.smooth_velocity[:, i], command[:, i])
        for chart, joints, limits in self._kinds:
            bounds = (np.full(len(times), limit) for limit in limits)
            chart.show(times, *drawn.joint_position[:, joints].T, *bounds)
        speeds = np.abs(drawn.joint_velocity)
        by_leg = [speeds[:, list(leg)].max(axis=1) for leg in description.leg_joints]
        self._speeds.show(times, *by_leg, np.full(len(times), self._fastest))
        contact = np.array([sample.contact for sample in robot.history[-round(GAIT_SECONDS / timestep) :]])
        self._gait.content = gait_diagram(description, contact, timestep)
        if self._reward is not None:
            recent = [sample.reward_terms for sample in robot.history[-round(_REWARD_SECONDS / timestep) :]]
            self._reward.content = reward_bars(robot.term_names, np.mean(recent, axis=0) / timestep)


_Line = tuple[str, str, tuple[int, ...]]
"""Name, colour and dashes"""

_VELOCITY_LINES: Final[tuple[_Line, ...]] = (
    ("now", "#B7CDE0", ()),
    ("mean", palette.ACTUAL, ()),
    ("command", palette.COMMANDED, (6, 4)),
)


class _Chart:
    """Lines over the last seconds."""

    def __init__(
        self, server: "viser.ViserServer", title: str, lines: Sequence[_Line], bounds: tuple[float, float]
    ) -> None:
        heading = server.gui.add_html(_heading(title, lines))
        series: list[dict[str, Any]] = [{}]
        for _, colour, dashes in lines:
            series.append({"stroke": colour, "width": 1.5, "points": {"show": False}, "dash": list(dashes)})
        self._handle: Any = server.gui.add_uplot(
            (np.array([0.0, HISTORY_SECONDS]), *(np.zeros(2) for _ in lines)),
            tuple(series),
            scales={"x": {"time": False}, "y": {"range": bounds}},
            axes=({"size": 28, "font": "11px sans-serif"}, {"size": 38, "font": "11px sans-serif"}),
            legend={"show": False},
            cursor={"show": False},
            height=_CHART_HEIGHT,
            padding=(8, 10, 0, 0),
        )
        self.handles = heading, self._handle

    def show(self, times: NDArray[np.floating], *lines: NDArray[np.floating]) -> None:
        """Draw lines over times (s) (T,)."""
        self._handle.data = (times, *lines)


def gait_diagram(robot: Robot, contact: NDArray[np.bool_], timestep: float) -> str:
    """Return the gait diagram as SVG: a bar per foot and stance phase, with the present at the right edge.

    Contacts (T, L) are over `GAIT_SECONDS` or less, `timestep` seconds apart.
    """
    left, right, top, row, bar = 30, 360, 4, 22, 14
    bottom = top + row * robot.num_legs
    scale = (right - left) / GAIT_SECONDS
    parts = []
    for leg, (name, colour) in enumerate(palette.leg_colours(robot).items()):
        y = top + row * leg
        parts.append(f'<text x="{left - 8}" y="{y + bar - 2}" text-anchor="end">{name}</text>')
        parts.append(f'<rect x="{left}" y="{y}" width="{right - left}" height="{bar}" fill="#EEF1F4"/>')
        # From the first sample on the ground to the first one off it.
        edges = np.flatnonzero(np.diff(contact[:, leg].astype(np.int8), prepend=0, append=0)).reshape(-1, 2)
        for start, stop in edges:
            x = right - (len(contact) - start) * timestep * scale
            parts.append(
                f'<rect x="{x:.1f}" y="{y}" width="{(stop - start) * timestep * scale:.1f}" height="{bar}" '
                f'fill="{colour}"/>'
            )
    for second in range(math.floor(GAIT_SECONDS) + 1):
        x = right - second * scale
        parts.append(f'<text x="{x:.1f}" y="{bottom + 12}" text-anchor="middle">{-second if second else "now"}</text>')
    return (
        f'{_heading("Feet on the ground, s", ())}<svg viewBox="0 0 380 {bottom + 18}" width="100%" '
        f'style="{_FONT};padding:0 6px" fill="{palette.INK}" data-plot="gait">{"".join(parts)}</svg>'
    )


def reward_bars(names: Sequence[str], values: NDArray[np.float64]) -> str:
    """Return the reward terms (T,) per second as a table with bars, the sum last."""
    most = max(4.0, float(np.abs(values).max(initial=0.0)))
    rows = []
    for name, value in zip(names, values, strict=True):
        width = 50.0 * min(abs(value) / most, 1.0)
        side = "left" if value >= 0 else "right"
        colour = palette.GREEN if value >= 0 else palette.VERMILION
        rows.append(
            f'<tr><td style="padding-right:6px;white-space:nowrap">{escape(name.replace("_", " "))}</td>'
            f'<td style="width:45%;position:relative"><div style="position:absolute;top:4px;bottom:4px;{side}:50%;'
            f'width:{width:.1f}%;background:{colour}"></div>'
            f'<div style="position:absolute;top:0;bottom:0;left:50%;width:1px;background:{palette.GREY}"></div></td>'
            f'<td style="text-align:right;font-variant-numeric:tabular-nums">{value:+z.2f}</td></tr>'
        )
    rows.append(
        f'<tr style="font-weight:bold"><td>sum</td><td></td>'
        f'<td style="text-align:right;font-variant-numeric:tabular-nums">{values.sum():+z.2f}</td></tr>'
    )
    return (
        f"{_heading('Reward per second, mean of the last second', ())}"
        f'<table data-plot="reward" style="{_FONT};width:100%;padding:0 12px;line-height:1.7">{"".join(rows)}</table>'
    )


_FONT: Final = "font:12px sans-serif"
_NO_MOTION: Final = (
    f'<div style="{_FONT};padding:12px;color:{palette.GREY}" data-unknown>'
    "Velocity and contacts of the feet are unknown: no /odom arrives.</div>"
)


def _heading(title: str, lines: Sequence[_Line]) -> str:
    keys = "".join(
        f'<span style="margin-left:8px;white-space:nowrap;color:{colour}">{"&#9476;" if dashes else "&#9473;"} '
        f"{escape(name)}</span>"
        for name, colour, dashes in lines
        if name
    )
    return (
        f'<div style="{_FONT};display:flex;flex-wrap:wrap;padding:8px 12px 2px 12px;color:{palette.INK}">'
        f'<b style="flex-grow:1">{escape(title)}</b>{keys}</div>'
    )


def _padded(bounds: tuple[float, float]) -> tuple[float, float]:
    margin = 0.15 * (bounds[1] - bounds[0])
    return float(bounds[0] - margin), float(bounds[1] + margin)
