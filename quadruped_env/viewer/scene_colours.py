"""The colours of films and reports for the browser's scene."""

from typing import Final

from quadruped_env.reporting.palette import BLUE, GREEN, ORANGE, VERMILION

Colour = tuple[int, int, int]


def rgb(colour: str) -> Colour:
    """`#rrggbb` as three numbers in 0 to 255."""
    red, green, blue = bytes.fromhex(colour.removeprefix("#"))
    return red, green, blue


COMMANDED: Final = rgb(GREEN)
ACTUAL: Final = rgb(BLUE)
CONTACT: Final = rgb(VERMILION)
PUSH: Final = rgb(ORANGE)
