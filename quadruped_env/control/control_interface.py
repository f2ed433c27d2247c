"""Interface between a policy and the joints, identical in training, in evaluation and on a real robot."""

import math
from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.control.observations import OBSERVATIONS, ObservationField, ObservationLayout
from quadruped_env.control.velocity_command import moving_threshold
from quadruped_env.gait import joint_phases, leg_phases, wave_positions
from quadruped_env.robot.readings import Readings
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats


class ControlInterface:
    """Gait clock, command, actions and observations of N robots.

    In each control step, call `advance()`, then `joint_target(action)` if a policy acts. Then the robot moves. Then
    `approach_requested()` changes the command, and `observe(readings)` returns the next observation. The values of an
    env do not depend on N: see the rules in CONTRIBUTING.md.
    """

    def __init__(
        self,
        robot: Robot,
        config: ControlConfig,
        num_envs: int = 1,
        fields: Sequence[ObservationField] = OBSERVATIONS,
    ) -> None:
        self.robot = robot
        self.config = config
        self.num_envs = num_envs
        self.layout = ObservationLayout(robot, tuple(fields), config.observation_history)
        self.memory = memory = EpisodeMemory(num_envs)
        self.action: Floats = memory.zeros("action", robot.num_joints)
        """Latest action in [-1, 1], (N, J); zero for controllers without actions."""
        self.previous_action: Floats = memory.zeros("previous_action", robot.num_joints)
        """Action of the step before, (N, J)."""
        self.commands: Floats = memory.zeros("commands", max(len(config.commands), config.num_velocities))
        """All components of the command, in the order of `config.commands`, (N, C)."""
        self.command = self.commands[:, : config.num_velocities]
        """Commanded forward velocity (m/s), yaw rate (rad/s) and any lateral velocity (m/s), (N, V); a view."""
        self.requested: Floats = memory.zeros("requested", config.num_velocities)
        """Requested velocities, which `command` approaches at a limited rate, (N, V)."""
        self.moving: Floats = memory.zeros("moving")
        """1.0 where a motion is commanded, else 0.0, (N,)."""
        self.phase: Floats = memory.zeros("phase")
        """Phase of the gait clock in [0, 2 pi), (N,), rad."""
        self._phase_step = math.tau * config.clock_frequency * config.timestep
        """Advance of the gait clock per control step, rad."""
        self.steps: NDArray[np.int64] = memory.zeros("steps", dtype=np.int64)
        """Number of control steps since the reset, (N,)."""
        self._sine: Floats = memory.zeros("gait_sine", robot.num_joints)
        self._cosine: Floats = memory.zeros("gait_cosine", robot.num_joints)
        self._offset: Floats = memory.zeros("gait_offset", robot.num_joints)
        depth = config.observation_history
        past = (depth, self.layout.width) if depth > 1 else (0, 0)
        self._past: NDArray[np.float32] = memory.zeros("observations", *past, dtype=np.float32)
        """The latest observations, the latest first (N, depth, width)."""
        self._observed_step: NDArray[np.int64] = memory.zeros("observed_step", dtype=np.int64)
        """Control step of the latest observation, (N,)."""
        self._columns = {entry.name: i for i, entry in enumerate(config.commands)}
        self._largest_change = config.timestep * np.array(config.command_rate)
        self._gait, self._scale = config.action.scripted_gait(robot, config.clock_frequency), config.action.scale
        self._joint_phases = joint_phases(robot)
        self._leg_phases = leg_phases(robot)
        self._moving_threshold = moving_threshold(robot)
        self.stance: Floats = robot.stance[None]
        """Joint positions of the stance (1, J), rad."""
        self._observation_low, self._observation_high = (
            bound.astype(np.float32) for bound in (self.layout.low, self.layout.high)
        )
        self._clock: Floats = np.zeros((num_envs, 2))
        self.reset(np.arange(num_envs))

    def reset(self, env_ids: NDArray[np.intp], phase: Floats | float = 0.0, command: Floats | None = None) -> None:
        """Reset some envs (R,): zero actions, the gait clock at a phase (R,) in rad, commands (R, C); None: zero.

        The velocities of the command hold at once.
        """
        self.memory.clear(env_ids)
        self.phase[env_ids] = phase
        if command is None:
            command = np.zeros((len(env_ids), self.config.num_velocities))
        self.set_command(env_ids, command)
        # Also for zero: the scripted gait follows the command.
        self._set_velocity(env_ids, command[:, : self.config.num_velocities])

    def set_command(self, env_ids: NDArray[np.intp], command: Floats) -> None:
        """Set the commands (R, C) of some envs (R,); with (R, V), only the velocities change.

        The velocities approach the requested ones at the rate of `ControlConfig.command_rate`, as `approach_requested`
        is called.
        """
        velocities = self.config.num_velocities
        self.requested[env_ids] = command[:, :velocities]
        self.commands[env_ids, velocities : command.shape[1]] = command[:, velocities:]

    def approach_requested(self) -> None:
        """Change the velocity commands towards the requested ones, by at most what a control step allows.

        Before an observation, so that it has the command that the scripted gait follows in the step after it.
        """
        missing = self.requested - self.command
        if not np.count_nonzero(missing):
            return
        near = np.abs(missing) <= self._largest_change
        velocity = np.where(near, self.requested, self.command + np.copysign(self._largest_change, missing))
        env_ids = np.flatnonzero((missing != 0.0).any(axis=1))
        self._set_velocity(env_ids, velocity[env_ids])

    def _set_velocity(self, env_ids: NDArray[np.intp], velocity: Floats) -> None:
        """Set the velocity commands (R, V) of some envs (R,) at once."""
        self.command[env_ids] = velocity
        self.moving[env_ids] = (np.abs(velocity) > self._moving_threshold).any(axis=1)
        if self._gait is not None:
            self._sine[env_ids], self._cosine[env_ids], self._offset[env_ids] = self._gait.waves(velocity)

    def command_of(self, name: str) -> Floats:
        """One component of the command by name, (N,)."""
        return self.commands[:, self._columns[name]]

    @property
    def time(self) -> Floats:
        """Time since the reset at which the current control step began, (N,), s."""
        return np.maximum(self.steps - 1, 0) * self.config.timestep

    def advance(self) -> None:
        """Begin a control step: advance the clock, and set the action to zero."""
        self.steps += 1
        np.remainder(self.phase + self._phase_step, math.tau, out=self.phase)
        self.previous_action[:] = self.action
        self.action.fill(0.0)

    def joint_target(self, action: NDArray[np.floating]) -> Floats:
        """Joint targets (N, J) in rad for actions (N, J), which are clipped to [-1, 1]."""
        np.minimum(action, 1.0, out=self.action)
        np.maximum(self.action, -1.0, out=self.action)
        return self.within_limits(self._scale * self.action + self.nominal())

    def within_limits(self, target: Floats) -> Floats:
        """Joint targets (N, J) in rad, clipped in place to the joints' ranges."""
        np.minimum(target, self.robot.joint_position_high, out=target)
        return np.maximum(target, self.robot.joint_position_low, out=target)

    def nominal(self) -> Floats:
        """Joint positions for a zero action, in rad: the stance (1, J), or the scripted gait (N, J)."""
        if self._gait is None:
            return self.stance
        return wave_positions(self.phase, self._joint_phases, self._sine, self._cosine, self._offset)

    def leg_clock(self, lag: Floats | float = 0.0) -> Floats:
        """Sine of each leg's phase, (N, L); positive while the foot should swing. The clock lags by (N, 1) rad."""
        return np.sin(self.phase[:, None] + self._leg_phases - lag)

    @property
    def clock(self) -> Floats:
        """Sine and cosine of the phase, 0 where standing is commanded, (N, 2)."""
        np.sin(self.phase, self._clock[:, 0])
        np.cos(self.phase, self._clock[:, 1])
        return self._clock * self.moving[:, None]

    def observe(self, readings: Readings, noise: Floats | None = None) -> NDArray[np.float32]:
        """Observations (N, layout.history * layout.width) in a new array: of this step, then of the steps before.

        Before an episode's first step there is none, so its first observation stands for them. A second call in the
        same step replaces the observation of the first. Noise (N, layout.width) is added to the unscaled readings.
        """
        layout = self.layout
        raw = np.concatenate([field.read(readings, self) for field in layout.fields], axis=1)
        if noise is not None:
            raw += noise
        raw *= layout.scale
        present = raw.astype(np.float32)
        np.minimum(present, self._observation_high, out=present)
        np.maximum(present, self._observation_low, out=present)
        return present if layout.history == 1 else self._stacked(present)

    def _stacked(self, present: NDArray[np.float32]) -> NDArray[np.float32]:
        """The present observations (N, width) and the steps before, stacked (N, history * width)."""
        past, steps = self._past, self.steps
        advanced = steps != self._observed_step
        if np.count_nonzero(advanced) == len(steps):
            past[:, 1:] = past[:, :-1]
        else:
            past[advanced, 1:] = past[advanced, :-1]
        past[:, 0] = present
        if np.count_nonzero(steps) < len(steps):
            first = steps == 0
            past[first] = present[first, None]
        self._observed_step[:] = steps
        return past.reshape(len(steps), -1).copy()


class Controller(Protocol):
    """Computes joint targets from observations; it does not send them to a robot."""

    name: str
    action_mode: str
    """Action mode that the task must have."""
    follows_command: bool
    """False if the velocity command has no effect."""

    def act(self, observation: NDArray[np.float32], control: ControlInterface) -> Floats:
        """Joint targets (N, J) in rad for the observations (N, width); `control` is already advanced to this step."""
        ...
