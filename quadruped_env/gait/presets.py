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
    """Parameters of a leg's sinusoids, rad; a joint's are its cosine * cos(w t + p) + sine * sin(w t + p) + offset."""

    hip_sine: float
    hip_offset: float
    knee_cosine: float
    knee_sine: float
    knee_offset: float
    hip_cosine: float = 0.0


@dataclass(frozen=True)
class LegTable:
    """Parameters of a leg's sinusoids as functions of forward velocity, one value per entry of `CommandedGait.speeds`.

    In rad, or rad per rad/s where they are what a yaw rate adds. Each joint has a cosine and a sine part,
    as in `LegSinusoids`.
    """

    hip_sine: tuple[float, ...]
    hip_offset: tuple[float, ...]
    knee_cosine: tuple[float, ...]
    knee_sine: tuple[float, ...]
    knee_offset: tuple[float, ...]
    hip_cosine: tuple[float, ...]


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
        LegSinusoids(0.156, 0.404, 0.198, -0.227, -0.858),
        LegSinusoids(-0.194, 0.52, 0.171, -0.173, -0.821),
    ),
    "walk": (12.0, LegSinusoids(0.137, 0.638, 0.133, -0.21, -0.622), LegSinusoids(-0.032, 0.53, 0.207, -0.062, -0.906)),
    "bound": (14.0, LegSinusoids(0.226, 0.675, 0.08, -0.172, -0.537), LegSinusoids(-0.058, 0.59, 0.28, -0.185, -0.69)),
    "pace": (
        14.0,
        LegSinusoids(0.084, 0.652, 0.254, -0.213, -0.746),
        LegSinusoids(0.098, 0.716, 0.224, -0.199, -1.078),
    ),
}
"""Preset -> angular frequency in rad/s, fore legs, hind legs; the phases are those of `LEG_PHASES`."""

