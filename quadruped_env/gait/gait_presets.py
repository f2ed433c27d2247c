"""Numbers of the scripted gaits: the tutorial's, and those that tools/tune_gait.py found."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final, NamedTuple

from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED

PRESETS: Final = ("article", "trot", "walk", "bound", "pace", "tuned", "crouched", "low", "fast")

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

    hip_sine: Sequence[float]
    hip_offset: Sequence[float]
    knee_cosine: Sequence[float]
    knee_sine: Sequence[float]
    knee_offset: Sequence[float]
    hip_cosine: Sequence[float]


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
        LegSinusoids(0.259, 0.545, 0.027, -0.059, -0.761, -0.064),
        LegSinusoids(0.274, 0.624, 0.223, -0.124, -1.073, 0.077),
    ),
    "walk": (
        12.0,
        LegSinusoids(0.201, 0.679, 0.063, -0.243, -0.8, 0.085),
        LegSinusoids(-0.104, 0.501, 0.016, 0.118, -0.958, 0.197),
    ),
    "bound": (
        14.0,
        LegSinusoids(0.132, 0.777, 0.101, -0.166, -0.639, 0.017),
        LegSinusoids(-0.004, 0.81, 0.198, -0.268, -1.006, -0.011),
    ),
    "pace": (
        14.0,
        LegSinusoids(-0.044, 0.481, 0.04, -0.187, -0.797, -0.048),
        LegSinusoids(-0.128, 0.404, 0.177, 0.222, -0.868, 0.133),
    ),
}
"""Preset -> angular frequency in rad/s, fore legs, hind legs; the phases are those of `LEG_PHASES`."""

COMMANDED: Final[Mapping[str, Mapping[str, Any]]] = MappingProxyType(
    json.loads((Path(__file__).parent / "commanded_gaits.json").read_text(encoding="utf-8"))
)
"""Parameters of the presets of `CommandedGait`, which follow a velocity command, as tools/tune_gait.py writes them."""
