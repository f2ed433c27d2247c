"""Random quantities of episodes: their starts, model parameters, commands, pushes and sensor noise."""

import math
from collections.abc import Iterable, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.robot.motors import SERVO_ERRORS, MotorConfig
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.simulation import Simulation, highest_ground
from quadruped_env.task.command_sampling import CommandSampler
from quadruped_env.task.randomization.draws import Draws, Purposes
from quadruped_env.task.randomization.model_fields import check_physical
from quadruped_env.task.randomization.randomization import (
    Active,
    Event,
    Randomization,
    RandomizationSection,
    SensorError,
    between,
    ends_of,
    in_steps,
)
from quadruped_env.task.randomization.sensor_errors import Quantity, Sensors
from quadruped_env.task.randomization.servo_errors import ServoErrors
from quadruped_env.utils import rotations
from quadruped_env.utils.arrays import Bools, EnvIds, Floats
from quadruped_env.utils.fields import Range

Steps = NDArray[np.int64]
Settings = Sequence[tuple[Randomization, Range | float]]
"""Randomizations that are enabled, with their settings."""

_CLEARANCE: Final = 0.01
"""Height of the built-in robot's stance above the ground below it at the start, so that randomized legs do not
penetrate it, m."""
_NO_STATE: Final = np.zeros((0, 0))


class _Recurring:
    """A randomization that repeats within the episodes of N envs, such as pushes."""

    def __init__(self, active: Active, section: RandomizationSection, robot: Robot, memory: EpisodeMemory) -> None:
        randomization, name = active.randomization, active.name
        times = randomization.interval, randomization.duration
        interval, duration = ("" if field is None else field[0] for field in times)
        self.active = active
        self.interval: Range = section[interval]
        """Time between two applications, s."""
        self.duration: Range | None = section[duration] if duration else None
        """Time after which zeros are applied, s; None: what was applied lasts."""
        widths = {name: randomization.columns(robot), f"{name}/interval": 1}
        self.purposes = Purposes(widths | ({f"{name}/duration": 1} if duration else {}))
        self.due: Steps = memory.zeros(f"{name}_due", dtype=np.int64)
        """Control step at which it applies next, (N,)."""
        self.until: Steps = memory.zeros(f"{name}_until", dtype=np.int64)
        """Control step at which what was applied ends; 0 if nothing lasts, (N,)."""


