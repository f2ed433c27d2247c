"""The task: from actions to observations, rewards and the ends of episodes, for any number of rows.

Written once, it drives the single and the vectorized environment. A row's numbers do not depend on how many rows
there are: see the rules in CONTRIBUTING.md before changing an expression here.
"""

import copy
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from gymnasium.utils import seeding
from numpy.typing import ArrayLike, NDArray

from quadruped_env._plain import whole_number
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import JOINT_PHASES, CommandedGait, wave_positions
from quadruped_env.robot import JOINT_NAMES, JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE
from quadruped_env.simulation import Simulation
from quadruped_env.task import commands, observations, randomization, rewards, terminations
from quadruped_env.task.arrays import MINUS_ONE, ONE, any_of
from quadruped_env.task.config import TaskConfig

ACTION_WIDTH: Final = len(JOINT_NAMES)

_TURN: Final = np.array(math.tau)
_LEG_PHASES: Final = JOINT_PHASES[::2]
_EPISODE_ARRAYS: Final = (
    "_last_action",
    "_smooth_velocity",
    "_command",
    "_moving",
    "_progress_scale",
    "_progress_whole",
    "_fixed",
    "_phase",
    "_steps",
    "_started",
    "_finished",
    "_resample_at",
    "_push_at",
    "_noise_key",
    "_gait_sine",
    "_gait_cosine",
    "_gait_offset",
)


@dataclass(slots=True)
class Transition:
    """What one control step gave, before any reset."""

    observation: NDArray[np.float32]
    """(N, OBSERVATION_WIDTH)"""
    reward: NDArray[np.float64]
    """(N,): the weighted terms, added in their order"""
    terms: NDArray[np.float64]
    """Weighted reward terms (N, T), in the order of `Task.term_names`"""
    terminated: NDArray[np.bool_]
    """(N,): fallen or diverged"""
    truncated: NDArray[np.bool_]
    """(N,): out of time"""
    diverged: NDArray[np.bool_]
    """(N,): MuJoCo gave up on the row"""


