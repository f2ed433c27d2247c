"""Random quantities of episodes: their starts, model parameters, commands, pushes and sensor noise."""

import math
from collections.abc import Iterable, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.robot.motors import SERVO_ERRORS, MotorConfig
from quadruped_env.robot.units import scale_of
from quadruped_env.simulation import Simulation, highest_ground
from quadruped_env.task.command_sampling import CommandSampler
from quadruped_env.task.randomization.draws import Draws, Purposes
from quadruped_env.task.randomization.event import Event
from quadruped_env.task.randomization.model_fields import ModelField, Payload, check_physical
from quadruped_env.task.randomization.randomization import (
    Active,
    Randomization,
    RandomizationSection,
    SensorError,
    between,
    ends_of,
    in_steps,
)
from quadruped_env.task.randomization.recurring import Recurring
from quadruped_env.task.randomization.sensor_errors import Quantity, Sensors
from quadruped_env.task.randomization.servo_errors import ServoErrors
from quadruped_env.utils import rotations

Floats = NDArray[np.float64]
EnvIds = NDArray[np.intp]

_CLEARANCE: Final = 0.01
"""Height of the stance above the ground below it at the start, so that randomized legs do not penetrate it; of the
built-in robot, m."""
_NO_STATE: Final = np.zeros((0, 0))


