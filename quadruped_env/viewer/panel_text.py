"""Text of the viewer's page, as HTML: status, legend, keys, and the script that handles the keys."""

from collections.abc import Mapping
from html import escape
from typing import Final

from quadruped_env.report.palette import ACTUAL, COMMANDED, CONTACT, FRONT, GREY, INK, LIMIT, PUSH, leg_colours
from quadruped_env.robot import Robot
from quadruped_env.viewer.snapshot import View
from quadruped_env.viewer.viewed_robot import Offered
from quadruped_env.viewer.viewer_recording import MAX_SECONDS
from quadruped_env.viewer.viewer_scene import CONTACT_FORCES, TRAILS, VELOCITIES

SMALL: Final = "font:12px sans-serif;padding:0 12px 8px 12px;line-height:1.6"
_ARROW, _LINE, _PATCH = "&#10142;", "&#9473;", "&#9632;"
_FRONT_GEOM: Final = "front_visual"
"""Name of the mark at the front in the models of `QuadrupedDesign`; other robots need not have one."""
Mark = tuple[str, str, str]
"""Symbol, colour and name."""

# viser moves its camera with the arrow keys, Q and E, focused sliders and buttons consume keys, and held keys repeat.
# Therefore the script captures these keys before other listeners and dispatches them only to the hotkeys, which listen
# on the document element. Text fields keep their keys.
_KEY_SCRIPT: Final = """
document.title = 'MiniQuadruped';
if (!window.quadrupedKeys) {
  window.quadrupedKeys = {keys};
  window.addEventListener('keydown', function (event) {
    var typing = event.target.closest &amp;&amp; event.target.closest('input:not([type=checkbox]), textarea, [contenteditable]');
    var held = event.ctrlKey || event.altKey || event.metaKey || event.shiftKey;
    if (!event.isTrusted || typing || held || window.quadrupedKeys.indexOf(event.code) === -1) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (!event.repeat) {
      document.documentElement.dispatchEvent(
        new KeyboardEvent('keydown', {key: event.key, code: event.code, cancelable: true}));
    }
  }, true);
}
"""  # noqa: E501

# HTML inserted into a page later does not run <script> elements; the load event of an image does.
_PIXEL: Final = "data:image/gif;base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7"


def key_html(robot: Robot) -> str:
    """Return HTML that sets the title of the page and makes arrow keys, the space bar, Q and E control the robot."""
    keys = [
        "ArrowUp",
        "ArrowDown",
        "ArrowLeft",
        "ArrowRight",
        "Space",
        *(["KeyQ", "KeyE"] if robot.moves_sideways else []),
    ]
    script = _KEY_SCRIPT.replace("{keys}", str(keys))
    return f'<img alt="" hidden src="{_PIXEL}" onload="{" ".join(script.split())}">'


def legend(robot: Robot, offered: Offered, visible: Mapping[str, bool]) -> dict[str, list[Mark]]:
    """Return meaning -> marks that have it, of the offered controls and readings, and of the visible overlays."""
    entries: dict[str, list[Mark]] = {}
    if visible[VELOCITIES]:
        if offered.command:
            entries["commanded velocity and turn"] = [(_ARROW, COMMANDED, "")]
        if offered.motion:
            entries["measured velocity and turn"] = [(_ARROW, ACTUAL, "")]
    if visible[CONTACT_FORCES] and offered.motion:
        entries["contact forces"] = [(_ARROW, CONTACT, "")]
    if offered.push:
        entries["push"] = [(_ARROW, PUSH, "")]
    if visible[TRAILS]:
        entries["paths of the feet"] = [(_LINE, colour, leg) for leg, colour in leg_colours(robot).items()]
    if _FRONT_GEOM in robot.mjcf:
        entries["front of the robot"] = [(_PATCH, FRONT, "")]
    return entries


def legend_html(robot: Robot, offered: Offered, visible: Mapping[str, bool]) -> str:
    """Return the `legend` as HTML."""
    lines = []
    for meaning, marks in legend(robot, offered, visible).items():
        shown = (f'<span style="color:{colour}">{symbol}</span> {escape(name)}' for symbol, colour, name in marks)
        lines.append(f"{' '.join(shown)} {escape(meaning)}")
    return f'<div style="{SMALL};color:{INK}" data-legend>{"<br>".join(lines)}</div>'


def keys_html(robot: Robot, offered: Offered) -> str:
    """Return the keys that have an effect, as HTML."""
    keys = []
    if offered.command:
        keys += ["<b>↑ ↓</b> faster, slower", "<b>← →</b> turn"]
        keys += ["<b>Q E</b> sideways"] if robot.moves_sideways else []
        keys.append("<b>0</b> stand")
    if offered.sources:
        keys += ["<b>Space</b> pause", "<b>N</b> step", "<b>R</b> reset"]
    if offered.push:
        keys.append("<b>P</b> push")
    keys.append("<b>V</b> record")
    spans = "&ensp; ".join(f'<span style="white-space:nowrap">{key}</span>' for key in keys)
    return f'<div style="{SMALL};color:{INK}" data-keys>{spans}</div>'


def status_html(view: View) -> str:
    """Return the first lines of the panel, as HTML."""
    robot, offered = view.robots[view.watched], view.offered
    commanded = robot.follows_command and offered.command
    number = "font-size:22px;font-variant-numeric:tabular-nums"
    pace = "paused" if view.paused else f"{view.speed:g} &times; real time" if offered.sources else ""
    lines = [f'<span style="color:{GREY}">{escape(robot.name)} &ensp; {view.time:.1f} s &ensp; {pace}</span>']
    if offered.motion:
        units = ("m/s", "rad/s", "m/s to the left")
        shown = (
            f'<span style="{number}">{v:z.2f}</span> {f"of {asked:z.2f} " if commanded else ""}{unit}'
            for v, asked, unit in zip(robot.now.smooth_velocity, robot.now.command, units, strict=False)
        )
        lines.append(" &ensp; ".join(shown))
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
