"""A scripted gait whose settings can be changed while it runs."""

import math
from dataclasses import replace
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.gait import COMMANDED, CommandedGait, SinusoidalGait
from quadruped_env.gait.gait_settings import GaitSettings, edited
from quadruped_env.robot.robot import Robot


@runtime_checkable
class HasGait(Protocol):
    """A controller with a scripted gait whose settings can be changed."""

    settings: GaitSettings | None
    """Current settings; None while there is no gait."""

    def complaints(self) -> list[str]:
        """Messages about joint limits that the gait exceeds; empty if there are none."""
        ...


class EditableGaitController:
    """A preset whose settings can be changed at any time without a jump in its phase.

    Args:
        preset: name of the preset; `tuned`, `crouched`, `low` and `fast` follow the velocity command.
        robot: robot that walks.
    """

    action_mode = "position"

    def __init__(self, preset: str, robot: Robot) -> None:
        self.name = preset
        self.follows_command = preset in COMMANDED
        self._robot = robot
        self._time = 0.0
        """Time in which the gait reaches its current phase at its current frequency, s."""
        self._gait = SinusoidalGait.preset(preset, robot)
        self._settings = GaitSettings.of(self._gait)
        self._command: tuple[float, float] | None = None

    @property
    def settings(self) -> GaitSettings:
        """Current settings."""
        return self._settings

    @settings.setter
    def settings(self, settings: GaitSettings) -> None:
        self._time *= self._settings.frequency / settings.frequency
        self._settings = settings
        self._command = None

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> NDArray[np.float64]:
        """See `quadruped_env.control.Controller.act`."""
        if control.time[0] == 0.0:
            # A gait that follows the command begins in phase with the task's clock, by which the reward judges it.
            start = control.phase[0] if self.follows_command else 0.0
            self._time = float(start) / (math.tau * self._settings.frequency)
        command = float(control.command[0, 0]), float(control.command[0, 1])
        if command != self._command:
            self._command = command
            self._gait = self._edited(self._preset(command))
        target = self._gait.positions(np.array([self._time]))
        self._time += control.config.timestep
        return target

    def _edited(self, gait: SinusoidalGait) -> SinusoidalGait:
        """The gait with the current settings."""
        if not self.follows_command:
            return edited(gait, self._settings)
        # The hips' phases depend on the command; the settings are those of the preset, so its phases are subtracted.
        preset = GaitSettings.of(SinusoidalGait.preset(self.name, self._robot)).phases
        own = zip(GaitSettings.of(gait).phases, self._settings.phases, preset, strict=True)
        phases = tuple((phase + setting - base) % 1.0 for phase, setting, base in own)
        return edited(gait, replace(self._settings, phases=phases))

    def complaints(self) -> list[str]:
        """Messages about joint limits that the gait exceeds; empty if there are none."""
        return self._gait.violations()

    def _preset(self, command: tuple[float, float]) -> SinusoidalGait:
        if self.follows_command:
            return CommandedGait.preset(self.name, self._robot).at(command)
        return SinusoidalGait.preset(self.name, self._robot)