class Randomizer:
    """Applies the randomizations of a task, and samples its commands and observation noise.

    Args:
        simulation: simulation of N robots.
        control: gait clocks and commands of the robots.
        draws: source of random numbers.
        randomizations: randomizations of the task.
        section: their settings.
        commands: sampler of the commands.
        motors: motors without randomization.
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
        self._section, self._timestep = section, control.config.timestep
        active = section.active(randomizations)
        starting, recurring = [r for r in active if r.interval is None], [r for r in active if r.interval is not None]
        self.sensors = _sensors(simulation, self._timestep, section, active)
        """Errors of the sensors; None if they have none."""
        self.servos = _servos(simulation, motors, active)
        """Errors of the servos; None if they have none."""
        self._check(starting)
        self.memory = EpisodeMemory(control.num_envs)
        self.command_due: NDArray[np.int64] = self.memory.zeros("command_due", dtype=np.int64)
        """Control step of the episode at which the next command is drawn, (N,)."""
        self.commands = commands
        self._recurring = []
        for r in recurring:
            assert r.interval is not None
            interval = section[r.interval[0]]
            duration = None if r.duration is None else section[r.duration[0]]
            self._recurring.append(
                Recurring(self._bound(r), simulation, interval, duration, self._timestep, draws, self.memory)
            )
        self._starting = [self._bound(r) for r in starting]
        robot = simulation.robot
        self._start_draws = Purposes(
            {
                **{r.name: r.randomization.draws(robot) for r in self._starting},
                "phase": 1,
                **{f"{entry.name}/interval": 1 for entry in self._recurring},
                **commands.purposes.widths,
            }
        )
        moved = any(r.name in ("start_joint_position", "start_tilt") for r in starting)
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

    def _bound(self, randomization: Randomization) -> Active:
        return Active.of(randomization, self._section[randomization.name], self._simulation)

    def _check(self, starting: list[Randomization]) -> None:
        """Check that the ranges of the model's fields leave a model that is physically possible."""
        fields = [
            (r.name, part, ends_of(self._section[r.name]))
            for r in starting
            for part in (r.apply if isinstance(r.apply, tuple) else (r.apply,))
            if isinstance(part, (ModelField, Payload))
        ]
        units = {r.name: r.unit for r in starting}
        check_physical(fields, self._simulation, units.__getitem__)

    def begin_episodes(self, env_ids: EnvIds, place: Floats | None = None, command: Floats | None = None) -> None:
        """Set some envs (R,) to random initial states.

        Args:
            env_ids: indices of the envs.
            place: position (R, 2) of each start, m; None: the origin.
            command: commands (R, C); None: random.
        """
        simulation, sensors = self._simulation, self.sensors
        simulation.restore_model_fields(env_ids)
        if sensors is not None:
            sensors.memory.clear(env_ids)
        if self.servos is not None:
            self.servos.clear(env_ids)
        draws, columns = (
            self._draws.uniform(self._start_draws, env_ids, np.zeros_like(env_ids)),
            self._start_draws.slices,
        )
        event = self._start(env_ids, place)
        for entry in self._starting:
            entry.apply(event, entry.values(draws[:, columns[entry.name]]))
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
            wait = between(recurring.interval, draws[:, columns[f"{recurring.name}/interval"].start])
            recurring.due[env_ids] = in_steps(wait, self._timestep)
        of_command = slice(columns["command/kind"].start, columns["command/interval"].stop)
        drawn, until_next = self.commands.sample(draws[:, of_command])
        self.command_due[env_ids] = in_steps(until_next, self._timestep)
        phase = math.tau * draws[:, columns["phase"].start]
        self._control.reset(env_ids, phase, drawn if command is None else command)

    def _start(self, env_ids: EnvIds, place: Floats | None) -> Event:
        """Episodes of some envs (R,) that begin in the stance, at rest."""
        robot, rows = self._simulation.robot, len(env_ids)
        qpos, qvel = np.zeros((rows, robot.num_positions)), np.zeros((rows, robot.num_velocities))
        qpos[:, 2], qpos[:, 7:] = self._start_height, robot.stance
        if place is not None:
            qpos[:, :2] = place
        tilt = np.zeros((rows, 3))
        return Event(self._simulation, robot, env_ids, qpos, qvel, tilt, self.sensors, self.servos)

    def start_servos(self, env_ids: EnvIds) -> None:
        """Let the gears of some envs' servos (R,) begin where their joints are."""
        if self.servos is not None:
            self.servos.start(env_ids, self._encoder_position()[env_ids])

    def motor_target(self, target: Floats) -> Floats:
        """Joint positions (N, J) that the motors pull to, for joint targets (N, J); both in rad."""
        if self.servos is not None:
            target = self.servos.joint_target(target, self._encoder_position())
        return target if self.sensors is None else self.sensors.joint_target(target)

    def _encoder_position(self) -> Floats:
        """Present joint positions (N, J) in rad as the servos measure them."""
        return self._simulation.readings.joint_position if self.sensors is None else self.sensors.encoder_position()

    def next_command(self, env_ids: EnvIds) -> Floats:
        """New commands (R, C) for some envs (R,) in the middle of their episodes."""
        steps = self._control.steps[env_ids]
        command, seconds = self.commands.sample(self._draws.uniform(self.commands.purposes, env_ids, steps))
        self.command_due[env_ids] = steps + in_steps(seconds, self._timestep)
        return command

    def within_episodes(self, running: EnvIds | None) -> None:
        """Apply the randomizations that are due at this control step, in all envs or some (R,)."""
        for entry in self._recurring:
            entry.apply(self._control.steps, running, self._event)

    def _event(self, env_ids: EnvIds) -> Event:
        """Some envs (R,) within their episodes."""
        start = _NO_STATE, _NO_STATE, _NO_STATE
        return Event(self._simulation, self._control.robot, env_ids, *start, self.sensors, self.servos)

    def observation_noise(self) -> Floats:
        """Noise on the unscaled readings (N, width), the same at the same step; overwritten by the next call."""
        draws = self._draws.uniform(self._noise, slice(None), self._control.steps)
        self._noise_values[:, self._noisy] = self._noise_amplitude * (2.0 * draws - 1.0)
        return self._noise_values


def _sensors(
    simulation: Simulation, timestep: float, section: RandomizationSection, active: Sequence[Randomization]
) -> Sensors | None:
    """Errors of the sensors that the active randomizations set; None if they set none."""
    largest: dict[Quantity, float] = {}
    for randomization in active:
        if isinstance(randomization.apply, SensorError):
            quantity, ends = randomization.apply.quantity, ends_of(section[randomization.name])
            largest[quantity] = max(largest.get(quantity, 0.0), *ends)
    return Sensors(simulation, timestep, largest) if largest else None


def _servos(simulation: Simulation, motors: MotorConfig, active: Sequence[Randomization]) -> ServoErrors | None:
    """Errors of the servos, of the motors or of an active built-in randomization; None if there are none."""
    of_motors = any(errors.any() for errors in motors.servo_errors(simulation.robot.joint_kinds))
    randomized = any(randomization.name in SERVO_ERRORS for randomization in active)
    return ServoErrors(simulation, motors) if of_motors or randomized else None
