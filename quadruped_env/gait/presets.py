"""Numbers of the scripted gaits: the tutorial's, and those that train/tune_gait.py found."""

import math
from dataclasses import dataclass
from typing import Any, Final, NamedTuple

from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED

PRESETS: Final = ("article", "trot", "walk", "bound", "pace", "tuned")

LEG_PHASES: Final = {
    "trot": (0.0, 0.5, 0.5, 0.0),
    "walk": (0.0, 0.5, 0.75, 0.25),
    "bound": (0.0, 0.0, 0.5, 0.5),
    "pace": (0.0, 0.5, 0.0, 0.5),
}
"""Phase of each leg by gait, in the order left fore, right fore, left hind, right hind, cycles."""

TUNED_ON: Final = MINI_QUADRUPED
"""Robot on which the numbers were found."""


class LegSinusoids(NamedTuple):
    """Parameters of a leg's sinusoids, rad; the knee's are knee_cosine * cos(w t + p) + knee_sine * sin(w t + p)."""

    hip_amplitude: float
    hip_offset: float
    knee_cosine: float
    knee_sine: float
    knee_offset: float


@dataclass(frozen=True)
class LegTable:
    """Parameters of a leg's sinusoids as functions of ground speed, one value per entry of `CommandedGait.speeds`, rad.

    The knee has a cosine and a sine part, knee_cosine * cos(w t + p) + knee_sine * sin(w t + p). Walking backward is
    walking forward with time reversed and a shift of half a cycle, so only the cosine part changes its sign, and the
    table is smooth at zero speed.
    """

    hip_amplitude: tuple[float, ...]
    hip_offset: tuple[float, ...]
    knee_cosine: tuple[float, ...]
    knee_sine: tuple[float, ...]
    knee_offset: tuple[float, ...]


ARTICLE: Final[dict[str, Any]] = {
    "hip_amplitude": 0.4,
    "hip_offset": 0.0,
    "knee_amplitude": 0.3,
    "knee_offset": -0.3,
    "angular_frequency": 2.0,
    "phases": (0.0, 0.5, 3.14, 3.64, 1.57, 2.07, 4.71, 5.21),
}
"""Parameters of the tutorial's `SinusoidalGait`."""

TUNED_FOR_ONE_SPEED: Final = {
    "trot": (14.0, LegSinusoids(0.201, 0.63, 0.247, -0.255, -0.6), LegSinusoids(-0.076, 0.431, 0.045, -0.291, -0.752)),
    "walk": (12.0, LegSinusoids(0.078, 0.73, 0.172, -0.201, -0.56), LegSinusoids(0.084, 0.436, 0.186, -0.202, -0.843)),
    "bound": (
        14.0,
        LegSinusoids(0.16, 0.782, 0.133, -0.029, -0.607),
        LegSinusoids(-0.084, 0.489, 0.272, -0.213, -0.656),
    ),
    "pace": (14.0, LegSinusoids(0.135, 0.469, 0.221, -0.265, -0.87), LegSinusoids(0.013, 0.546, 0.172, -0.13, -0.618)),
}
"""Preset -> angular frequency in rad/s, fore legs, hind legs; the phases are those of `LEG_PHASES`."""

TUNED: Final[dict[str, Any]] = {
    "angular_frequency": math.tau * 2.2,
    "half_track": 0.58,
    "speeds": (-0.4, -0.3, -0.2, -0.095, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.554),
    "fore": LegTable(
        hip_amplitude=(0.2065, 0.141, 0.0773, 0.1105, 0.0, 0.1785, 0.229, 0.2136, 0.2631, 0.1936, 0.1062),
        hip_offset=(0.6676, 0.5615, 0.5786, 0.5725, 0.6, 0.6453, 0.7038, 0.732, 0.7608, 0.7624, 0.7956),
        knee_cosine=(0.0254, -0.0136, -0.0958, -0.0828, 0.0, 0.0713, 0.1218, 0.1785, 0.2408, 0.2592, 0.2805),
        knee_sine=(0.1049, 0.0852, -0.0411, -0.1391, 0.0, -0.2624, -0.3303, -0.3007, -0.2647, -0.245, -0.2233),
        knee_offset=(-0.4281, -0.5645, -0.6097, -0.6678, -0.72, -0.7735, -0.7434, -0.7744, -0.774, -0.7576, -0.7605),
    ),
    "hind": LegTable(
        hip_amplitude=(0.2648, 0.3007, 0.3298, 0.2866, 0.0, 0.1483, 0.113, 0.0339, -0.0365, -0.0792, -0.1308),
        hip_offset=(0.5823, 0.6718, 0.6396, 0.5963, 0.6, 0.6881, 0.6114, 0.5865, 0.521, 0.4716, 0.4174),
        knee_cosine=(-0.2504, -0.2074, -0.1332, -0.0749, 0.0, 0.062, 0.1341, 0.1849, 0.2592, 0.3225, 0.2872),
        knee_sine=(-0.251, -0.2753, -0.2939, -0.2838, 0.0, -0.0945, -0.0838, -0.0594, -0.0935, -0.1443, -0.2049),
        knee_offset=(-0.7179, -0.7268, -0.7337, -0.748, -0.72, -0.568, -0.5828, -0.5954, -0.5819, -0.602, -0.5927),
    ),
}
"""Parameters of the tuned `CommandedGait`."""
