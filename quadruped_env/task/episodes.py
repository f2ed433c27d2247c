"""Random quantities of episodes: initial states, model parameters, commands, pushes and sensor noise."""

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env import rotations
from quadruped_env.control.interface import ControlInterface
from quadruped_env.control.memory import EpisodeMemory
from quadruped_env.simulation import Simulation, highest_ground
from quadruped_env.task.commands import CommandSampler
from quadruped_env.task.config import TaskConfig
from quadruped_env.task.draws import Draws, Purposes
from quadruped_env.task.randomization import Event, Randomization, between, bound, is_active

Floats = NDArray[np.float64]
EnvIds = NDArray[np.intp]

_START_CLEARANCE: Final = 0.01
"""Height of the stance above the ground below it at the start, so that randomized legs do not penetrate it, m."""

_NO_STATE: Final = np.zeros((0, 0))


@dataclass(frozen=True, slots=True)
class _Active:
    """A randomization whose setting is not zero or None."""

    randomization: Randomization
    apply: Any
    setting: Any
    columns: slice

    def carry_out(self, event: Event, draws: Floats) -> None:
        self.apply(event, self.randomization.values(draws[:, self.columns], self.setting))


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
        self._config = config
        robot = control.robot
        self._commands = CommandSampler(config.definition.commands, config.command)
        active = [r for r in config.definition.randomizations if is_active(config.randomization[r.name])]
        starting, recurring = [r for r in active if r.interval is None], [r for r in active if r.interval is not None]
        starts = Purposes({r.name: r.draws(robot) for r in starting})
        self._at_start = (
            starts + Purposes({"phase": 1, **{f"{r.name}/interval": 1 for r in recurring}}) + self._commands.purposes
        )
        self._command_columns = slice(
            self._at_start.slices["command/kind"].start, self._at_start.slices["command/interval"].stop
        )
        self._starts = [self._bound(r, starts) for r in starting]
        self._events = []
        self.memory = EpisodeMemory(control.num_envs)
        self.command_due: NDArray[np.int64] = self.memory.zeros("command_due", dtype=np.int64)
        """Control step of the episode at which the next command is drawn, (N,)."""
        for r in recurring:
            purposes = Purposes({r.name: r.draws(robot), f"{r.name}/interval": 1})
            due = self.memory.zeros(f"{r.name}_due", dtype=np.int64)
            assert r.interval is not None
            self._events.append((self._bound(r, purposes), purposes, config.randomization[r.interval[0]], due))
        names = {"start_joint_position", "start_tilt"}
        self._clearance = _START_CLEARANCE if any(r.name in names for r in active) else 0.0
        self._noise_amplitude = config.randomization.observation_noise * control.layout.noise
        self._noise = Purposes({"observation_noise": control.layout.width})

    def _bound(self, randomization: Randomization, purposes: Purposes) -> _Active:
        return _Active(
            randomization,
            bound(randomization, self._simulation),
            self._config.randomization[randomization.name],
            purposes.slices[randomization.name],
        )

    def begin_episodes(self, env_ids: EnvIds, place: Floats | None = None) -> Floats:
        """Set some envs (R,) to random initial states, and return their commands (R, C).

        Args:
            env_ids: indices of the envs.
            place: position (R, 2) of each start, m; None: the origin.
        """
        draws = self._draws.uniform(self._at_start, env_ids, np.zeros(len(env_ids), dtype=np.int64))
        control, robot = self._control, self._control.robot
        event = Event(
            self._simulation,
            robot,
            env_ids,
            qpos=np.zeros((len(env_ids), robot.num_positions)),
            qvel=np.zeros((len(env_ids), robot.num_velocities)),
            tilt=np.zeros((len(env_ids), 3)),
        )
        event.qpos[:, 2] = robot.stance_height + self._clearance
        event.qpos[:, 7:] = robot.stance
        if place is not None:
            event.qpos[:, :2] = place
        for start in self._starts:
            start.carry_out(event, draws)
        event.qpos[:, 2] += highest_ground(self._simulation, event.qpos[:, :2])
        event.qpos[:, 3:7] = rotations.from_roll_pitch_yaw(event.tilt)
        self._simulation.reset(env_ids, event.qpos, event.qvel)
        self.memory.clear(env_ids)
        control.reset(env_ids, math.tau * draws[:, self._at_start.slices["phase"].start])
        for active, _, interval, due in self._events:
            column = self._at_start.slices[f"{active.randomization.name}/interval"].start
            due[env_ids] = self._in_steps(between(interval, draws[:, column]))
        command, seconds = self._commands.sample(draws[:, self._command_columns])
        self.command_due[env_ids] = self._in_steps(seconds)
        return command

    def next_command(self, env_ids: EnvIds) -> Floats:
        """New commands (R, C) for some envs (R,) in the middle of their episodes."""
        steps = self._control.steps[env_ids]
        command, seconds = self._commands.sample(self._draws.uniform(self._commands.purposes, env_ids, steps))
        self.command_due[env_ids] = steps + self._in_steps(seconds)
        return command

    def within_episodes(self, running: EnvIds | None) -> None:
        """Apply the randomizations that are due at this control step, in all envs or some (R,)."""
        for active, purposes, interval, due in self._events:
            env_ids = np.flatnonzero(self._control.steps >= due)
            if running is not None:
                env_ids = np.intersect1d(env_ids, running)
            if len(env_ids):
                draws = self._draws.uniform(purposes, env_ids, self._control.steps[env_ids])
                due[env_ids] += self._in_steps(between(interval, draws[:, -1]))
                event = Event(self._simulation, self._control.robot, env_ids, _NO_STATE, _NO_STATE, _NO_STATE)
                active.carry_out(event, draws)

    def observation_noise(self) -> Floats:
        """Noise on the unscaled readings (N, width); identical if called again at the same step."""
        uniform = self._draws.uniform(self._noise, slice(None), self._control.steps)
        return self._noise_amplitude * (2.0 * uniform - 1.0)

    def _in_steps(self, seconds: Floats) -> NDArray[np.int64]:
        return np.maximum(np.rint(seconds / self._config.control_timestep), 1.0).astype(np.int64)
