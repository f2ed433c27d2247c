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
        hip_amplitude=(-0.0966, -0.0946, -0.0578, -0.0465, -0.0904, -0.0437, 0.0309, -0.0366, 0.0829, 0.2221, 0.2389),
        hip_offset=(-0.0749, -0.1118, -0.0772, -0.0268, 0.3144, 0.1062, 0.0768, -0.0126, 0.0224, 0.1545, 0.2506),
        knee_cosine=(-0.1196, -0.1188, -0.0456, -0.0883, 0.2669, 0.0957, 0.1962, 0.1639, 0.2819, 0.4422, 0.4606),
        knee_sine=(0.1571, 0.2182, 0.2845, 0.3168, 0.0878, 0.0088, 0.0942, 0.066, 0.0395, -0.0203, -0.0578),
        knee_offset=(-0.1358, -0.0867, 0.0355, -0.0183, -0.1718, -0.1611, -0.2484, -0.2662, -0.1881, 0.0508, -0.0326),
    ),
    "hind_turn": LegTable(
        hip_amplitude=(-0.147, -0.0993, -0.0278, -0.0458, -0.2579, -0.3009, -0.2416, -0.1698, -0.0518, -0.0571, 0.0205),
        hip_offset=(0.0052, 0.017, -0.0023, 0.0243, -0.517, -0.5448, -0.5527, -0.2117, 0.0353, 0.1188, 0.2593),
        knee_cosine=(0.0942, 0.114, 0.0862, 0.0877, 0.024, -0.0604, -0.0714, -0.1677, -0.1111, -0.1375, -0.1501),
        knee_sine=(0.4555, 0.344, 0.1788, 0.0966, 0.1223, 0.1379, 0.1631, 0.114, -0.0429, -0.0688, -0.0631),
        knee_offset=(0.2439, 0.1833, 0.2979, 0.3997, -0.1255, -0.3574, -0.4531, -0.0214, 0.0426, 0.2404, 0.1968),
    ),
    "fore_side": LegTable(
        hip_amplitude=(-0.1211, -0.0534, -0.0042, -0.0173, -0.1683, 0.0693, 0.1076, 0.2208, 0.1445, 0.1139, 0.0808),
        hip_offset=(0.2087, 0.1766, -0.0008, 0.0521, 0.1125, 0.0239, -0.0728, -0.0007, -0.0727, -0.129, -0.2469),
        knee_cosine=(0.0682, 0.1129, 0.1709, 0.222, -0.0696, 0.0243, 0.1965, 0.0879, 0.0645, -0.0223, 0.0278),
        knee_sine=(-0.1296, -0.2013, -0.2088, -0.1513, -0.1185, -0.0312, -0.071, -0.0585, 0.0152, 0.0585, -0.0295),
        knee_offset=(-0.2507, -0.3243, -0.0534, -0.1502, -0.1864, 0.0323, 0.0834, -0.2965, -0.1324, -0.2204, -0.1735),
    ),
    "hind_side": LegTable(
        hip_amplitude=(-0.059, -0.01, -0.0789, -0.0793, 0.011, -0.15, -0.0552, -0.1512, -0.1139, -0.0199, -0.0063),
        hip_offset=(-0.0376, -0.02, -0.1449, -0.3426, 0.0677, 0.0294, -0.0101, -0.2048, -0.2808, -0.37, -0.424),
        knee_cosine=(0.2249, 0.276, 0.1649, 0.0904, 0.1738, 0.0822, 0.2065, 0.049, -0.0935, -0.1201, -0.1151),
        knee_sine=(0.1444, 0.0383, -0.0275, -0.017, 0.0614, 0.1006, 0.0501, -0.1014, -0.0468, -0.0382, -0.0075),
        knee_offset=(0.2988, 0.0776, -0.0853, -0.2425, 0.0873, 0.0423, 0.0514, 0.1088, 0.2974, 0.34, 0.387),
    ),
}
"""Parameters of the tuned `CommandedGait`."""
