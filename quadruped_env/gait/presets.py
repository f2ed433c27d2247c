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
        LegSinusoids(-0.098, 0.249, 0.022, -0.106, -0.968),
        LegSinusoids(0.027, 0.513, 0.254, -0.147, -0.979),
    ),
}
"""Preset -> angular frequency in rad/s, fore legs, hind legs; the phases are those of `LEG_PHASES`."""

TUNED: Final[dict[str, Any]] = {
    "angular_frequency": math.tau * 2.6,
    "speeds": (-0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6),
    "largest_yaw_rate": 0.8,
    "fore": LegTable(
        hip_amplitude=(0.2934, 0.2952, 0.2997, 0.2943, 0.1086, -0.0377, -0.001, -0.0072, -0.1261, -0.2003, -0.256),
        hip_offset=(0.9253, 0.8975, 0.8694, 0.9915, 0.1434, 0.1056, 0.1295, 0.2536, 0.2727, 0.1898, 0.215),
        knee_cosine=(0.2686, 0.2344, 0.1996, 0.115, -0.1109, 0.1244, 0.0504, -0.1164, -0.1784, -0.2699, -0.2902),
        knee_sine=(0.048, -0.0338, -0.1098, -0.1654, -0.2539, -0.2249, -0.2328, -0.2253, -0.148, -0.107, -0.0772),
        knee_offset=(-0.6398, -0.6576, -0.6904, -0.7892, -1.0053, -1.0127, -0.9609, -0.9489, -0.9524, -0.8434, -0.8401),
    ),
    "hind": LegTable(
        hip_amplitude=(0.2839, 0.286, 0.2479, 0.1931, 0.1815, 0.0897, 0.0159, -0.0511, -0.1831, -0.2738, -0.2995),
        hip_offset=(0.8064, 0.7554, 0.6877, 0.665, 0.5, 0.4969, 0.5227, 0.4713, 0.3809, 0.2299, 0.1948),
        knee_cosine=(-0.1856, -0.1378, -0.1123, -0.0991, 0.007, 0.0015, -0.0083, 0.1288, 0.119, 0.1557, 0.1718),
        knee_sine=(-0.2268, -0.2666, -0.2753, -0.2871, -0.2999, -0.2489, -0.2407, -0.259, -0.1935, -0.2124, -0.1942),
        knee_offset=(-0.9213, -0.9378, -0.8991, -0.9546, -1.2216, -1.104, -1.0042, -0.9386, -0.8995, -0.974, -0.8682),
    ),
    "fore_turn": LegTable(
        hip_amplitude=(-0.1176, -0.1356, -0.1394, -0.1675, -0.2208, -0.0442, -0.0206, -0.0547, -0.0421, 0.0075, 0.0252),
        hip_offset=(0.0272, 0.0274, 0.0673, 0.0104, 0.1038, 0.1438, 0.133, 0.0079, -0.0105, 0.2137, 0.2081),
        knee_cosine=(-0.179, -0.0602, -0.0385, -0.0077, -0.0152, -0.0747, -0.0469, 0.1337, 0.1703, 0.3451, 0.3685),
        knee_sine=(0.126, 0.1444, 0.2243, 0.248, 0.0122, 0.1116, 0.0987, 0.1169, 0.0935, 0.0149, -0.0608),
        knee_offset=(-0.1418, -0.1436, -0.0954, -0.0479, -0.2099, -0.2079, -0.1907, -0.1879, -0.1044, -0.153, -0.2828),
    ),
    "hind_turn": LegTable(
        hip_amplitude=(-0.1187, -0.1406, -0.1552, -0.1219, -0.1216, -0.125, -0.1566, -0.2678, -0.0715, 0.0643, 0.0769),
        hip_offset=(0.0328, -0.0723, -0.2225, -0.2225, -0.257, -0.3411, -0.2836, -0.2017, 0.0246, 0.163, 0.1513),
        knee_cosine=(0.009, 0.0021, 0.067, 0.1399, 0.0675, 0.1083, 0.0927, -0.2528, -0.2126, -0.2493, -0.2819),
        knee_sine=(0.2227, 0.2824, 0.2983, 0.3244, 0.1772, 0.112, 0.121, 0.1845, 0.0651, 0.0803, 0.0026),
        knee_offset=(0.1448, 0.2053, 0.2273, 0.2849, 0.1339, 0.0639, -0.129, -0.1522, -0.1892, 0.1205, 0.1426),
    ),
    "fore_side": LegTable(
        hip_amplitude=(-0.0949, -0.1235, -0.075, -0.0756, -0.256, -0.1442, -0.1216, -0.2112, -0.1024, -0.1123, 0.0763),
        hip_offset=(0.0705, 0.0842, 0.1066, 0.0079, 0.1341, -0.0917, -0.06, -0.0583, -0.0686, 0.0792, 0.1002),
        knee_cosine=(0.0114, -0.012, 0.0084, -0.0283, 0.1016, 0.0599, 0.1548, 0.1387, 0.2757, 0.3133, 0.3299),
        knee_sine=(-0.1444, -0.1412, -0.128, -0.0576, -0.06, -0.0508, -0.0088, 0.0463, -0.1944, -0.035, 0.0158),
        knee_offset=(-0.166, -0.2633, -0.4094, -0.1982, -0.0105, -0.0792, -0.0415, -0.1149, -0.1157, -0.0456, 0.1783),
    ),
    "hind_side": LegTable(
        hip_amplitude=(-0.045, -0.0449, -0.0086, 0.0443, -0.0351, -0.0907, -0.0666, -0.0117, -0.0397, -0.0685, -0.0775),
        hip_offset=(-0.1004, -0.0815, -0.0032, 0.0586, -0.0339, -0.0806, -0.1408, -0.227, -0.2007, -0.2216, -0.1335),
        knee_cosine=(0.062, 0.1092, 0.1096, 0.1514, 0.0271, 0.1532, 0.1619, 0.1342, 0.2535, 0.2838, 0.2541),
        knee_sine=(0.1518, 0.1484, 0.1907, 0.2611, 0.1738, 0.1369, 0.092, -0.1182, -0.0416, -0.0511, -0.0456),
        knee_offset=(0.4632, 0.4089, 0.3161, 0.3093, 0.0997, 0.1715, 0.1878, 0.0933, 0.0725, 0.1774, 0.2622),
    ),
}
"""Parameters of the tuned `CommandedGait`."""
