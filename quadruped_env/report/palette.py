"""Colours of figures and films: Okabe and Ito's, which people with a colour vision deficiency can tell apart.

Source: https://jfly.uni-koeln.de/color/
"""

import itertools
from typing import Final

from quadruped_env.robot import Robot

BLUE: Final = "#0072B2"
VERMILION: Final = "#D55E00"
GREEN: Final = "#009E73"
SKY: Final = "#56B4E9"
ORANGE: Final = "#E69F00"
PURPLE: Final = "#CC79A7"
GREY: Final = "#7F7F7F"

SERIES: Final = (BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, GREY)
"""Colours of series without a fixed colour, in order."""
CONTROLLER_COLOURS: Final = {"policy": BLUE, "tuned": VERMILION, "article": GREEN, "zero": GREY}
_LEG_PAIRS: Final = ((BLUE, VERMILION), (SKY, ORANGE), (GREEN, PURPLE))
"""Colours of a left leg and its counterpart on the right: sides differ in hue, pairs in lightness."""
INK: Final = "#1B1F24"
COMMANDED: Final = GREEN
"""Colour of velocity commands."""
ACTUAL: Final = BLUE
"""Colour of measured velocities."""
CONTACT: Final = VERMILION
"""Colour of contact forces."""
PUSH: Final = ORANGE
"""Colour of pushes and of sustained forces."""
FRONT: Final = "#F0E342"
"""Colour of the mark at the robot's front, as in the robot's model."""
FLOOR: Final = ("#EDF1F6", "#CFD7E1")
"""Colours of the floor's squares in films, replays and the viewer; assets/mini_quadruped/scene.xml has the same."""
BACKGROUND: Final = "#DCE6F0"
"""Colour around the floor in films, replays and the viewer, as in assets/mini_quadruped/scene.xml."""
SQUARE: Final = 0.5
"""Side length of the floor's squares, m."""
LIMIT: Final = "#CC0033"


def rgb(colour: str) -> tuple[int, int, int]:
    """Return `#rrggbb` as three numbers in 0 to 255."""
    red, green, blue = bytes.fromhex(colour.removeprefix("#"))
    return red, green, blue


def leg_colours(robot: Robot) -> dict[str, str]:
    """Return the colour of each leg by name, in the order of the legs; legs without a counterpart are grey."""
    colours = dict.fromkeys(robot.leg_names, GREY)
    pairs = [(leg, other) for leg, other in enumerate(robot.foot_mirror) if robot.left_legs[leg] and leg != other]
    # Front legs first, so that the order of the legs does not matter. With more pairs than colours, colours repeat.
    pairs.sort(key=lambda pair: not robot.fore_legs[pair[0]])
    for pair, shades in zip(pairs, itertools.cycle(_LEG_PAIRS), strict=False):
        colours |= {robot.leg_names[leg]: shade for leg, shade in zip(pair, shades, strict=True)}
    return colours


def joint_colours(robot: Robot) -> list[tuple[str, str]]:
    """Name and colour of the leg of each joint (J,); joints that are on no leg have their own name and are grey."""
    colours = [(name, GREY) for name in robot.joint_names]
    for leg, joints in zip(leg_colours(robot).items(), robot.leg_joints, strict=True):
        for joint in joints:
            colours[joint] = leg
    return colours
