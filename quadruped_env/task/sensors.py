"""Sensors with errors: the readings from which the policy's observation is computed.

A real robot has errors of its own, so they belong to the simulated task and not to `quadruped_env.control`. Rewards,
terminations, `info` and recordings use the true readings.
"""

import math
from collections.abc import Mapping
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from quadruped_env import rotations
from quadruped_env.control.memory import EpisodeMemory
from quadruped_env.readings import Readings
from quadruped_env.simulation import Simulation

Floats = NDArray[np.float64]
Quantity = Literal["encoder_offset", "imu_mounting", "latency"]

_IMU_VECTORS: Final = ("angular_velocity_b", "linear_acceleration_b", "up_b")
"""Readings in the frame of the IMU, which a mounting error turns."""
_UNIT_VECTORS: Final = ("orientation", "up_b")
"""Readings of length 1, also between two of them."""
_ROUNDING: Final = 1e-9
"""Share of a control step below which a latency is a whole number of steps."""


class Sensors:
    """Errors of the sensors of N robots, constant during an episode, and the readings with these errors.

    An encoder with an offset shows its joint at another position, and the motor's controller uses the same encoder: the
    joint target is shifted, too. A turned IMU gives vectors in its own frame. Readings arrive late by the latency;
    between the readings of two control steps, which are all that is stored, they are interpolated linearly.

    Args:
        simulation: simulation of N robots.
        timestep: time between control steps, s.
        largest: largest value of each quantity that is randomized; the others have no error.
    """

    def __init__(self, simulation: Simulation, timestep: float, largest: Mapping[Quantity, float]) -> None:
        n = simulation.num_envs
        self._simulation, self._timestep = simulation, timestep
        self._randomized = frozenset(largest)
        self.memory = EpisodeMemory(n)
        self.encoder_offset: Floats = self.memory.zeros("encoder_offset", simulation.robot.num_joints)
        """Reading of each joint's encoder minus the joint's position, (N, J), rad."""
        self.imu_mounting: Floats = self.memory.zeros("imu_mounting", 3)
        """Roll, pitch and yaw of the IMU in the frame of the base, (N, 3), rad."""
        self.latency: Floats = self.memory.zeros("latency", 1)
        """Age of the readings when the policy receives them, (N, 1), s."""
        self._mounting: Floats = self.memory.zeros("imu_quaternion", 4)
        self._to_imu: Floats = self.memory.zeros("imu_matrix", 3, 3)
        self._steps: NDArray[np.int64] = self.memory.zeros("latency_steps", dtype=np.int64)
        self._share: Floats = self.memory.zeros("latency_share", 1)
        # A ring of readings, of as many control steps as the latency reaches back, and of the one before these.
        self._depth = math.ceil(largest["latency"] / timestep - _ROUNDING) + 2 if "latency" in largest else 0
        self._ring: Floats = self.memory.zeros("readings", self._depth, simulation.sensordata.shape[1])
        self._all = np.arange(n)
        self._sensordata = np.zeros_like(simulation.sensordata)
        self._bind()

    def _bind(self) -> None:
        simulation = self._simulation
        self._readings = Readings.from_sensordata(simulation.model, self._sensordata, simulation.robot)

    def __getstate__(self) -> dict[str, Any]:
        # The readings are views of the sensor data, and unpickling would turn them into copies.
        return {name: value for name, value in self.__dict__.items() if name != "_readings"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._bind()

    def before_start(self, env_ids: NDArray[np.intp]) -> None:
        """Take over the errors of some envs (R,) that begin an episode, before the simulation resets them."""
        if "encoder_offset" in self._randomized:
            # The motor's controller limits targets to the joint's range by its encoder.
            limits = self._simulation.model_field("actuator_ctrlrange")
            limits[env_ids] -= self.encoder_offset[env_ids][..., None]
        if "imu_mounting" in self._randomized:
            self._mounting[env_ids] = rotations.from_roll_pitch_yaw(self.imu_mounting[env_ids])
            columns = rotations.rotate_inverse(self._mounting[env_ids, None], np.eye(3))
            self._to_imu[env_ids] = np.swapaxes(columns, 1, 2)
        if "latency" in self._randomized:
            steps = self.latency[env_ids, 0] / self._timestep
            self._steps[env_ids] = whole = np.floor(steps + _ROUNDING).astype(np.int64)
            share = steps - whole
            self._share[env_ids, 0] = np.where(share > _ROUNDING, share, 0.0)

    def after_start(self, env_ids: NDArray[np.intp]) -> None:
        """Store the first readings of some envs (R,); those before the episode are the same."""
        self._ring[env_ids] = self._simulation.sensordata[env_ids, None]

    def joint_target(self, target: Floats) -> Floats:
        """Joint positions (N, J) in rad at which the encoders show the targets (N, J)."""
        return target - self.encoder_offset if "encoder_offset" in self._randomized else target

    def read(self, steps: NDArray[np.int64]) -> Readings:
        """Readings with their errors at a control step of each episode (N,); the next call overwrites them."""
        if "latency" in self._randomized:
            self._ring[self._all, steps % self._depth] = self._simulation.sensordata
            latest = steps - self._steps
            newer, older = (self._ring[self._all, step % self._depth] for step in (latest, latest - 1))
            np.subtract(older, newer, older)
            np.multiply(older, self._share, older)
            np.add(newer, older, self._sensordata)
            for name in _UNIT_VECTORS:
                vector = getattr(self._readings, name)
                unit = vector / np.sqrt(np.vecdot(vector, vector))[:, None]
                np.copyto(vector, unit, where=self._share > 0.0)
        else:
            np.copyto(self._sensordata, self._simulation.sensordata)
        readings = self._readings
        if "encoder_offset" in self._randomized:
            np.add(readings.joint_position, self.encoder_offset, readings.joint_position)
        if "imu_mounting" in self._randomized:
            for name in _IMU_VECTORS:
                vector = getattr(readings, name)
                vector[:] = np.vecdot(self._to_imu, vector[:, None])
            readings.orientation[:] = rotations.multiply(readings.orientation, self._mounting)
        return readings
