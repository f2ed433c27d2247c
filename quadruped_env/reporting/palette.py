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
LIMIT: Final = "#CC0033"


def leg_colours(robot: Robot) -> dict[str, str]:
    """Colour of each leg by name, in the order of the legs; legs without a counterpart are grey."""
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
