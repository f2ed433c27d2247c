"""Random quantities of episodes: their starts, model parameters, commands, pushes and sensor noise."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.arrays import frozen
from quadruped_env.control.config import Range
from quadruped_env.control.interface import ControlInterface
from quadruped_env.control.memory import EpisodeMemory
from quadruped_env.simulation import Simulation, Tiles
from quadruped_env.task.commands import CommandSampler
from quadruped_env.task.config import TaskConfig
from quadruped_env.task.draws import Draws, Purposes
from quadruped_env.task.event import Event
from quadruped_env.task.model_fields import ModelField, Payload, check_physical
from quadruped_env.task.randomization import Active, Randomization, SensorError, between, ends_of, is_active
from quadruped_env.task.sensors import Quantity, Sensors
from quadruped_env.task.starts import Starts

Floats = NDArray[np.float64]
EnvIds = NDArray[np.intp]

_NO_STATE: Final = np.zeros((0, 0))


@dataclass(frozen=True, slots=True)
class _Recurring:
    """A randomization that repeats within an episode."""

    active: Active
    purposes: Purposes
    interval: Range
    duration: Range | None
    due: NDArray[np.int64]
    """Control step at which it applies next, (N,)."""
    until: NDArray[np.int64]
    """Control step at which what was applied ends; 0 if nothing lasts, (N,)."""

    @property
    def name(self) -> str:
        return self.active.name


class Randomizer:
    """Applies the randomizations of a task, and samples its commands and observation noise.

    Args:
        simulation: simulation of N robots.
        control: gait clocks and commands of the robots.
        draws: source of random numbers.
        config: ranges and terms.
    """

    def __init__(self, simulation: Simulation, control: ControlInterface, draws: Draws, config: TaskConfig) -> None:
        self._simulation, self._control, self._draws = simulation, control, draws
        self._xp = simulation.xp
        self._config = config
        robot = control.robot
        self._commands = CommandSampler(config.definition.commands, config.command)
        active = [r for r in config.definition.randomizations if is_active(config.randomization[r.name])]
        starting, recurring = [r for r in active if r.interval is None], [r for r in active if r.interval is not None]
        self.sensors = _sensors(simulation, config, active)
        """Errors of the sensors; None if they have none."""
        self._check(starting)
        self._recurring: list[_Recurring] = []
        self.memory = EpisodeMemory(control.num_envs, simulation.xp)
        self.command_due: NDArray[np.int64] = self.memory.zeros("command_due", dtype=np.int64)
        """Control step of the episode at which the next command is drawn, (N,)."""
        for r in recurring:
            lasting = {} if r.duration is None else {f"{r.name}/duration": 1}
            purposes = Purposes({r.name: r.draws(robot), f"{r.name}/interval": 1, **lasting})
            due, until = (self.memory.zeros(f"{r.name}_{which}", dtype=np.int64) for which in ("due", "until"))
            assert r.interval is not None
            interval = config.randomization[r.interval[0]]
            duration = None if r.duration is None else config.randomization[r.duration[0]]
            self._recurring.append(_Recurring(self._bound(r), purposes, interval, duration, due, until))
        self.starts = Starts(
            simulation,
            draws,
            self._commands,
            [self._bound(r) for r in starting],
            {entry.name: entry.interval for entry in self._recurring},
            self.sensors,
            at_origin=not isinstance(config.ground, Tiles),
        )
        """Draws the starts."""
        amplitudes, layout = config.randomization.noise_amplitude, control.layout
        amplitude = np.zeros(layout.width)
        for name, columns in layout.slices.items():
            amplitude[columns] = amplitudes[name]
        self._noisy = frozen(np.flatnonzero(amplitude))
        self._noise_amplitude = frozen(config.randomization.observation_noise * amplitude[self._noisy])
        # A draw is a hash of its column, so that leaving some out does not change the others.
        self._noise = Purposes({"observation_noise": layout.width})
        self._noise.constants = frozen(self._noise.constants[self._noisy])
        self._noise_values = self._xp.zeros((control.num_envs, layout.width))

    def _bound(self, randomization: Randomization) -> Active:
        return Active.of(randomization, self._config.randomization[randomization.name], self._simulation)

    def _check(self, starting: list[Randomization]) -> None:
        """Check that the ranges of the model's fields leave a model that is physically possible."""
        fields = [
            (r.name, part, ends_of(self._config.randomization[r.name]))
            for r in starting
            for part in (r.apply if isinstance(r.apply, tuple) else (r.apply,))
            if isinstance(part, (ModelField, Payload))
        ]
        units = {r.name: r.unit for r in starting}
        check_physical(fields, self._simulation, units.__getitem__)

    def begin_episodes(self, env_ids: EnvIds, place: Floats | None = None, command: Floats | None = None) -> Floats:
        """Set some envs (R,) to random initial states, and return their commands (R, C).

        Args:
            env_ids: indices of the envs.
            place: position (R, 2) of each start, m; None: the origin.
            command: commands (R, C); None: random.
        """
        simulation, sensors = self._simulation, self.sensors
        simulation.restore_model_fields(env_ids)
        if sensors is not None:
            sensors.memory.clear(env_ids)
        start = self.starts.of(env_ids, place)
        if sensors is not None:
            sensors.before_start(env_ids)
        simulation.reset(env_ids, start.qpos, start.qvel)
        if sensors is not None:
            sensors.after_start(env_ids)
        self.memory.clear(env_ids)
        waits = self._in_steps(start.waits)
        for i, entry in enumerate(self._recurring):
            entry.due[env_ids] = waits[:, i]
        self.command_due[env_ids] = waits[:, -1]
        if command is None:
            command = start.command
        self._control.reset(env_ids, start.phase, command)
        return command

    def next_command(self, env_ids: EnvIds) -> Floats:
        """New commands (R, C) for some envs (R,) in the middle of their episodes."""
        steps = self._control.steps[env_ids]
        command, seconds = self._commands.sample(self._draws.uniform(self._commands.purposes, env_ids, steps))
        self.command_due[env_ids] = steps + self._in_steps(seconds)
        return command

    def within_episodes(self, running: EnvIds | None) -> None:
        """Apply the randomizations that are due at this control step, in all envs or some (R,)."""
        steps = self._control.steps
        for entry in self._recurring:
            active, until = entry.active, entry.until
            if entry.duration is not None:
                env_ids = _among(np.flatnonzero((until > 0) & (steps >= until)), running)
                if len(env_ids):
                    until[env_ids] = 0
                    zeros = self._xp.zeros((len(env_ids), active.randomization.columns(self._control.robot)))
                    active.apply(self._event(env_ids), zeros)
            env_ids = _among(np.flatnonzero(steps >= entry.due), running)
            if len(env_ids):
                draws = self._draws.uniform(entry.purposes, env_ids, steps[env_ids])
                columns = entry.purposes.slices
                wait = between(entry.interval, draws[:, columns[f"{entry.name}/interval"].start])
                entry.due[env_ids] += self._in_steps(wait)
                if entry.duration is not None:
                    seconds = between(entry.duration, draws[:, columns[f"{entry.name}/duration"].start])
                    until[env_ids] = steps[env_ids] + self._in_steps(seconds)
                active.carry_out(self._event(env_ids), draws[:, columns[entry.name]])

    def _event(self, env_ids: EnvIds) -> Event:
        """Some envs (R,) within their episodes."""
        return Event(self._simulation, self._control.robot, env_ids, _NO_STATE, _NO_STATE, _NO_STATE, self.sensors)

    def observation_noise(self) -> Floats:
        """Noise on the unscaled readings (N, width), the same at the same step; overwritten by the next call."""
        uniform = self._draws.uniform(self._noise, slice(None), self._control.steps)
        self._noise_values[:, self._noisy] = self._noise_amplitude * (2.0 * uniform - 1.0)
        return self._noise_values

    def _in_steps(self, seconds: Floats) -> NDArray[np.int64]:
        return np.maximum(np.rint(seconds / self._config.control_timestep), 1.0).astype(np.int64)


def _among(env_ids: EnvIds, running: EnvIds | None) -> EnvIds:
    return env_ids if running is None else np.intersect1d(env_ids, running)


def _sensors(simulation: Simulation, config: TaskConfig, active: Sequence[Randomization]) -> Sensors | None:
    """Errors of the sensors that the active randomizations set; None if they set none."""
    largest: dict[Quantity, float] = {}
    for randomization in active:
        if isinstance(randomization.apply, SensorError):
            quantity, ends = randomization.apply.quantity, ends_of(config.randomization[randomization.name])
            largest[quantity] = max(largest.get(quantity, 0.0), *ends)
    return Sensors(simulation, config.control_timestep, largest) if largest else None