class Randomizer:
    """Applies the randomizations of a task, and samples its commands and observation noise.

    `section` has the settings of the randomizations, and `motors` are those without randomization.
    """

    def __init__(
        self,
        simulation: Simulation,
        control: ControlInterface,
        draws: Draws,
        randomizations: Iterable[Randomization],
        section: RandomizationSection,
        commands: CommandSampler,
        motors: MotorConfig,
    ) -> None:
        self._simulation, self._control, self._draws = simulation, control, draws
        self._timestep = control.config.timestep
        active = section.active(randomizations)
        starting = [(entry, setting) for entry, setting in active if entry.interval is None]
        self.sensors = _sensors(simulation, self._timestep, active)
        """Errors of the sensors; None if they have none."""
        self.servos = _servos(simulation, motors, active)
        """Errors of the servos; None if they have none."""
        check_physical(starting, simulation)
        self.memory = EpisodeMemory(control.num_envs)
        self.command_due: Steps = self.memory.zeros("command_due", dtype=np.int64)
        """Control step of the episode at which the next command is drawn, (N,)."""
        self.commands = commands
        self._starting = [Active.of(entry, setting, simulation) for entry, setting in starting]
        self._recurring = [
            _Recurring(Active.of(entry, setting, simulation), section, simulation.robot, self.memory)
            for entry, setting in active
            if entry.interval is not None
        ]
        robot = simulation.robot
        self._start_draws = Purposes(
            {
                **{entry.name: entry.randomization.columns(robot) for entry in self._starting},
                "phase": 1,
                **{f"{entry.active.name}/interval": 1 for entry in self._recurring},
                **commands.purposes.widths,
            }
        )
        moved = any(entry.name in ("start_joint_position", "start_tilt") for entry, _ in starting)
        self._start_height = robot.stance_height + (_CLEARANCE * scale_of("m", robot) if moved else 0.0)
        amplitudes, layout = section.noise_amplitude, control.layout
        amplitude = np.zeros(layout.width)
        for name, columns in layout.slices.items():
            amplitude[columns] = amplitudes[name]
        self._noisy = np.flatnonzero(amplitude)
        self._noise_amplitude = section.observation_noise * amplitude[self._noisy]
        # A draw is a hash of its column, so that leaving some out does not change the others.
        self._noise = Purposes({"observation_noise": layout.width})
        self._noise.constants = self._noise.constants[self._noisy]
        self._noise_values = np.zeros((control.num_envs, layout.width))

    def begin_episodes(self, env_ids: EnvIds, place: Floats | None = None, command: Floats | None = None) -> None:
        """Set some envs (R,) to random initial states, at places (R, 2) in m, or else at the origin.

        Without commands (R, C) these are random.
        """
        simulation, sensors = self._simulation, self.sensors
        simulation.restore_model_fields(env_ids)
        if sensors is not None:
            sensors.memory.clear(env_ids)
        if self.servos is not None:
            self.servos.clear(env_ids)
        draws = self._draws.uniform(self._start_draws, env_ids, np.zeros_like(env_ids))
        columns = self._start_draws.slices
        event = self._start(env_ids, place)
        for entry in self._starting:
            entry.draw(event, draws[:, columns[entry.name]])
        event.qpos[:, 2] += highest_ground(simulation, event.qpos[:, :2])
        event.qpos[:, 3:7] = rotations.from_roll_pitch_yaw(event.tilt)
        if sensors is not None:
            sensors.before_start(env_ids)
        simulation.reset(env_ids, event.qpos, event.qvel)
        if sensors is not None:
            sensors.after_start(env_ids)
        self.start_servos(env_ids)
        self.memory.clear(env_ids)
        for recurring in self._recurring:
            wait = between(recurring.interval, draws[:, columns[f"{recurring.active.name}/interval"].start])
            recurring.due[env_ids] = in_steps(wait, self._timestep)
        of_command = slice(columns["command/kind"].start, columns["command/interval"].stop)
        drawn, until_next = self.commands.sample(draws[:, of_command])
        self.command_due[env_ids] = in_steps(until_next, self._timestep)
        phase = math.tau * draws[:, columns["phase"].start]
        self._control.reset(env_ids, phase, drawn if command is None else command)

    def _start(self, env_ids: EnvIds, place: Floats | None) -> Event:
        """Return the episodes of some envs (R,) that begin in the stance, at rest."""
        robot, count = self._simulation.robot, len(env_ids)
        qpos, qvel = np.zeros((count, robot.num_positions)), np.zeros((count, robot.num_velocities))
        qpos[:, 2], qpos[:, 7:] = self._start_height, robot.stance
        if place is not None:
            qpos[:, :2] = place
        tilt = np.zeros((count, 3))
        return Event(self._simulation, robot, env_ids, qpos, qvel, tilt, self.sensors, self.servos)

    def start_servos(self, env_ids: EnvIds) -> None:
        """Let the gears of some envs' servos (R,) begin where their joints are."""
        if self.servos is not None:
            self.servos.start(env_ids, self._encoder_position()[env_ids])

    def motor_target(self, target: Floats) -> Floats:
        """Return the joint positions (N, J) that the motors pull to, for joint targets (N, J); both in rad."""
        if self.servos is not None:
            target = self.servos.joint_target(target, self._encoder_position())
        return target if self.sensors is None else self.sensors.joint_target(target)

    def _encoder_position(self) -> Floats:
        """Return the present joint positions (N, J) in rad as the servos measure them."""
        return self._simulation.readings.joint_position if self.sensors is None else self.sensors.encoder_position()

    def resample_commands(self, fixed: Bools, running: EnvIds | None) -> None:
        """Draw the commands that are due, in all envs or some (R,), but not where they are fixed, a mask (N,)."""
        env_ids = _among((self._control.steps >= self.command_due) & ~fixed, running)
        if len(env_ids):
            steps = self._control.steps[env_ids]
            command, seconds = self.commands.sample(self._draws.uniform(self.commands.purposes, env_ids, steps))
            self.command_due[env_ids] = steps + in_steps(seconds, self._timestep)
            self._control.set_command(env_ids, command)

    def within_episodes(self, running: EnvIds | None) -> None:
        """Apply the randomizations that are due in some envs (R,), or all, and end those that have lasted."""
        steps = self._control.steps
        for entry in self._recurring:
            if entry.duration is not None:
                env_ids = _among((entry.until > 0) & (steps >= entry.until), running)
                if len(env_ids):
                    entry.until[env_ids] = 0
                    width = entry.purposes.widths[entry.active.name]
                    entry.active.apply(self._event(env_ids), np.zeros((len(env_ids), width)))
            env_ids = _among(steps >= entry.due, running)
            if len(env_ids):
                self._repeat(entry, env_ids, steps[env_ids])

    def _repeat(self, entry: _Recurring, env_ids: EnvIds, now: Steps) -> None:
        """Apply a randomization to some envs (R,) at a step of each episode (R,), and draw when it applies next."""
        name, columns = entry.active.name, entry.purposes.slices
        draws = self._draws.uniform(entry.purposes, env_ids, now)
        wait = between(entry.interval, draws[:, columns[f"{name}/interval"].start])
        entry.due[env_ids] += in_steps(wait, self._timestep)
        if entry.duration is not None:
            lasting = between(entry.duration, draws[:, columns[f"{name}/duration"].start])
            entry.until[env_ids] = now + in_steps(lasting, self._timestep)
        entry.active.draw(self._event(env_ids), draws[:, columns[name]])

    def _event(self, env_ids: EnvIds) -> Event:
        """Return some envs (R,) within their episodes."""
        start = _NO_STATE, _NO_STATE, _NO_STATE
        return Event(self._simulation, self._control.robot, env_ids, *start, self.sensors, self.servos)

    def observation_noise(self) -> Floats:
        """Return noise on the unscaled readings (N, width), the same at the same step; overwritten by the next call."""
        draws = self._draws.uniform(self._noise, slice(None), self._control.steps)
        self._noise_values[:, self._noisy] = self._noise_amplitude * (2.0 * draws - 1.0)
        return self._noise_values


def _among(mask: Bools, running: EnvIds | None) -> EnvIds:
    env_ids = np.flatnonzero(mask)
    return env_ids if running is None else np.intersect1d(env_ids, running)


def _sensors(simulation: Simulation, timestep: float, active: Settings) -> Sensors | None:
    """Return the errors of the sensors that the active randomizations set; None if they set none."""
    largest: dict[Quantity, float] = {}
    for randomization, setting in active:
        if isinstance(randomization.apply, SensorError):
            quantity = randomization.apply.quantity
            largest[quantity] = max(largest.get(quantity, 0.0), *ends_of(setting))
    return Sensors(simulation, timestep, largest) if largest else None


def _servos(simulation: Simulation, motors: MotorConfig, active: Settings) -> ServoErrors | None:
    """Return the errors of the servos, of the motors or of an active built-in randomization; None if there are none."""
    of_motors = any(errors.any() for errors in motors.servo_errors(simulation.robot.joint_kinds))
    randomized = any(randomization.name in SERVO_ERRORS for randomization, _ in active)
    return ServoErrors(simulation, motors) if of_motors or randomized else None