TUNED: Final[dict[str, Any]] = {
    "angular_frequency": math.tau * 2.6,
    "speeds": (-0.344, -0.289, -0.116, 0.0, 0.115, 0.205, 0.303, 0.391, 0.497, 0.568),
    "largest_yaw_rate": 0.8,
    "fore": LegTable(
        hip_sine=(0.281, 0.2978, 0.2909, 0.2969, 0.2536, 0.2617, 0.2478, 0.2235, 0.2078, 0.1873),
        hip_offset=(1.1777, 1.1927, 1.1668, 1.1774, 1.1661, 1.1637, 1.1642, 1.1898, 1.1798, 1.195),
        knee_cosine=(-0.063, -0.0862, -0.0707, -0.0314, 0.0031, -0.013, 0.0017, 0.0054, 0.0415, 0.0889),
        knee_sine=(-0.204, -0.235, -0.2627, -0.2717, -0.3004, -0.3019, -0.3012, -0.287, -0.2872, -0.2686),
        knee_offset=(-1.1096, -1.1454, -1.151, -1.1912, -1.22, -1.2219, -1.2258, -1.2755, -1.2684, -1.2995),
        hip_cosine=(-0.11, -0.0666, 0.051, 0.0488, 0.0536, 0.1182, 0.1395, 0.1855, 0.1986, 0.2166),
    ),
    "hind": LegTable(
        hip_sine=(0.1262, 0.1476, 0.1673, 0.1548, 0.1553, 0.1647, 0.145, 0.0768, 0.023, -0.0458),
        hip_offset=(1.1589, 1.1365, 1.1594, 1.1558, 1.151, 1.1267, 1.0976, 1.1391, 1.1348, 1.1282),
        knee_cosine=(0.1339, 0.1432, 0.096, 0.0545, 0.0268, -0.0079, -0.0495, -0.0846, -0.111, -0.145),
        knee_sine=(-0.2157, -0.2447, -0.2852, -0.2959, -0.2923, -0.3002, -0.2953, -0.2772, -0.2732, -0.25),
        knee_offset=(-1.4143, -1.4606, -1.5297, -1.5721, -1.4837, -1.455, -1.3722, -1.408, -1.4053, -1.445),
        hip_cosine=(-0.2691, -0.256, -0.197, -0.1527, -0.0629, 0.0478, 0.1491, 0.1823, 0.2684, 0.2841),
    ),
    "fore_turn": LegTable(
        hip_sine=(-0.1029, -0.1029, -0.0882, -0.0882, -0.051, -0.0985, -0.1, -0.1749, -0.1105, -0.1105),
        hip_offset=(-0.0951, -0.0951, -0.0831, -0.0831, -0.0269, -0.0753, 0.0424, -0.049, -0.0805, -0.0805),
        knee_cosine=(0.174, 0.174, -0.0765, -0.0765, 0.1394, 0.1183, 0.06, 0.0982, 0.03, 0.03),
        knee_sine=(0.3371, 0.3371, 0.3712, 0.3712, 0.1906, 0.1524, 0.08, 0.1368, 0.1194, 0.1194),
        knee_offset=(0.1167, 0.1167, -0.0295, -0.0295, -0.0442, 0.0079, -0.02, -0.1578, -0.2392, -0.2392),
        hip_cosine=(0.2131, 0.2131, -0.127, -0.127, -0.0139, -0.0903, -0.15, -0.1564, -0.1363, -0.1363),
    ),
    "hind_turn": LegTable(
        hip_sine=(-0.1392, -0.1392, -0.2017, -0.2017, -0.1962, -0.1783, -0.16, -0.1594, -0.1894, -0.1732),
        hip_offset=(-0.3246, -0.3246, -0.4643, -0.4643, -0.3982, -0.2949, -0.34, -0.3211, -0.2238, -0.2238),
        knee_cosine=(0.0441, 0.0441, 0.1208, 0.1208, 0.042, -0.0455, -0.05, -0.0496, 0.025, 0.025),
        knee_sine=(0.2868, 0.2868, 0.1843, 0.1843, 0.1983, 0.1709, 0.09, 0.1455, 0.1424, 0.1424),
        knee_offset=(0.1397, 0.1397, 0.0893, 0.0893, -0.0282, -0.0479, -0.07, -0.1167, -0.1521, -0.1521),
        hip_cosine=(0.0767, 0.0767, -0.0105, -0.0105, -0.0082, -0.0758, -0.15, -0.1784, -0.2539, -0.2481),
    ),
    "fore_side": LegTable(
        hip_sine=(-0.0327, -0.0327, -0.0571, -0.0571, -0.0961, -0.0911, -0.03, -0.0542, 0.0088, 0.0088),
        hip_offset=(-0.0412, -0.0412, -0.0469, -0.0469, -0.0113, 0.0117, 0.0024, -0.0121, 0.0205, 0.0205),
        knee_cosine=(0.0056, 0.0056, 0.0427, 0.0427, -0.0431, -0.019, 0.01, 0.007, 0.0402, 0.0402),
        knee_sine=(-0.2566, -0.2566, -0.1092, -0.1092, -0.1144, -0.0389, 0.0, 0.0048, 0.0068, 0.0068),
        knee_offset=(-0.3487, -0.3487, -0.2523, -0.2523, -0.173, -0.1588, -0.08, 0.0839, 0.1075, 0.1075),
        hip_cosine=(0.12, 0.12, 0.0664, 0.0664, 0.0543, 0.1055, 0.16, 0.1606, 0.1348, 0.1348),
    ),
    "hind_side": LegTable(
        hip_sine=(0.1248, 0.1248, 0.0123, 0.0123, 0.062, 0.0665, 0.07, 0.0377, 0.146, 0.1298),
        hip_offset=(0.2689, 0.2689, 0.0463, 0.0463, 0.0218, 0.12, 0.05, -0.003, 0.0416, 0.0416),
        knee_cosine=(-0.0863, -0.0863, 0.0511, 0.0511, -0.0087, 0.0009, 0.09, 0.0667, 0.1671, 0.1671),
        knee_sine=(-0.0765, -0.0765, -0.0396, -0.0396, -0.0944, -0.103, -0.03, -0.0487, -0.0508, -0.0508),
        knee_offset=(0.0605, 0.0605, 0.0288, 0.0288, -0.0159, -0.0947, -0.04, 0.0138, -0.0314, -0.0314),
        hip_cosine=(0.089, 0.089, 0.0604, 0.0604, 0.1251, 0.1978, 0.2, 0.2273, 0.2406, 0.2348),
    ),
}
"""Parameters of the tuned `CommandedGait`."""
