"""The robot as its messages describe it, in place of a simulation: a task on it sees what was measured."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import STANCE, STANCE_HEIGHT, load_model
from quadruped_env.simulation import State
from quadruped_env.simulation.interface import SimulationState


class MeasuredRobot:
    """`quadruped_env.simulation.Simulation` of one row, whose steps ask for joint targets and move nothing.

    Only what a robot measures is live: joint positions and velocities, attitude and angular velocity. The other
    readings are those of standing still.
    """

    num_rows = 1

    def __init__(self) -> None:
        self.model = load_model()
        self._readings = np.zeros((1, self.model.nsensordata))
        self.state = State.from_sensordata(self.model, self._readings)
        self.state.joint_position[:] = STANCE
        self.state.orientation[:, 0] = 1.0
        self.state.up_b[:, 2] = 1.0
        self.state.base_position[:, 2] = STANCE_HEIGHT
        self.joint_target = STANCE.copy()
        """What the last step asked for, rad (8,)"""

    def measure(
        self,
        positions: NDArray[np.float64],
        velocities: NDArray[np.float64],
        orientation: NDArray[np.float64],
        angular_velocity: NDArray[np.float64],
    ) -> None:
        """Take in one measurement.

        Args:
            positions: rad (8,).
            velocities: rad/s (8,).
            orientation: of the base, unit quaternion wxyz (4,).
            angular_velocity: of the base, in its own axes, rad/s (3,).
        """
        self.state.joint_position[0] = positions
        self.state.joint_velocity[0] = velocities
        self.state.orientation[0] = orientation
        self.state.up_b[0] = up_in_body(orientation)
        self.state.angular_velocity_b[0] = angular_velocity

    def step(self, joint_target: NDArray[np.float64], substeps: int, rows: NDArray[np.intp] | None = None) -> None:
        """See `Simulation.step`."""
        self.joint_target = joint_target[0].copy()

    def reset(self, rows: NDArray[np.intp], qpos: NDArray[np.float64], qvel: NDArray[np.float64]) -> None:
        """The robot stays where it is."""

    def diverged(self) -> NDArray[np.bool_]:
        """A robot does not diverge."""
        return np.zeros(1, dtype=np.bool_)

    def push(self, rows: NDArray[np.intp], velocity: NDArray[np.float64]) -> None:
        """Nothing here pushes the robot."""

    def model_field(self, name: str) -> NDArray[np.float64]:
        """A field of the model; what is written to it moves nothing."""
        return getattr(self.model, name)[None]

    def get_state(self, row: int) -> SimulationState:
        """A robot's state cannot be taken."""
        raise NotImplementedError

    def set_state(self, row: int, state: Any) -> None:
        """A robot cannot be put into a state."""
        raise NotImplementedError


def up_in_body(orientation: NDArray[np.float64]) -> NDArray[np.float64]:
    """The world's up direction (3,), seen from a base of a given attitude, quaternion wxyz (4,)."""
    w, x, y, z = orientation
    return np.array([2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)])
