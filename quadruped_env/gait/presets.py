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
    "speeds": (-0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6),
    "largest_yaw_rate": 0.8,
    "fore": LegTable(
        hip_amplitude=(0.2753, 0.2925, 0.3035, 0.2934, 0.0701, 0.0953, 0.056, 0.0123, -0.064, -0.234, -0.2681),
        hip_offset=(0.899, 0.8613, 0.8213, 0.8974, 0.2102, 0.154, 0.1775, 0.2072, 0.2154, 0.2582, 0.1523),
        knee_cosine=(0.2754, 0.2587, 0.2372, 0.1582, -0.1244, -0.0043, -0.0945, -0.077, -0.1408, -0.2656, -0.273),
        knee_sine=(0.0325, -0.051, -0.1304, -0.1577, -0.2179, -0.2951, -0.2491, -0.2415, -0.2395, -0.1039, -0.0876),
        knee_offset=(-0.6043, -0.6076, -0.6167, -0.6521, -1.016, -0.9742, -0.9206, -0.912, -0.9295, -0.8935, -0.8389),
    ),
    "hind": LegTable(
        hip_amplitude=(0.2874, 0.2836, 0.2616, 0.1776, 0.1842, 0.133, -0.0005, -0.0565, -0.1436, -0.2229, -0.3012),
        hip_offset=(0.869, 0.812, 0.6896, 0.7583, 0.5009, 0.5829, 0.5347, 0.4291, 0.3986, 0.3535, 0.2864),
        knee_cosine=(-0.172, -0.1452, -0.1193, -0.113, 0.001, 0.0463, 0.0982, 0.1732, 0.1843, 0.1965, 0.1784),
        knee_sine=(-0.2113, -0.2555, -0.2767, -0.2732, -0.2987, -0.2727, -0.2296, -0.2408, -0.2024, -0.1455, -0.1391),
        knee_offset=(-0.9546, -0.9778, -0.8967, -1.0665, -1.1478, -1.0614, -0.9737, -0.8876, -0.897, -0.9119, -0.9201),
    ),
    "fore_turn": LegTable(
        hip_amplitude=(-0.1085, -0.1198, -0.1154, -0.1064, -0.0944, -0.0213, -0.0002, -0.0474, 0.0594, 0.079, 0.1771),
        hip_offset=(-0.1431, -0.1195, -0.0755, 0.1095, 0.441, 0.2926, 0.146, 0.1582, 0.2272, 0.1649, 0.2451),
        knee_cosine=(-0.1544, -0.1801, -0.0401, 0.0658, 0.1906, 0.0959, 0.1289, 0.0992, 0.3168, 0.3332, 0.1856),
        knee_sine=(0.1039, 0.2092, 0.2976, 0.1822, 0.1316, 0.1921, 0.0662, 0.0592, 0.1019, 0.0972, -0.1477),
        knee_offset=(-0.0506, -0.0538, -0.0739, -0.1108, -0.1848, -0.2314, -0.3163, -0.1275, -0.1414, -0.1321, 0.0437),
    ),
    "hind_turn": LegTable(
        hip_amplitude=(
            -0.1136,
            -0.1097,
            -0.0987,
            -0.2026,
            -0.2471,
            -0.2759,
            -0.1266,
            -0.1882,
            -0.0316,
            -0.0583,
            0.0854,
        ),
        hip_offset=(-0.0403, -0.0096, -0.1351, -0.3173, -0.4042, -0.4867, -0.4098, -0.1414, -0.1875, -0.1226, 0.0389),
        knee_cosine=(0.0668, 0.087, 0.2457, 0.1556, 0.1055, 0.0966, -0.0447, -0.1385, -0.0757, -0.2005, -0.1003),
        knee_sine=(0.3299, 0.2948, 0.2573, 0.1573, 0.1676, 0.1934, 0.1306, 0.1411, 0.0204, -0.1041, -0.0957),
        knee_offset=(0.2889, 0.2852, 0.2379, 0.2734, -0.0201, -0.1848, -0.0784, 0.238, 0.356, 0.3486, 0.3078),
    ),
    "fore_side": LegTable(
        hip_amplitude=(-0.0024, -0.0725, -0.0609, -0.0322, -0.0382, 0.0551, -0.0124, 0.1068, 0.1669, 0.0075, -0.1108),
        hip_offset=(0.0478, 0.0789, 0.0089, 0.0654, 0.1369, 0.0558, 0.1003, -0.153, -0.1774, -0.2806, -0.1715),
        knee_cosine=(0.1041, 0.0185, 0.0618, 0.0681, -0.0238, 0.0448, 0.1803, 0.0741, -0.0068, 0.0399, -0.0347),
        knee_sine=(-0.1975, -0.1584, -0.102, -0.047, -0.0394, 0.0112, -0.0445, 0.006, 0.0857, 0.0786, -0.0487),
        knee_offset=(-0.0884, -0.1547, -0.2215, -0.2182, -0.0613, -0.0404, -0.0662, -0.0558, 0.0014, -0.0867, -0.2799),
    ),
    "hind_side": LegTable(
        hip_amplitude=(-0.062, 0.0166, -0.1417, -0.2145, -0.0595, -0.1073, -0.0912, -0.0763, -0.1284, 0.0171, -0.0469),
        hip_offset=(-0.1583, -0.1655, -0.1499, -0.118, 0.0709, 0.1093, -0.0303, -0.0907, -0.0218, -0.0874, -0.0903),
        knee_cosine=(0.1652, 0.2092, 0.1992, 0.1107, 0.0871, 0.1274, 0.173, 0.1016, -0.0398, -0.0947, -0.1744),
        knee_sine=(0.1047, 0.1489, 0.216, 0.1141, 0.1663, 0.2128, 0.2037, -0.0516, 0.0246, -0.059, -0.0835),
        knee_offset=(0.3717, 0.3089, 0.2831, 0.2414, 0.1372, 0.1035, 0.1043, 0.0634, 0.0254, 0.0235, -0.0764),
    ),
}
"""Parameters of the tuned `CommandedGait`."""
