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
        LegSinusoids(-0.194, 0.233, -0.136, -0.154, -0.789),
        LegSinusoids(0.301, 0.786, 0.271, -0.2, -0.854),
    ),
    "walk": (12.0, LegSinusoids(0.19, 0.744, 0.18, -0.314, -0.558), LegSinusoids(0.075, 0.487, 0.193, -0.166, -0.923)),
    "bound": (
        14.0,
        LegSinusoids(0.221, 0.65, 0.08, -0.171, -0.516),
        LegSinusoids(-0.038, 0.584, 0.274, -0.215, -0.698),
    ),
    "pace": (
        14.0,
        LegSinusoids(-0.056, 0.208, 0.091, -0.125, -0.981),
        LegSinusoids(0.014, 0.518, 0.26, -0.162, -1.024),
    ),
}
"""Preset -> angular frequency in rad/s, fore legs, hind legs; the phases are those of `LEG_PHASES`."""

TUNED: Final[dict[str, Any]] = {
    "angular_frequency": math.tau * 2.6,
    "speeds": (-0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6),
    "largest_yaw_rate": 0.8,
    "fore": LegTable(
        hip_amplitude=(0.2934, 0.2952, 0.2997, 0.2943, 0.1187, 0.0553, 0.0544, -0.0493, -0.1806, -0.2838, -0.2943),
        hip_offset=(0.9253, 0.8975, 0.8694, 0.9915, 0.2922, 0.1959, 0.1517, 0.165, 0.187, 0.1212, 0.1314),
        knee_cosine=(0.2686, 0.2344, 0.1996, 0.115, -0.1073, -0.011, -0.0789, -0.0747, -0.1706, -0.176, -0.1517),
        knee_sine=(0.048, -0.0338, -0.1098, -0.1654, -0.2357, -0.2509, -0.26, -0.1865, -0.1371, -0.2076, -0.2442),
        knee_offset=(-0.6398, -0.6576, -0.6904, -0.7892, -0.9992, -0.9987, -0.978, -0.958, -0.8497, -1.0591, -1.1193),
    ),
    "hind": LegTable(
        hip_amplitude=(0.2839, 0.286, 0.2479, 0.1931, 0.2148, 0.127, -0.0118, -0.0514, -0.1692, -0.2907, -0.297),
        hip_offset=(0.8064, 0.7554, 0.6877, 0.665, 0.7784, 0.6078, 0.5855, 0.4634, 0.3903, 0.2978, 0.2862),
        knee_cosine=(-0.1856, -0.1378, -0.1123, -0.0991, -0.0033, 0.0318, 0.0652, 0.1569, 0.1744, 0.131, 0.0022),
        knee_sine=(-0.2268, -0.2666, -0.2753, -0.2871, -0.3016, -0.2725, -0.2075, -0.2507, -0.1707, -0.2389, -0.2896),
        knee_offset=(-0.9213, -0.9378, -0.8991, -0.9546, -1.2139, -1.0846, -1.0236, -0.9228, -0.9281, -1.0247, -1.0026),
    ),
    "fore_turn": LegTable(
        hip_amplitude=(-0.0472, -0.1045, -0.0792, -0.1068, -0.0499, -0.0491, -0.1456, -0.0563, 0.0829, 0.1272, 0.061),
        hip_offset=(-0.0987, -0.1306, -0.0841, -0.2314, -0.028, 0.0275, 0.1645, 0.1191, 0.1526, 0.2463, 0.2113),
        knee_cosine=(-0.2102, -0.103, -0.2314, -0.0064, 0.0991, 0.0781, 0.1282, 0.0947, 0.1942, 0.1024, 0.0678),
        knee_sine=(0.1264, 0.1568, 0.2375, 0.2446, 0.0, 0.0624, 0.1842, 0.1466, 0.0993, 0.1058, 0.0742),
        knee_offset=(0.0581, -0.0082, 0.0021, 0.0209, -0.205, -0.1275, -0.2464, -0.2611, -0.2545, 0.0245, 0.1329),
    ),
    "hind_turn": LegTable(
        hip_amplitude=(-0.0804, -0.2387, -0.1966, -0.1521, -0.1322, -0.2296, -0.1508, -0.1786, -0.1003, 0.0671, 0.0269),
        hip_offset=(-0.0681, -0.1541, -0.3338, -0.5336, -0.6182, -0.5404, -0.4871, -0.3556, -0.1753, 0.1677, 0.2142),
        knee_cosine=(0.0314, 0.1003, 0.2378, 0.174, 0.0742, 0.047, 0.0169, -0.2046, -0.2944, -0.0827, -0.1103),
        knee_sine=(0.2862, 0.4126, 0.2902, 0.1911, 0.1359, 0.167, 0.0349, 0.1516, -0.0133, 0.0016, 0.0334),
        knee_offset=(0.3042, 0.2659, 0.322, 0.3524, 0.1154, -0.1857, -0.0522, -0.0123, 0.0223, 0.2939, 0.2882),
    ),
    "fore_side": LegTable(
        hip_amplitude=(-0.0009, -0.075, -0.0425, -0.0956, -0.1979, -0.0537, -0.0528, -0.0605, -0.0252, 0.0907, 0.0271),
        hip_offset=(0.0184, -0.0224, -0.2123, -0.2143, -0.1093, -0.0712, -0.0311, -0.0606, -0.02, -0.0529, -0.154),
        knee_cosine=(0.0912, -0.0134, -0.0824, -0.1331, 0.072, 0.0794, 0.1328, 0.1598, 0.308, 0.1678, -0.0527),
        knee_sine=(-0.1353, -0.1599, -0.1602, -0.1013, 0.0102, 0.025, -0.0799, -0.1483, -0.1427, -0.1085, -0.009),
        knee_offset=(0.0162, -0.0885, 0.0419, -0.0244, 0.0364, 0.0258, -0.0774, -0.0795, -0.0576, -0.1752, -0.2821),
    ),
    "hind_side": LegTable(
        hip_amplitude=(
            -0.0438,
            -0.0114,
            -0.0934,
            -0.1998,
            -0.0806,
            -0.0716,
            -0.0647,
            -0.0234,
            -0.0197,
            -0.0314,
            0.0035,
        ),
        hip_offset=(-0.1941, -0.0811, -0.0236, -0.0184, 0.037, 0.0751, 0.0082, -0.0688, -0.1464, -0.1877, -0.3157),
        knee_cosine=(0.1436, 0.1193, 0.1723, 0.2082, 0.0979, 0.1073, 0.1754, 0.2313, 0.2263, -0.0974, -0.1049),
        knee_sine=(0.0576, 0.1485, 0.2137, 0.1558, 0.1332, 0.1672, 0.0502, 0.016, -0.0818, -0.0203, 0.0382),
        knee_offset=(0.3194, 0.3295, 0.218, 0.1073, 0.0074, 0.0718, -0.0064, 0.0455, -0.0045, 0.2409, 0.3033),
    ),
}
"""Parameters of the tuned `CommandedGait`."""
