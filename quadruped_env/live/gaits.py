"""The scripted gait that is published, with settings that come as messages: `/gait` and `/gait/settings`."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import SinusoidalGait
from quadruped_env.gait_settings import GaitSettings, edited
from quadruped_env.live.topics import GAIT
from quadruped_env.robot import LEG_NAMES
from quadruped_env.ros import cdr

_NUMBERS = 2 + len(LEG_NAMES)


class AdjustableGait:
    """A preset with settings that may change at any time; a change of frequency does not make its phase jump.

    Args:
        preset: its name.
    """

    def __init__(self, preset: str) -> None:
        self._preset = self._gait = SinusoidalGait.preset(preset)
        self._settings = GaitSettings.of(preset)
        self._time_offset = 0.0
        """s by which the phase is ahead of the time at the present frequency"""

    @property
    def settings(self) -> GaitSettings:
        """What the gait is now."""
        return self._settings

    def change(self, settings: GaitSettings, t: float) -> None:
        """Take other settings from a time in s on."""
        self._time_offset = (t + self._time_offset) * self._settings.frequency / settings.frequency - t
        self._settings = settings
        self._gait = edited(self._preset, settings)

    def positions(self, t: float) -> NDArray[np.float64]:
        """Joint positions at a time in s, rad (8,)."""
        return self._gait.positions(t + self._time_offset)

    def velocities(self, t: float) -> NDArray[np.float64]:
        """Joint velocities at a time in s, rad/s (8,)."""
        return self._gait.velocities(t + self._time_offset)

    def violations(self) -> list[str]:
        """Limits of the joints that the gait exceeds, in words."""
        return self._gait.violations()


def settings_message(settings: GaitSettings) -> Any:
    """A message of `/gait` or `/gait/settings`."""
    return cdr.message(GAIT.type_name, data=[settings.amplitude, settings.frequency, *settings.phases])


def read_settings(message: Any) -> GaitSettings:
    """The settings that a message of `/gait` or `/gait/settings` holds.

    Raises:
        QuadrupedError: if it does not hold six numbers, or one is outside its range.
    """
    if len(message.data) != _NUMBERS:
        raise QuadrupedError(
            f"holds {len(message.data)} numbers; send {_NUMBERS}: amplitude as a multiple, frequency in Hz, and the "
            f"phase of {', '.join(LEG_NAMES)} in cycles"
        )
    amplitude, frequency, *phases = message.data.tolist()
    return GaitSettings(amplitude, frequency, tuple(phase % 1.0 for phase in phases))
