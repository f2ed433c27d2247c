"""User settings of a scripted gait: amplitude, frequency, and the phase of each leg."""

import math
from dataclasses import dataclass, replace
from typing import Annotated, Final, Self

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait.gaits import SinusoidalGait
from quadruped_env.utils.fields import Fields, check
from quadruped_env.utils.parameters import Parameter

AMPLITUDES: Final = (0.0, 2.0)
"""Range of the amplitude, as a multiple of the preset's."""
FREQUENCIES: Final = (0.1, 6.0)
"""Range of the frequency, Hz."""


def _finite(phases: tuple[float, ...], path: str) -> tuple[float, ...]:
    check(bool(np.isfinite(phases).all()), path, phases, f"{len(phases)} finite numbers")
    return phases


@dataclass(frozen=True)
class GaitSettings(Fields, path="gait"):
    """Settings that modify a preset."""

    amplitude: Annotated[float, Parameter("1", *AMPLITUDES)]
    """Amplitude of every joint, as a multiple of the preset's."""
    frequency: Annotated[float, Parameter("Hz", *FREQUENCIES)]
    """Cycles per second, Hz."""
    phases: Annotated[tuple[float, ...], _finite]
    """Phase of each leg, in cycles, in the order of the robot's legs."""

    @classmethod
    def of(cls, gait: SinusoidalGait) -> Self:
        """Return settings that leave a gait unchanged."""
        phases = tuple(gait.phases[joints[-2]] / math.tau % 1.0 for joints in gait.robot.leg_joints)
        return cls(1.0, gait.angular_frequency / math.tau, phases)


def edited(gait: SinusoidalGait, settings: GaitSettings) -> SinusoidalGait:
    """Return a gait with other amplitudes, frequency and leg phases; each joint keeps its phase lag to the leg.

    Raises:
        QuadrupedError: if there is not one phase per leg of the robot.
    """
    if len(settings.phases) != gait.robot.num_legs:
        raise QuadrupedError(f"gait: expected {gait.robot.num_legs} phases, one per leg; found {len(settings.phases)}")
    phases = list(gait.phases)
    for joints, cycles in zip(gait.robot.leg_joints, settings.phases, strict=True):
        for joint in joints:
            phases[joint] = math.tau * cycles + gait.phases[joint] - gait.phases[joints[-2]]
    return replace(
        gait,
        hip_amplitude=_scaled(gait.hip_amplitude, settings.amplitude),
        knee_amplitude=_scaled(gait.knee_amplitude, settings.amplitude),
        angular_frequency=math.tau * settings.frequency,
        phases=tuple(phases),
    )


def _scaled(amplitude: float | tuple[float, ...], factor: float) -> float | tuple[float, ...]:
    return tuple(factor * a for a in amplitude) if isinstance(amplitude, tuple) else factor * amplitude