class Task:
    """The episodes of N rows.

    Args:
        simulation: N robots.
        config: the task in numbers.
        max_episode_steps: control steps after which an episode is truncated; None leaves that to the caller.
    """

    def __init__(self, simulation: Simulation, config: TaskConfig, max_episode_steps: int | None = None) -> None:
        if max_episode_steps is not None:
            max_episode_steps = whole_number("max_episode_steps", max_episode_steps, 1, or_none=True)
        self.simulation = simulation
        self.config = config
        self.max_episode_steps = max_episode_steps
        n = self.num_rows = simulation.num_rows
        self._residual = config.action.mode == "residual"
        self._action_scale = np.array(config.action.residual_scale if self._residual else config.action.position_scale)
        self._phase_step = np.array(math.tau * config.clock_frequency * config.control_timestep)
        self._smoothing = np.array(1.0 - math.exp(-config.control_timestep / config.reward.velocity_time_constant))
        self._noise = config.randomization.observation_noise * observations.OBSERVATION_NOISE
        self._pushes = config.randomization.push_velocity > 0.0
        self._weights = np.array(list(config.reward.weights.values()))[:, None] * config.control_timestep
        self.term_names = tuple(config.reward.weights)
        self.reward_keys = tuple(f"reward_{name}" for name in self.term_names)
        self._model_randomizer = randomization.ModelRandomizer(simulation, config.randomization)
        self._gait = CommandedGait.tuned()

        seeded = [seeding.np_random() for _ in range(n)]
        self.generators: list[np.random.Generator] = [generator for generator, _ in seeded]
        self.seeds: list[int] = [seed for _, seed in seeded]
        """Each row's seed; -1 for a generator that came from elsewhere, as Gymnasium has it"""
        self._last_action = np.zeros((n, ACTION_WIDTH))
        self._command = np.zeros((n, 2))
        self._smooth_velocity = np.zeros((n, 2))
        self._moving = np.zeros(n)
        self._progress_scale = np.zeros((n, 2))
        self._progress_whole = np.zeros((n, 2))
        self._fixed = np.zeros(n, dtype=np.bool_)
        self._phase = np.zeros(n)
        self._steps = np.zeros(n, dtype=np.int64)
        self._started = np.zeros(n, dtype=np.bool_)
        self._finished = np.zeros(n, dtype=np.bool_)
        self._all_started = False
        self._resample_at = np.zeros(n, dtype=np.int64)
        self._push_at = np.zeros(n, dtype=np.int64)
        self._noise_key = np.zeros(n, dtype=np.uint64)
        self._gait_sine = np.zeros((n, ACTION_WIDTH))
        self._gait_cosine = np.zeros((n, ACTION_WIDTH))
        self._gait_offset = np.tile(STANCE, (n, 1))
        self._velocity = np.zeros((n, 2))
        self._clock = np.zeros((n, 2))
        self._raw = np.zeros((n, observations.OBSERVATION_WIDTH))

    @property
    def command(self) -> NDArray[np.float64]:
        """Commanded forward velocity (m/s) and yaw rate (rad/s), (N, 2); live."""
        return self._command

    @property
    def smooth_velocity(self) -> NDArray[np.float64]:
        """Forward velocity (m/s) and yaw rate (rad/s) averaged over about a gait cycle, (N, 2); live."""
        return self._smooth_velocity

    @property
    def phase(self) -> NDArray[np.float64]:
        """Phase of the gait clock in [0, 2 pi), (N,); live."""
        return self._phase

    @property
    def steps(self) -> NDArray[np.int64]:
        """Control steps since each row's reset, (N,); live."""
        return self._steps

    @property
    def finished(self) -> NDArray[np.bool_]:
        """Rows (N,) whose episode has ended and that have not been reset since; live."""
        return self._finished

    def reset(
        self,
        rows: NDArray[np.intp],
        seeds: Sequence[int | None] | None = None,
        command: Sequence[float] | NDArray[np.float64] | None = None,
    ) -> None:
        """Begin new episodes in some rows (R,); the others do not change.

        Args:
            rows: which rows.
            seeds: seeds of the rows' generators (R,); None lets a generator run on.
            command: forward velocity and yaw rate that stay fixed for the episode; None samples them.

        Raises:
            QuadrupedError: if the command is not one of the task's; no row has changed then.
        """
        if command is not None:
            command = commands.check_command(command, self.config.command)
        if seeds is not None:
            for row, seed in zip(rows, seeds, strict=True):
                if seed is not None:
                    self.generators[row], self.seeds[row] = seeding.np_random(seed)
        config = self.config.randomization
        # One call a row for all that an episode draws.
        count = randomization.START_DRAWS + commands.DRAWS + 3
        draws = np.array([self.generators[row].random(count) for row in rows])
        start, draws = draws[:, : randomization.START_DRAWS], draws[:, randomization.START_DRAWS :]
        qpos, qvel = randomization.start_states(start, config)
        self._model_randomizer.apply(rows, start)
        self.simulation.reset(rows, qpos, qvel)

        self._last_action[rows] = 0.0
        self._smooth_velocity[rows] = 0.0
        self._steps[rows] = 0
        self._started[rows] = True
        self._finished[rows] = False
        self._phase[rows] = math.tau * draws[:, commands.DRAWS]
        self._noise_key[rows] = (draws[:, commands.DRAWS + 1] * 2.0**53).astype(np.uint64)
        self._push_at[rows] = self._in_steps(commands.between(config.push_interval, draws[:, commands.DRAWS + 2]))
        self._fixed[rows] = command is not None
        if command is None:
            self._set_sampled_command(rows, draws[:, : commands.DRAWS])
        else:
            self._set_command(rows, np.broadcast_to(command, (len(rows), 2)))

    def set_command(self, rows: NDArray[np.intp], command: Sequence[float] | NDArray[np.float64]) -> None:
        """Give some rows (R,) another command within their episodes, which stays fixed from then on.

        Raises:
            QuadrupedError: if the command is not one of the task's; no row has changed then.
        """
        command = commands.check_command(command, self.config.command)
        self._fixed[rows] = True
        self._set_command(rows, np.broadcast_to(command, (len(rows), 2)))

    def step(self, action: ArrayLike, restart: NDArray[np.bool_] | None = None) -> Transition:
        """Advance every row by one control step. Resets nothing but `restart`.

        Args:
            action: (N, 8), clipped to [-1, 1].
            restart: rows (N,) that begin a new episode in place of this step, whatever their action: their
                observation is the new episode's first, their reward is zero. None restarts none.

        Raises:
            QuadrupedError: if a row was never reset, the action's shape is wrong or a value is not finite; no row has
                moved then.
        """
        action = self._checked(action, "action", restart)
        np.minimum(action, ONE, out=action)
        np.maximum(action, MINUS_ONE, out=action)
        self._advance_phase()
        return self._advance(action, self._nominal() + action * self._action_scale, restart)

    def step_joint_target(self, target: ArrayLike) -> Transition:
        """Advance every row by one control step with joint targets (N, 8) in rad: what a scripted controller does.

        The policy's last action counts as zero.

        Raises:
            QuadrupedError: as `step`.
        """
        target = self._checked(target, "joint target")
        self._advance_phase()
        return self._advance(np.zeros_like(target), target)

    def _advance_phase(self) -> None:
        self._phase += self._phase_step
        np.remainder(self._phase, _TURN, out=self._phase)

    def _advance(
        self, action: NDArray[np.float64], target: NDArray[np.float64], restart: NDArray[np.bool_] | None = None
    ) -> Transition:
        np.minimum(target, JOINT_POSITION_HIGH, out=target)
        np.maximum(target, JOINT_POSITION_LOW, out=target)
        self.simulation.step(target, self.config.decimation, None if restart is None else np.flatnonzero(~restart))
        self._steps += 1

        state, config = self.simulation.state, self.config
        diverged = self.simulation.diverged()
        terminated = (
            terminations.tilted(state.up_b, config.termination.max_tilt)
            | terminations.trunk_contact(state.trunk_force, config.termination.max_trunk_force)
            | diverged
        )
        if self.max_episode_steps is None:
            truncated = np.zeros(self.num_rows, dtype=np.bool_)
        else:
            truncated = self._steps >= self.max_episode_steps
        terms = self._reward_terms(action, terminated)
        # Added one by one in declared order: a pairwise sum would depend on the shape of the array.
        reward = np.add.accumulate(terms, axis=0)[-1]

        self._last_action[:] = action
        self._resample_commands(restart)
        if self._pushes:
            self._push(restart)
        if restart is not None:
            self.reset(np.flatnonzero(restart))
            terms[:, restart] = 0.0
            reward[restart] = 0.0
            for flags in (terminated, truncated, diverged):
                flags[restart] = False
        self._finished[:] = terminated
        if self.max_episode_steps is not None:
            self._finished |= truncated
        return Transition(self.observe(), reward, terms.T, terminated, truncated, diverged)

    def observe(self) -> NDArray[np.float32]:
        """The observations (N, OBSERVATION_WIDTH) of all rows, a new array."""
        np.sin(self._phase, out=self._clock[:, 0])
        np.cos(self._phase, out=self._clock[:, 1])
        self._clock *= self._moving[:, None]
        observations.raw_observation(self.simulation.state, self._last_action, self._command, self._clock, self._raw)
        if self.config.randomization.observation_noise:
            noise = randomization.counter_noise(self._noise_key, self._steps, observations.OBSERVATION_WIDTH)
            self._raw += noise * self._noise
        return observations.scale_observation(self._raw)

    def get_state(self, row: int) -> dict[str, Any]:
        """All that the future of a row depends on: physics, episode, noise and random generator."""
        state: dict[str, Any] = {name: copy.copy(getattr(self, name)[row]) for name in _EPISODE_ARRAYS}
        state["generator"], state["seed"] = self.generators[row].bit_generator.state, self.seeds[row]
        state["simulation"] = self.simulation.get_state(row)
        return state

    def set_state(self, row: int, state: dict[str, Any]) -> None:
        """Restore what `get_state` gave: the row then goes on as it did from there."""
        for name in _EPISODE_ARRAYS:
            getattr(self, name)[row] = state[name]
        self.generators[row].bit_generator.state = state["generator"]
        self.seeds[row] = state["seed"]
        self.simulation.set_state(row, state["simulation"])

    def _checked(self, action: ArrayLike, what: str, restart: NDArray[np.bool_] | None = None) -> NDArray[np.float64]:
        if not self._all_started:
            if not self._started.all():
                raise QuadrupedError(
                    f"step: call reset() first; env {np.argmin(self._started)} of {self.num_rows} has no episode yet"
                )
            self._all_started = True
        values = np.array(action, dtype=np.float64)
        if values.shape != self._last_action.shape:
            raise QuadrupedError(
                f"{what}: expected shape {self._last_action.shape}, one value a joint; found {values.shape}"
            )
        if restart is not None:
            values[restart] = 0.0
        if np.count_nonzero(np.isfinite(values)) != values.size:
            row, column = np.argwhere(~np.isfinite(values))[0]
            raise QuadrupedError(
                f"{what}: value {values[row, column]} for {JOINT_NAMES[column]} in row {row} is not finite"
            )
        return values

    def _nominal(self) -> NDArray[np.float64]:
        """Joint positions that a zero action asks for, rad: (8,), or (N, 8) in residual mode."""
        if not self._residual:
            return STANCE
        return wave_positions(self._phase, self._gait_sine, self._gait_cosine, self._gait_offset)

    def _reward_terms(self, action: NDArray[np.float64], terminated: NDArray[np.bool_]) -> NDArray[np.float64]:
        """Weighted terms (T, N), in declared order; updates what they remember."""
        state = self.simulation.state
        self._velocity[:, 0] = state.linear_velocity_b[:, 0]
        self._velocity[:, 1] = state.angular_velocity_b[:, 2]
        self._smooth_velocity += self._smoothing * (self._velocity - self._smooth_velocity)
        memory = rewards.Memory(
            action=action,
            last_action=self._last_action,
            joint_offset=state.joint_position - STANCE,
            command=self._command,
            progress_scale=self._progress_scale,
            progress_whole=self._progress_whole,
            velocity=self._velocity,
            smooth_velocity=self._smooth_velocity,
            moving=self._moving,
            clock_sine=np.sin(self._phase[:, None] + _LEG_PHASES),
            fallen=terminated.astype(np.float64),
        )
        terms = rewards.reward_terms(state, memory, self.config.reward)
        # One concatenation is cheaper than a write a term.
        stacked = np.concatenate([terms[name] for name in self.term_names]).reshape(-1, self.num_rows)
        stacked *= self._weights
        return stacked

    def _resample_commands(self, restart: NDArray[np.bool_] | None) -> None:
        due = self._steps >= self._resample_at
        if np.count_nonzero(due):
            due &= ~self._fixed
            rows = np.flatnonzero(due if restart is None else due & ~restart)
            if len(rows):
                draws = np.array([self.generators[row].random(commands.DRAWS) for row in rows])
                self._set_sampled_command(rows, draws)

    def _set_sampled_command(self, rows: NDArray[np.intp], draws: NDArray[np.float64]) -> None:
        command, interval = commands.sample_command(draws, self.config.command)
        self._resample_at[rows] = self._steps[rows] + self._in_steps(interval)
        self._set_command(rows, command)

    def _set_command(self, rows: NDArray[np.intp], command: NDArray[np.float64]) -> None:
        self._command[rows] = command
        self._moving[rows] = any_of(np.abs(command) > commands.MOVING_THRESHOLD)
        self._progress_scale[rows], self._progress_whole[rows] = rewards.progress_scale(command)
        if self._residual:
            self._gait_sine[rows], self._gait_cosine[rows], self._gait_offset[rows] = self._gait.waves(command)

    def _push(self, restart: NDArray[np.bool_] | None) -> None:
        due = self._steps >= self._push_at
        rows = np.flatnonzero(due if restart is None else due & ~restart)
        if len(rows):
            config = self.config.randomization
            draws = np.array([self.generators[row].random(3) for row in rows])
            velocity = np.zeros((len(rows), 3))
            velocity[:, :2] = commands.between((-config.push_velocity, config.push_velocity), draws[:, :2])
            self._push_at[rows] += self._in_steps(commands.between(config.push_interval, draws[:, 2]))
            self.simulation.push(rows, velocity)

    def _in_steps(self, seconds: NDArray[np.float64]) -> NDArray[np.int64]:
        return np.maximum(np.rint(seconds / self.config.control_timestep), ONE).astype(np.int64)
