"""A scripted gait with settings that are changed by messages: `/gait` and `/gait/settings`."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import SinusoidalGait
from quadruped_env.gait.gait_settings import GaitSettings, edited
from quadruped_env.live.middleware.topics import GAIT
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import cdr


class AdjustableGait:
    """A gait preset with settings that may change at any time; the phase stays continuous when the frequency changes.

    Args:
        preset: name of the preset.
        robot: robot that walks.
    """

    def __init__(self, preset: str, robot: Robot) -> None:
        self._preset = self._gait = SinusoidalGait.preset(preset, robot)
        self._settings = GaitSettings.of(self._preset)
        self._time_offset = 0.0
        """Time offset that keeps the phase continuous over frequency changes, s."""

    @property
    def settings(self) -> GaitSettings:
        """The current settings."""
        return self._settings

    def change(self, settings: GaitSettings, t: float) -> None:
        """Apply new settings from time `t` (s) on."""
        self._time_offset = (t + self._time_offset) * self._settings.frequency / settings.frequency - t
        self._settings = settings
        self._gait = edited(self._preset, settings)

    def positions(self, t: float) -> NDArray[np.float64]:
        """Joint positions at time `t` (s), rad (J,)."""
        return self._gait.positions(t + self._time_offset)

    def velocities(self, t: float) -> NDArray[np.float64]:
        """Joint velocities at time `t` (s), rad/s (J,)."""
        return self._gait.velocities(t + self._time_offset)

    def violations(self) -> list[str]:
        """Descriptions of the joint limits that the gait exceeds."""
        return self._gait.violations()


def settings_message(settings: GaitSettings) -> Any:
    """A `/gait` or `/gait/settings` message."""
    return cdr.message(GAIT.type_name, data=[settings.amplitude, settings.frequency, *settings.phases])


def read_settings(message: Any, robot: Robot) -> GaitSettings:
    """The settings of a `/gait` or `/gait/settings` message.

    Raises:
        QuadrupedError: if it does not hold two numbers and one per leg, or one is outside its range.
    """
    expected = 2 + robot.num_legs
    if len(message.data) != expected:
        raise QuadrupedError(
            f"holds {len(message.data)} numbers; send {expected}: amplitude as a multiple, frequency in Hz, and the "
            f"phase of {', '.join(robot.leg_names)} in cycles"
        )
    amplitude, frequency, *phases = message.data.tolist()
    return GaitSettings(amplitude, frequency, tuple(phase % 1.0 for phase in phases))
