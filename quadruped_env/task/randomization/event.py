"""Envs to which a randomization is applied, and the functions that apply it."""

from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.robot import Robot
from quadruped_env.simulation import Simulation
from quadruped_env.task.randomization.sensor_errors import Sensors
from quadruped_env.task.randomization.servo_errors import ServoErrors

Floats = NDArray[np.float64]


@dataclass(slots=True)
class Event:
    """Envs to which a randomization is applied, at the start of their episodes or within them."""

    simulation: Simulation
    robot: Robot
    env_ids: NDArray[np.intp]
    """Indices of the envs (R,)."""
    qpos: Floats
    """Initial base pose and joint positions in MuJoCo's order, (R, 7 + J); empty within an episode."""
    qvel: Floats
    """Initial base and joint velocities in MuJoCo's order, (R, 6 + J)."""
    tilt: Floats
    """Initial roll, pitch and heading of the base (R, 3), rad."""
    sensors: Sensors | None = None
    """Errors of the sensors; None if no randomization of the task sets any."""
    servos: ServoErrors | None = None
    """Errors of the servos; None if the motors have none and no randomization sets any."""
    payload_position: Floats = field(default_factory=lambda: np.zeros((1, 3)))
    """Position of the payload relative to the centre of mass of the base, in its frame, (R, 3) or (1, 3), m."""

    @property
    def at_start(self) -> bool:
        """True at the start of an episode."""
        return self.qpos.size > 0


class Apply(Protocol):
    """Function that applies a randomization."""

    def __call__(self, event: Event, values: Floats) -> None:
        """Apply values (R, width)."""
        ...


class Bindable(Protocol):
    """Description of what a randomization changes; a simulation turns it into a function."""

    def bind(self, simulation: Simulation, width: int) -> Apply:
        """Function for a simulation and `width` values per env.

        Raises:
            QuadrupedError: if the model lacks what it changes, or cannot take that many values.
        """
        ...
