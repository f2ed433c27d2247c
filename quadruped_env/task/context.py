"""Input of reward terms and terminations."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.capture import Capture
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.robot.motors import MotorConfig
from quadruped_env.robot.readings import Readings
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.utils.arrays import NUMPY, Namespace

Floats = NDArray[np.float64]


class TaskContext:
    """Readings, actions, commands and episode memory of N envs after a control step.

    A term must read from the context that it is called with and keep no reference to its arrays: they are overwritten
    at every step, and may be replaced when an env is copied.

    Args:
        readings: readings of the simulation.
        control: gait clock, commands and actions.
        velocity_time_constant: time constant of `smooth_velocity`, s.
        contact_threshold: normal force above which a foot is in contact, N.
        height_field: heights of the ground; None for a plane at height 0.
        xp: array functions.
        motors: motors of the simulation. None: the robot's.
    """

    def __init__(
        self,
        readings: Readings,
        control: ControlInterface,
        velocity_time_constant: float,
        contact_threshold: float,
        height_field: HeightField | None = None,
        xp: Namespace = NUMPY,
        motors: MotorConfig | None = None,
    ) -> None:
        self.xp = xp
        self.robot = control.robot
        self.motors = motors or control.robot.motors
        """Motors of the simulation, without randomization."""
        self.memory = EpisodeMemory(control.num_envs, xp)
        """Arrays of the terms: zero after a reset, and saved with the env."""
        self.timestep = control.config.timestep
        """Time between actions, s."""
        self.velocity: Floats = xp.zeros((control.num_envs, 2))
        """Forward velocity (m/s) and yaw rate (rad/s) in the body frame, (N, 2)."""
        self.smooth_velocity: Floats = self.memory.zeros("smooth_velocity", 2)
        """Average of `velocity` over about one gait cycle, (N, 2)."""
        self.tracking_error: Floats = xp.zeros((control.num_envs, 2))
        """`smooth_velocity` minus the command in force during the step, (N, 2)."""
        self.fallen: Floats = xp.zeros(control.num_envs)
        """1.0 where the episode ends in a fall in this step, else 0.0, (N,)."""
        self.contact_threshold = xp.constant(contact_threshold)
        """Normal force above which a foot is in contact, N."""
        self._height_field = height_field
        self._foot_radius = xp.constant(control.robot.foot_radius)
        self._smoothing = np.array(1.0 - math.exp(-self.timestep / velocity_time_constant))
        self.bind(readings, control)

    def bind(self, readings: Readings, control: ControlInterface) -> None:
        """Replace the readings and the control interface."""
        self.readings = readings
        """Readings of the simulation; see `Readings`."""
        self.control = control
        self.action = control.action
        """Latest action in [-1, 1], (N, J)."""
        self.previous_action = control.previous_action
        """Action of the step before, (N, J)."""
        self.command = control.command
        """Commanded forward velocity (m/s) and yaw rate (rad/s), (N, 2)."""
        self.moving = control.moving
        """1.0 where a motion is commanded, else 0.0, (N,)."""
        self._update: Capture | None = None

    def __getstate__(self) -> dict[str, Any]:
        # Captured operations refer to arrays, which are others after unpickling.
        return {**self.__dict__, "_update": None}

    def stand_ins(self, capture: Capture) -> tuple["TaskContext"]:
        """This context with stand-ins for its arrays, as the argument of functions that are captured."""
        context = capture.stand_in(self)
        context.readings = capture.stand_in(self.readings)
        context.control = capture.stand_in(self.control)
        return (context,)

    def update(self) -> None:
        """Update the velocities from the readings after a control step."""
        if self.xp is not NUMPY:
            _update_velocities(self)
        elif self._update is None:
            self._update = Capture()
            self._update.record(_update_velocities, *self.stand_ins(self._update))  # which carries it out
        else:
            self._update.repeat()

    @property
    def joint_offset(self) -> Any:
        """Joint positions relative to the stance (N, J), rad."""
        return self.readings.joint_position - self.control.stance

    @property
    def base_height(self) -> Any:
        """Height of the base's centre over the ground below it (N,), m."""
        return self._over_ground(self.readings.base_position)

    @property
    def sole_height(self) -> Any:
        """Height of each foot's lowest point over the ground below it (N, L), m."""
        return self._over_ground(self.readings.foot_position) - self._foot_radius

    def ground_height(self, positions: Floats) -> Floats:
        """Height of the ground (N, ...) at positions (N, ..., 2 or 3) in the world frame, m."""
        if self._height_field is None:
            return np.zeros_like(positions[..., 0])
        return self._height_field.at(positions)

    def _over_ground(self, positions: Floats) -> Floats:
        height = positions[..., 2]
        return height if self._height_field is None else height - self._height_field.at(positions)

    @property
    def foot_contact(self) -> Any:
        """True for each foot on the ground, (N, L)."""
        return self.readings.foot_force > self.contact_threshold

    @property
    def contact(self) -> Any:
        """1.0 for each foot on the ground, else 0.0, (N, L)."""
        return self.xp.number(self.foot_contact)

    def command_of(self, name: str) -> Floats:
        """One component of the command by name, (N,)."""
        return self.control.command_of(name)


def _update_velocities(context: TaskContext) -> Any:
    np.positive(context.readings.linear_velocity_b[:, 0], out=context.velocity[:, 0])
    np.positive(context.readings.angular_velocity_b[:, 2], out=context.velocity[:, 1])
    change = context.velocity - context.smooth_velocity
    np.add(context.smooth_velocity, change * context._smoothing, out=context.smooth_velocity)
    return np.subtract(context.smooth_velocity, context.command, out=context.tracking_error)
