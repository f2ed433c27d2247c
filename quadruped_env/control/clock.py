"""Frequency of the gait clock: constant, or a function of the velocity command."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.parameters import LARGEST, SMALLEST, is_quantity
from quadruped_env.utils.plain import Plain, PlainFields, plain

FIELD: Final = "clock_frequency"
UNITS: Final = {"speeds": "m/s", "frequencies": "Hz", "turn_arm": "m"}
"""Unit of each field of a `CommandedFrequency`."""


@dataclass(frozen=True)
class CommandedFrequency(PlainFields):
    """Frequency of the gait clock that follows the commanded speed: |forward velocity| + turn_arm * |yaw rate|.

    It is linear between the given speeds, and constant beyond them.
    """

    speeds: tuple[float, ...]
    """Commanded speeds (K,), 0 or more and increasing, m/s."""
    frequencies: tuple[float, ...]
    """Frequency at each of them (K,), cycles per second."""
    turn_arm: float = 0.4
    """Speed per yaw rate, m."""

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("speeds", "frequencies"):
            values = getattr(self, name)
            valid = isinstance(values, tuple) and len(values) >= 2 and all(map(is_quantity, values))
            _check(valid, name, values, f"a list of two or more numbers, at most {LARGEST:g}")
        rising = self.speeds[0] >= 0 and all(low < high for low, high in pairwise(self.speeds))
        _check(rising, "speeds", self.speeds, "0 or more, and increasing (m/s)")
        fits = len(self.frequencies) == len(self.speeds)
        _check(fits, "frequencies", self.frequencies, f"as many as the speeds, {len(self.speeds)}")
        _check(all(value >= SMALLEST for value in self.frequencies), "frequencies", self.frequencies, "positive (Hz)")
        arm = self.turn_arm
        _check(is_quantity(arm, 0.0), "turn_arm", arm, f"0 or more (m), at most {LARGEST:g}")


Frequency = float | CommandedFrequency


def frequency_of(value: Plain) -> Frequency:
    """The frequency from a config's value: a number in Hz, or a `CommandedFrequency` or its fields.

    Raises:
        QuadrupedError: if it is not valid; the message names the field.
    """
    value = plain(value) if not isinstance(value, CommandedFrequency) else value
    if isinstance(value, CommandedFrequency):
        return value
    if isinstance(value, Mapping):
        try:
            return CommandedFrequency(**value)
        except TypeError as error:
            raise QuadrupedError(
                f"config.{FIELD}: expected a frequency (Hz), or speeds and frequencies, such as "
                f"{{'speeds': [0.0, 0.6], 'frequencies': [2.6, 3.2]}}, and turn_arm; found {short(value)}"
            ) from error
    if not is_quantity(value, SMALLEST):
        raise QuadrupedError(
            f"config: {FIELD} must be positive (Hz), at most {LARGEST:g}, or a mapping with speeds and frequencies; "
            f"found {short(value)}"
        )
    return float(value)


def frequency_at(frequency: Frequency, velocity: Floats) -> Floats:
    """Frequency (N,) in Hz for velocity commands (N, 2) in m/s and rad/s."""
    if isinstance(frequency, CommandedFrequency):
        speed = np.abs(velocity[:, 0]) + frequency.turn_arm * np.abs(velocity[:, 1])
        return np.interp(speed, frequency.speeds, frequency.frequencies)
    return np.full_like(velocity[:, 0], frequency)


def middle_frequency(frequency: Frequency) -> float:
    """The frequency of a constant clock, or the mean of a variable one's lowest and highest, Hz."""
    if isinstance(frequency, CommandedFrequency):
        return 0.5 * (min(frequency.frequencies) + max(frequency.frequencies))
    return frequency


def _check(condition: bool, name: str, value: object, rule: str) -> None:
    if not condition:
        raise QuadrupedError(f"config: {FIELD}.{name} must be {rule}; found {short(value)}")
