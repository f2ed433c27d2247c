"""Colours of figures and films: Okabe and Ito's, which people with a colour vision deficiency can tell apart.

Source: https://jfly.uni-koeln.de/color/
"""

from typing import Final

from quadruped_env.robot import LEG_NAMES

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
LEG_COLOURS: Final = dict(zip(LEG_NAMES, (BLUE, VERMILION, SKY, ORANGE), strict=True))
"""Leg -> colour; left and right differ in hue, front and hind in lightness."""
INK: Final = "#1B1F24"
LIMIT: Final = "#CC0033"
