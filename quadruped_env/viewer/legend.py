"""Legend of what is drawn around the robots."""

from collections.abc import Mapping
from typing import Final

from quadruped_env.reporting.palette import ACTUAL, COMMANDED, CONTACT, FRONT, PUSH, leg_colours
from quadruped_env.robot import Robot
from quadruped_env.viewer.viewed_robot import Offered

CONTACT_FORCES, VELOCITIES, TRAILS, NAMES = "contact forces", "velocity arrows", "foot trails", "names"
OVERLAYS: Final = (CONTACT_FORCES, VELOCITIES, TRAILS, NAMES)
"""Overlays of the scene, which can be hidden."""

_ARROW, _LINE, _PATCH = "&#10142;", "&#9473;", "&#9632;"
_FRONT_GEOM: Final = "front_visual"
"""Name of the mark at the front in the models of `QuadrupedDesign`; other robots need not have one."""

Mark = tuple[str, str, str]
"""Symbol, colour and name."""


def legend(robot: Robot, offered: Offered, visible: Mapping[str, bool]) -> dict[str, list[Mark]]:
    """Meaning -> marks that have it.

    Args:
        robot: robot that is shown.
        offered: controls and readings that there are; what cannot appear without them has no entry.
        visible: overlay -> True if it is shown.
    """
    entries: dict[str, list[Mark]] = {}
    if visible[VELOCITIES]:
        if offered.command:
            entries["commanded velocity and turn"] = [(_ARROW, COMMANDED, "")]
        if offered.motion:
            entries["measured velocity and turn"] = [(_ARROW, ACTUAL, "")]
    if visible[CONTACT_FORCES] and offered.motion:
        entries["contact forces"] = [(_ARROW, CONTACT, "")]
    if offered.push:
        entries["push, sustained force" if offered.force else "push"] = [(_ARROW, PUSH, "")]
    if visible[TRAILS]:
        entries["paths of the feet"] = [(_LINE, colour, leg) for leg, colour in leg_colours(robot).items()]
    if _FRONT_GEOM in robot.mjcf:
        entries["front of the robot"] = [(_PATCH, FRONT, "")]
    return entries
