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

    In rad, or rad per rad/s where they are what a yaw rate adds. The knee has a cosine and a sine part,
    knee_cosine * cos(w t + p) + knee_sine * sin(w t + p).
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
    "trot": (
        14.0,
        LegSinusoids(0.087, 0.602, 0.196, -0.228, -0.906),
        LegSinusoids(-0.115, 0.556, 0.12, -0.228, -0.838),
    ),
    "walk": (12.0, LegSinusoids(0.111, 0.785, 0.163, -0.256, -0.619), LegSinusoids(0.025, 0.437, 0.166, -0.146, -0.88)),
    "bound": (
        14.0,
        LegSinusoids(0.187, 0.655, 0.083, -0.16, -0.542),
        LegSinusoids(0.013, 0.631, 0.261, -0.236, -0.745),
    ),
    "pace": (14.0, LegSinusoids(0.073, 0.445, 0.21, -0.201, -0.877), LegSinusoids(0.071, 0.686, 0.154, -0.216, -0.65)),
}
"""Preset -> angular frequency in rad/s, fore legs, hind legs; the phases are those of `LEG_PHASES`."""

TUNED: Final[dict[str, Any]] = {
    "angular_frequency": math.tau * 2.6,
    "speeds": (-0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6),
    "largest_yaw_rate": 0.8,
    "fore": LegTable(
        hip_amplitude=(0.2695, 0.2968, 0.2992, 0.297, 0.0543, 0.0278, -0.0005, -0.0395, -0.1366, -0.2872, -0.2848),
        hip_offset=(0.9358, 0.9452, 0.9061, 0.9649, 0.1457, 0.1638, 0.1525, 0.2335, 0.2477, 0.1992, 0.1648),
        knee_cosine=(0.1962, 0.2197, 0.1721, 0.0917, -0.1451, -0.0811, -0.123, -0.1359, -0.1656, -0.2451, -0.2672),
        knee_sine=(0.0559, -0.0531, -0.1177, -0.1599, -0.2327, -0.2195, -0.2068, -0.2162, -0.1458, -0.1123, -0.1112),
        knee_offset=(-0.6714, -0.7261, -0.6897, -0.748, -0.8611, -0.7914, -0.7917, -0.8247, -0.8656, -1.0128, -0.9398),
    ),
    "hind": LegTable(
        hip_amplitude=(0.2924, 0.2951, 0.2504, 0.1898, 0.205, 0.1555, 0.0395, -0.0194, -0.1422, -0.232, -0.2981),
        hip_offset=(0.9762, 0.837, 0.7297, 0.738, 0.5844, 0.5776, 0.5821, 0.5248, 0.4398, 0.3805, 0.3547),
        knee_cosine=(-0.191, -0.1497, -0.1243, -0.0889, 0.0083, 0.0596, 0.0737, 0.1199, 0.1588, 0.1674, 0.1638),
        knee_sine=(-0.2309, -0.2616, -0.2759, -0.2905, -0.2945, -0.2921, -0.2667, -0.278, -0.2154, -0.2031, -0.208),
        knee_offset=(-1.0668, -0.983, -0.9552, -1.0503, -1.1056, -0.9682, -0.887, -0.8842, -0.8973, -1.0412, -1.0449),
    ),
    "fore_turn": LegTable(
        hip_amplitude=(-0.0899, -0.0734, -0.1199, -0.1744, -0.1552, -0.2315, -0.2118, -0.0373, -0.01, 0.1888, 0.069),
        hip_offset=(-0.1019, -0.0327, -0.0019, 0.0255, 0.1485, 0.2341, 0.1738, 0.3651, 0.024, 0.3714, 0.3248),
        knee_cosine=(-0.1299, -0.1159, 0.0759, 0.1215, 0.0564, -0.0128, 0.0807, 0.1639, 0.2107, 0.3018, 0.2336),
        knee_sine=(0.1583, 0.1582, 0.1456, 0.1845, 0.0425, 0.1049, 0.1348, 0.0263, 0.0446, -0.0258, -0.075),
        knee_offset=(-0.0804, -0.1967, -0.1874, -0.2161, -0.4074, -0.5609, -0.499, -0.4136, -0.3791, -0.2117, -0.0973),
    ),
    "hind_turn": LegTable(
        hip_amplitude=(-0.1538, -0.0998, -0.1111, -0.2031, -0.1684, -0.2882, -0.126, -0.2154, -0.1407, -0.0723, 0.0356),
        hip_offset=(-0.0929, -0.0362, -0.224, -0.2822, -0.4131, -0.4146, -0.3437, -0.0385, 0.0342, 0.2016, 0.1901),
        knee_cosine=(0.0668, 0.1964, 0.2244, 0.1044, 0.0597, -0.0192, -0.0557, -0.1447, -0.1011, -0.1617, -0.2172),
        knee_sine=(0.4313, 0.2486, 0.1045, 0.1686, 0.1393, 0.1262, 0.0375, 0.1315, 0.0826, 0.0122, -0.001),
        knee_offset=(0.3353, 0.1957, 0.1587, 0.2706, -0.0614, -0.2826, -0.1128, 0.0639, 0.0335, 0.209, 0.2845),
    ),
    "fore_side": LegTable(
        hip_amplitude=(-0.0973, -0.0491, -0.048, -0.1094, -0.2783, -0.1733, -0.1143, 0.0289, -0.0446, 0.0267, 0.0059),
        hip_offset=(0.1559, 0.0161, -0.0234, -0.0924, -0.0004, -0.0458, -0.0662, -0.1643, -0.1527, -0.205, -0.2086),
        knee_cosine=(0.1531, 0.0996, -0.0193, 0.0282, 0.0995, 0.1795, 0.2655, 0.0761, 0.1441, 0.064, 0.1106),
        knee_sine=(-0.1367, -0.2377, -0.1997, -0.1674, -0.1213, -0.1706, -0.1488, 0.0498, 0.0079, 0.0192, -0.0588),
        knee_offset=(-0.1942, -0.1525, -0.2825, -0.1693, -0.0125, 0.007, -0.049, -0.0635, -0.1215, -0.0918, -0.2325),
    ),
    "hind_side": LegTable(
        hip_amplitude=(-0.0349, -0.0045, -0.1239, -0.1784, -0.0393, -0.1922, -0.2599, -0.1315, 0.0037, -0.0005, 0.0139),
        hip_offset=(-0.1723, -0.2008, -0.2049, -0.317, -0.0574, -0.1059, -0.1553, -0.1603, -0.3059, -0.3119, -0.4226),
        knee_cosine=(0.179, 0.26, 0.238, 0.2705, 0.055, 0.0328, -0.0139, 0.1019, -0.0275, -0.0473, -0.1293),
        knee_sine=(0.1052, 0.1522, 0.0567, 0.0314, 0.1377, 0.1197, 0.0181, -0.0395, -0.1381, -0.0757, -0.034),
        knee_offset=(0.4196, 0.4119, 0.3714, 0.3902, 0.0873, 0.0115, 0.0296, 0.1467, 0.287, 0.274, 0.3657),
    ),
}
"""Parameters of the tuned `CommandedGait`."""
