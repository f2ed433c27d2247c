"""The scripted gaits with handles to turn: amplitude, frequency, and the phase of each leg."""

import math
from dataclasses import dataclass, replace
from typing import Final, Protocol, Self, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import CommandedGait, SinusoidalGait
from quadruped_env.robot import LEG_NAMES
from quadruped_env.task import Task, Transition

AMPLITUDES: Final = (0.0, 2.0)
FREQUENCIES: Final = (0.1, 4.0)
"""Hz"""

_COMMANDED: Final = "tuned"
"""The one preset that follows the command"""


@dataclass(frozen=True)
class GaitSettings:
    """What a person may change about a preset."""

    amplitude: float
    """Of every joint, as a multiple of the preset's"""
    frequency: float
    """Cycles per second, Hz"""
    phases: tuple[float, ...]
    """Of each leg's cycle, in cycles, in the order of `LEG_NAMES`"""

    def __post_init__(self) -> None:
        for name, value, (low, high) in (
            ("amplitude", self.amplitude, AMPLITUDES),
            ("frequency", self.frequency, FREQUENCIES),
        ):
            if not low <= value <= high:
                raise QuadrupedError(f"gait: {name} must be in {low:g} to {high:g}; found {value:g}")
        if len(self.phases) != len(LEG_NAMES) or not np.isfinite(self.phases).all():
            raise QuadrupedError(f"gait: phases must be {len(LEG_NAMES)} finite numbers; found {self.phases!r}")

    @classmethod
    def of(cls, preset: str) -> Self:
        """A preset as it is.

        Raises:
            QuadrupedError: if there is no such preset.
        """
        gait = SinusoidalGait.preset(preset)
        phases = tuple(phase / math.tau % 1.0 for phase in gait.phases[::2])
        return cls(1.0, gait.angular_frequency / math.tau, phases)


def edited(gait: SinusoidalGait, settings: GaitSettings) -> SinusoidalGait:
    """A gait with other amplitudes, frequency and leg phases; a knee keeps its lag behind its hip."""
    phases = []
    for leg, cycles in enumerate(settings.phases):
        hip, knee = gait.phases[2 * leg : 2 * leg + 2]
        phases += [math.tau * cycles, math.tau * cycles + knee - hip]
    return replace(
        gait,
        hip_amplitude=_scaled(gait.hip_amplitude, settings.amplitude),
        knee_amplitude=_scaled(gait.knee_amplitude, settings.amplitude),
        angular_frequency=math.tau * settings.frequency,
        phases=tuple(phases),
    )


def _scaled(amplitude: float | tuple[float, ...], factor: float) -> float | tuple[float, ...]:
    return tuple(factor * a for a in amplitude) if isinstance(amplitude, tuple) else factor * amplitude


@runtime_checkable
class HasGait(Protocol):
    """A controller whose scripted gait a person may change."""

    settings: GaitSettings | None
    """What the gait is now; None while there is none"""

    def complaints(self) -> list[str]:
        """What the gait asks for beyond the robot's limits."""
        ...


class EditableGaitController:
    """A preset with settings that may change at any time, without a jump of its phase.

    Args:
        preset: its name; `tuned` follows the command.
    """

    action_mode = "position"

    def __init__(self, preset: str) -> None:
        self.name = preset
        self._settings = GaitSettings.of(preset)
        self._time = 0.0
        """s that the gait would have taken to this phase at its present frequency"""
        self._gait = SinusoidalGait.preset(preset)
        self._command: tuple[float, float] | None = None

    @property
    def settings(self) -> GaitSettings:
        """What the gait is now."""
        return self._settings

    @settings.setter
    def settings(self, settings: GaitSettings) -> None:
        self._time *= self._settings.frequency / settings.frequency
        self._settings = settings
        self._command = None

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """See `quadruped_env.policies.Controller.step`."""
        if not task.steps[0]:
            self._time = 0.0
        command = float(task.command[0, 0]), float(task.command[0, 1])
        if command != self._command:
            self._command = command
            self._gait = edited(self._preset(command), self._settings)
        target = self._gait.positions(np.array([self._time]))
        self._time += task.config.control_timestep
        return task.step_joint_target(target)

    def complaints(self) -> list[str]:
        """What the gait asks for beyond the robot's limits."""
        return self._gait.violations()

    def _preset(self, command: tuple[float, float]) -> SinusoidalGait:
        return CommandedGait.tuned().at(command) if self.name == _COMMANDED else SinusoidalGait.preset(self.name)
