"""Numbers of the scripted gaits: the tutorial's, the trot in closed form, and those that tools/tune_gait.py found."""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final, NamedTuple

from numpy.typing import ArrayLike

from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED

PRESETS: Final = ("article", "sinusoid", "trot", "walk", "bound", "pace", "tuned", "crouched", "low", "fast")

LEG_PHASES: Final = {
    "trot": (0.0, 0.5, 0.5, 0.0),
    "walk": (0.0, 0.5, 0.75, 0.25),
    "bound": (0.0, 0.0, 0.5, 0.5),
    "pace": (0.0, 0.5, 0.0, 0.5),
}
"""Phase of each leg by gait, in the order left fore, right fore, left hind, right hind, cycles."""

TUNED_ON: Final = MINI_QUADRUPED
"""Robot on which the numbers were found."""


@dataclass(frozen=True)
class LegTable:
    """Parameters of a leg's sinusoids: a joint's are its cosine * cos(w t + p) + sine * sin(w t + p) + offset.

    In rad, or rad per rad/s where they are what a yaw rate adds: one value per entry of `CommandedGait.speeds`, or one
    number where the gait has one speed.
    """

    hip_sine: ArrayLike
    hip_offset: ArrayLike
    knee_cosine: ArrayLike
    knee_sine: ArrayLike
    knee_offset: ArrayLike
    hip_cosine: ArrayLike


ARTICLE: Final[dict[str, Any]] = {
    "hip_amplitude": 0.4,
    "hip_offset": 0.0,
    "knee_amplitude": 0.3,
    "knee_offset": -0.3,
    "angular_frequency": 2.0,
    "phases": (0.0, 0.5, 3.14, 3.64, 1.57, 2.07, 4.71, 5.21),
}
"""Parameters of the tutorial's `SinusoidalGait`."""

SINUSOID: Final = "sinusoid"
"""Name of the trot in closed form, the base of `residual`."""

CLOCK_FREQUENCY: Final = 3.4
"""Frequency of the tuned robot's gait clock, Hz."""
LIFT: Final = 0.2
"""Angle by which the knee folds in a swing, rad."""
TURN_GAIN: Final = 4.0
"""Difference of the sides in a turn, relative to wheels that roll. Without sideways joints the feet of a turning robot
slide sideways, and friction acts along the sliding: only feet that slide faster along x turn the robot."""
SPEEDS: Final = (-1.0, 1.0)
"""Forward velocities between which the amplitude is proportional to the velocity, m/s."""
LARGEST_YAW_RATE: Final = 0.8


class Trot(NamedTuple):
    """Steps of a robot other than the built-in one, for which no gait was searched; of one as tall as that."""

    frequency: float = CLOCK_FREQUENCY
    """Cycles per second, Hz."""
    lift: float = 0.14
    """Height by which a foot rises in its swing, as a part of the stance's height."""
    height: float = 1.0
    """Height of the base, as a part of the stance's height."""
    largest_yaw_rate: float = LARGEST_YAW_RATE
    """rad/s."""
    phases: str = "trot"
    """Key of `LEG_PHASES`."""
    speed: float = 0.4
    """Forward velocity of its `SinusoidalGait`, m/s."""


TROTS: Final = {
    SINUSOID: Trot(),
    "tuned": Trot(),
    "crouched": Trot(3.6, height=0.9),
    "low": Trot(5.0, lift=0.07),
    "fast": Trot(3.2, largest_yaw_rate=1.2),
    "trot": Trot(),
    "walk": Trot(5.0, lift=0.07, phases="walk", speed=0.25),
    "bound": Trot(phases="bound", speed=0.35),
    "pace": Trot(5.0, lift=0.07, phases="pace", speed=0.3),
}
"""What takes the place of a preset on a robot other than the built-in one."""

TUNED_FOR_ONE_SPEED: Final = {
    "trot": (
        14.0,
        LegTable(0.259, 0.545, 0.027, -0.059, -0.761, -0.064),
        LegTable(0.274, 0.624, 0.223, -0.124, -1.073, 0.077),
    ),
    "walk": (
        12.0,
        LegTable(0.201, 0.679, 0.063, -0.243, -0.8, 0.085),
        LegTable(-0.104, 0.501, 0.016, 0.118, -0.958, 0.197),
    ),
    "bound": (
        14.0,
        LegTable(0.132, 0.777, 0.101, -0.166, -0.639, 0.017),
        LegTable(-0.004, 0.81, 0.198, -0.268, -1.006, -0.011),
    ),
    "pace": (
        14.0,
        LegTable(-0.044, 0.481, 0.04, -0.187, -0.797, -0.048),
        LegTable(-0.128, 0.404, 0.177, 0.222, -0.868, 0.133),
    ),
}
"""Preset -> angular frequency in rad/s, fore legs, hind legs; `LEG_PHASES` has the phases."""


def sinusoid(frequency: float) -> dict[str, Any]:
    """Parameters of the trot in closed form for the tuned robot, in the form of `COMMANDED`.

    With leg length L, lift a, and the forward velocity u of the leg's side (v + k r b / 2 on the right and
    v - k r b / 2 on the left, with the track width b, the turn's size r, see `turn_size`, and k = `TURN_GAIN`), a leg
    of phase p has

        hip  = stance + a / (2 pi) + u / (2.8 f L) cos(p) + a / 4 sin(p)
        knee = stance - a / pi                             - a / 2 sin(p)

    The feet swing forward while sin(p) > 0. The lift comes from a knee that folds by a max(0, sin(p)) and a hip that
    turns by half of it to keep the foot below, without their higher harmonics. During half a cycle on the ground the
    hip turns by twice its amplitude, at a mean speed of 1.4 u: the servos lag behind their targets. The clock has the
    frequency f in Hz.
    """
    hip, knee = TUNED_ON.stance[:2].tolist()
    stride = 1.0 / (2.8 * frequency * TUNED_ON.stance_height)
    half_track = float(abs(TUNED_ON.stance_feet[0, 1]))
    none = dict.fromkeys(LegTable.__dataclass_fields__, (0.0, 0.0))
    straight = {
        "hip_sine": (LIFT / 4.0,) * 2,
        "hip_offset": (hip + LIFT / math.tau,) * 2,
        "knee_cosine": (0.0, 0.0),
        "knee_sine": (-LIFT / 2.0,) * 2,
        "knee_offset": (knee - LIFT / math.pi,) * 2,
        "hip_cosine": tuple(stride * speed for speed in SPEEDS),
    }
    side = {**none, "hip_cosine": (TURN_GAIN * stride * half_track,) * 2}
    return {
        "angular_frequency": math.tau * frequency,
        "speeds": SPEEDS,
        "largest_yaw_rate": LARGEST_YAW_RATE,
        **dict.fromkeys(("fore", "hind"), straight),
        **dict.fromkeys(("fore_turn", "hind_turn"), none),
        **dict.fromkeys(("fore_side", "hind_side"), side),
    }


COMMANDED: Final[Mapping[str, Mapping[str, Any]]] = MappingProxyType(
    {
        SINUSOID: sinusoid(CLOCK_FREQUENCY),
        **json.loads((Path(__file__).parent / "commanded_gaits.json").read_text(encoding="utf-8")),
    }
)
"""Parameters of the presets of `CommandedGait`, which follow a velocity command: the sinusoid, and those that
tools/tune_gait.py writes."""
