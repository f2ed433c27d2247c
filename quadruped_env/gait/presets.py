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
    """Parameters of a leg's sinusoids as functions of forward velocity, one value per entry of `CommandedGait.speeds`.

    The knee has a cosine and a sine part, knee_cosine * cos(w t + p) + knee_sine * sin(w t + p). The columns that end
    in `_turn` are what a yaw rate adds on the right and subtracts on the left, rad per rad/s; the others are in rad.
    """

    hip_amplitude: tuple[float, ...]
    hip_offset: tuple[float, ...]
    knee_cosine: tuple[float, ...]
    knee_sine: tuple[float, ...]
    knee_offset: tuple[float, ...]
    hip_turn: tuple[float, ...]
    knee_cosine_turn: tuple[float, ...]
    knee_sine_turn: tuple[float, ...]


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
    "angular_frequency": math.tau * 2.6,
    "speeds": (-0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.555),
    "largest_yaw_rate": 0.8,
    "fore": LegTable(
        hip_amplitude=(0.227, 0.2181, 0.22, 0.2247, -0.1282, -0.1664, -0.193, -0.1703, -0.2531, -0.2524, -0.2767),
        hip_offset=(0.7501, 0.7564, 0.7879, 0.7813, 0.2787, 0.218, 0.1904, 0.3173, 0.4438, 0.424, 0.4234),
        knee_cosine=(0.0695, 0.0268, 0.0566, 0.1391, -0.1461, -0.1003, -0.0814, -0.1191, -0.1277, -0.188, -0.1589),
        knee_sine=(0.1458, 0.0765, 0.0282, 0.0027, -0.1361, -0.0808, -0.0777, -0.1317, -0.0377, -0.1505, -0.1806),
        knee_offset=(-0.4808, -0.4522, -0.4745, -0.4499, -1.0825, -1.187, -1.1891, -1.1874, -1.119, -1.0612, -0.9929),
        hip_turn=(-0.0766, -0.0742, -0.0413, 0.0465, -0.1956, -0.1644, -0.1241, -0.124, -0.0154, -0.047, -0.0032),
        knee_cosine_turn=(0.2425, 0.2034, 0.1864, 0.1782, 0.1749, 0.0837, 0.1121, 0.1902, 0.1948, 0.1154, 0.097),
        knee_sine_turn=(-0.0734, 0.0256, -0.016, -0.1036, -0.1919, -0.2519, -0.2731, -0.16, -0.0906, -0.1487, -0.096),
    ),
    "hind": LegTable(
        hip_amplitude=(0.2065, 0.2447, 0.2467, 0.1048, 0.1683, 0.0411, -0.1056, -0.1581, -0.2079, -0.2597, -0.2871),
        hip_offset=(0.7994, 0.7798, 0.6415, 0.5885, 0.3252, 0.287, 0.4966, 0.533, 0.558, 0.5805, 0.5821),
        knee_cosine=(-0.1267, -0.0669, 0.007, -0.0034, 0.0232, 0.0988, 0.0426, 0.105, 0.0585, 0.0949, -0.0812),
        knee_sine=(-0.0543, -0.1237, -0.1568, -0.1893, -0.2749, -0.2154, -0.1281, -0.141, -0.1852, -0.2024, -0.2285),
        knee_offset=(-0.7917, -0.694, -0.7665, -0.8134, -1.1196, -1.2372, -1.0949, -1.12, -1.1185, -1.1224, -1.183),
        hip_turn=(-0.0058, -0.0232, -0.0376, -0.0859, 0.0496, 0.0525, -0.0865, -0.1022, -0.0239, -0.0453, -0.0029),
        knee_cosine_turn=(0.1565, 0.165, 0.1339, 0.1445, 0.0228, 0.0845, -0.0926, -0.0944, -0.1118, -0.1639, 0.0003),
        knee_sine_turn=(0.0961, -0.0166, -0.0666, 0.0607, 0.0338, 0.0272, -0.1169, -0.1085, -0.1225, -0.0862, -0.0564),
    ),
}
"""Parameters of the tuned `CommandedGait`."""
