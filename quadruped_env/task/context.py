"""Input of reward terms and terminations."""

import math
from dataclasses import fields
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.robot.motors import MotorConfig
from quadruped_env.robot.readings import Readings
from quadruped_env.robot.units import scale_of
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.task import quantities
from quadruped_env.utils.arrays import EnvIds, Floats

_SMALLEST_COMMAND: Final = np.array([0.1, 0.2, 0.1])
_STEADY_TIME_CONSTANT: Final = 2.0
"""Time constant of `steady_error` for the built-in robot, s: several strides, so that only what persists counts."""
_LOOK_AHEAD: Final = (0.04, 0.08, 0.12)
"""Times at which the built-in robot's feet look ahead, s: up to three quarters of a swing."""


class TaskContext:
    """Readings, actions, commands and episode memory of N envs after a control step.

    A term must read from the context that it is called with and keep no reference to its arrays: they are overwritten
    or replaced at every step.

    The time constant of `smooth_velocity` is in s. Without a height field the ground is a plane at height 0; without
    motors the robot has its own.
    """

    joint_offset: Floats
    """Joint positions relative to the stance (N, J), rad."""
    foot_contact: NDArray[np.bool_]
    """True for each foot on the ground, (N, L)."""
    contact: Floats
    """1.0 for each foot on the ground, else 0.0, (N, L)."""
    base_height: Floats
    """Height of the base's centre over the ground below it (N,), m."""
    sole_height: Floats
    """Height of each foot's lowest point over the ground below it (N, L), m."""
    leg_clock: Floats
    """Sine of each leg's phase, (N, L); positive while the foot should swing. It lags by the latency of the actions:
    the motion follows a clock that the robot saw that much earlier."""
    substeps: Readings
    """Readings at the beginning of each physics step of the latest control step, (S, N, ...); before the first one, the
    present readings."""

    def __init__(
        self,
        readings: Readings,
        control: ControlInterface,
        velocity_time_constant: float,
        contact_threshold: float,
        height_field: HeightField | None = None,
        motors: MotorConfig | None = None,
    ) -> None:
        n = control.num_envs
        self.robot = control.robot
        self.motors = motors or control.robot.motors
        """Motors of the simulation, without randomization."""
        self.memory = EpisodeMemory(n)
        """Arrays of the terms: zero after a reset, and saved with the env."""
        self.timestep = control.config.timestep
        """Time between actions, s."""
        self.velocity: Floats = np.zeros(control.command.shape)
        """Velocities of the base in its own frame in the order of the command, (N, V)."""
        self.smooth_velocity: Floats = self.memory.zeros("smooth_velocity", control.config.num_velocities)
        """Average of `velocity` over about one gait cycle, (N, V)."""
        self.tracking_error: Floats = np.zeros(control.command.shape)
        """`smooth_velocity` minus the command in force during the step, (N, V)."""
        self.steady_error: Floats = self.memory.zeros("steady_error", control.config.num_velocities)
        """Average of `velocity` minus the command over about two seconds, (N, V)."""
        self.fallen: Floats = np.zeros(n)
        """1.0 where the episode ends in a fall in this step, else 0.0, (N,)."""
        self.landing_speed: Floats = np.zeros((n, self.robot.num_legs))
        """Downward speed at which each foot has touched down in this control step, else 0, (N, L), m/s."""
        self.slip: Floats = np.zeros((n, self.robot.num_legs))
        """Squared sliding speed of each sole while it is on the ground, mean over the step, (N, L), m^2/s^2."""
        self._clock_lag: Floats = self.memory.zeros("clock_lag", 1)
        self._airborne: Floats = self.memory.zeros("airborne", self.robot.num_legs)
        self.contact_threshold = contact_threshold
        """Normal force above which a foot is in contact, N."""
        units = np.array([scale_of(entry.unit, self.robot) for entry in velocity_commands(self.robot)])
        self.smallest_command = _SMALLEST_COMMAND[: len(units)] * units
        """Command below which progress is reduced in proportion (V,), m/s, rad/s and m/s."""
        self._height_field = height_field
        self._smoothing = 1.0 - math.exp(-self.timestep / velocity_time_constant)
        time_scale = scale_of("s", self.robot)
        self._slow_smoothing = 1.0 - math.exp(-self.timestep / (_STEADY_TIME_CONSTANT * time_scale))
        self._look_ahead = tuple(time_scale * seconds for seconds in _LOOK_AHEAD)
        self.readings = readings
        """Readings of the simulation; see `Readings`."""
        self.control = control
        self.action = control.action
        """Latest action in [-1, 1], (N, J)."""
        self.previous_action = control.previous_action
        """Action of the step before, (N, J)."""
        self.command = control.command
        """Commanded velocities (N, V); see `ControlInterface.command`."""
        self.moving = control.moving
        """1.0 where a motion is commanded, else 0.0, (N,)."""
        self.substeps = Readings(**{field.name: getattr(readings, field.name)[None] for field in fields(Readings)})
        self.read()

    def begin_episodes(self, env_ids: EnvIds, latency: Floats) -> None:
        """Clear the memory of some envs (R,), and compute everything; the latency of the actions (R, J) is in s."""
        self.memory.clear(env_ids)
        lag = math.tau * self.control.config.clock_frequency * np.add.reduce(latency, axis=-1) / latency.shape[-1]
        self._clock_lag[env_ids, 0] = lag
        self.read()

    def update(self, substeps: Readings) -> None:
        """Update everything after a control step, whose readings at the physics' rate are given."""
        self.substeps = substeps
        self._contacts()
        self.velocity[:, 0] = self.readings.linear_velocity_b[:, 0]
        self.velocity[:, 1] = self.readings.angular_velocity_b[:, 2]
        if self.velocity.shape[1] > 2:
            self.velocity[:, 2] = self.readings.linear_velocity_b[:, 1]
        self.smooth_velocity += self._smoothing * (self.velocity - self.smooth_velocity)
        np.subtract(self.smooth_velocity, self.command, out=self.tracking_error)
        self.steady_error += self._slow_smoothing * (self.velocity - self.command - self.steady_error)
        self.read()

    def read(self) -> None:
        """Compute contacts, heights, joint offsets and leg clock from the readings and the phase, as after a reset."""
        readings = self.readings
        self.joint_offset = readings.joint_position - self.control.stance
        self.foot_contact = readings.foot_force > self.contact_threshold
        self.contact = self.foot_contact.astype(np.float64)
        self.base_height = readings.base_position[:, 2]
        self.sole_height = readings.foot_position[..., 2] - self.robot.foot_radius
        if self._height_field is not None:
            self.base_height = self.base_height - self._height_field.at(readings.base_position)
            self.sole_height = self.sole_height - self._height_field.at(readings.foot_position)
        self.leg_clock = self.control.leg_clock(self._clock_lag)

    def _contacts(self) -> None:
        """Compute landings and slip from the readings of each physics step."""
        substeps = self.substeps
        on_ground = (substeps.foot_force > self.contact_threshold).astype(np.float64)
        sliding = on_ground * quantities.sliding_squared(
            substeps.foot_velocity, substeps.foot_angular_velocity, self.robot.foot_radius
        )
        down = np.maximum(-substeps.foot_velocity[..., 2], 0.0)
        airborne = np.concatenate([self._airborne[None], 1.0 - on_ground])
        np.maximum.reduce(airborne[:-1] * on_ground * down, axis=0, out=self.landing_speed)
        self.slip[:] = quantities.mean_over_steps(sliding)
        self._airborne[:] = airborne[-1]

    def ground_height(self, positions: Floats) -> Floats:
        """Return the height of the ground (N, ...) at positions (N, ..., 2 or 3) in the world frame, m."""
        if self._height_field is None:
            return np.zeros_like(positions[..., 0])
        return self._height_field.at(positions)

    def rise_ahead(self) -> Floats:
        """Return how far the ground on each foot's way rises over the ground below it (N, L), m; 0 on a plane.

        The way is straight on, at the foot's present velocity.
        """
        if self._height_field is None:
            return np.zeros_like(self.sole_height)
        place, velocity = self.readings.foot_position[..., :2], self.readings.foot_velocity[..., :2]
        below = top = self._height_field.at(place)
        for seconds in self._look_ahead:
            top = np.maximum(top, self._height_field.at(place + seconds * velocity))
        return top - below

    def command_of(self, name: str) -> Floats:
        """Return one component of the command by name, (N,)."""
        return self.control.command_of(name)
