"""Text of the viewer's panel, as HTML: status, legend and keys."""

from collections.abc import Mapping
from html import escape
from typing import Final

from quadruped_env.reporting.palette import GREY, INK, LIMIT
from quadruped_env.robot import Robot
from quadruped_env.viewer.legend import legend
from quadruped_env.viewer.snapshot import View
from quadruped_env.viewer.viewed_robot import Offered
from quadruped_env.viewer.viewer_recording import MAX_SECONDS

SMALL: Final = "font:12px sans-serif;padding:0 12px 8px 12px;line-height:1.6"


def legend_html(robot: Robot, offered: Offered, visible: Mapping[str, bool]) -> str:
    """The legend of the scene, as HTML; arguments as in `legend`."""
    lines = []
    for meaning, marks in legend(robot, offered, visible).items():
        shown = (f'<span style="color:{colour}">{symbol}</span> {escape(name)}' for symbol, colour, name in marks)
        lines.append(f"{' '.join(shown)} {escape(meaning)}")
    return f'<div style="{SMALL};color:{INK}" data-legend>{"<br>".join(lines)}</div>'


def keys_html(offered: Offered) -> str:
    """The keys that have an effect, as HTML."""
    keys = []
    if offered.command:
        keys += ["<b>↑ ↓</b> faster, slower", "<b>← →</b> turn", "<b>0</b> stand"]
    if offered.clock:
        keys += ["<b>Space</b> pause", "<b>N</b> step", "<b>R</b> reset"]
    if offered.push:
        keys.append("<b>P</b> push")
    keys.append("<b>V</b> record")
    spans = "&ensp; ".join(f'<span style="white-space:nowrap">{key}</span>' for key in keys)
    return f'<div style="{SMALL};color:{INK}" data-keys>{spans}</div>'


def status_html(view: View) -> str:
    """The first lines of the panel, as HTML."""
    robot, offered = view.robots[view.watched], view.offered
    commanded = robot.follows_command and offered.command
    (velocity, yaw_rate), (asked_velocity, asked_yaw_rate) = robot.now.smooth_velocity, robot.now.command
    of_velocity, of_yaw_rate = (f"of {asked:z.2f} " if commanded else "" for asked in (asked_velocity, asked_yaw_rate))
    number = "font-size:22px;font-variant-numeric:tabular-nums"
    pace = "paused" if view.paused else f"{view.speed:g} &times; real time" if offered.clock else ""
    lines = [f'<span style="color:{GREY}">{escape(robot.name)} &ensp; {view.time:.1f} s &ensp; {pace}</span>']
    if offered.motion:
        lines.append(
            f'<span style="{number}">{velocity:z.2f}</span> {of_velocity}m/s &ensp; '
            f'<span style="{number}">{yaw_rate:z.2f}</span> {of_yaw_rate}rad/s'
        )
    warnings = []
    if robot.fell_at is not None:
        warnings.append(f"fell at {robot.fell_at:.1f} s")
    if view.recorded is not None:
        warnings.append(f"&#9679; recording, {view.recorded:.1f} of at most {MAX_SECONDS:g} s")
    if robot.complaints:
        more = f", and {len(robot.complaints) - 1} more" if len(robot.complaints) > 1 else ""
        warnings.append(escape(f"The gait exceeds limits: {robot.complaints[0]}{more}"))
    lines += [f'<span style="color:{LIMIT}">{warning}</span>' for warning in warnings]
    return f'<div style="{SMALL};padding-top:8px;min-height:80px;color:{INK}" data-status>{"<br>".join(lines)}</div>'
