"""Sensors with errors: the readings from which the policy's observation is computed.

A real robot has errors of its own, so they belong to the simulated task and not to `quadruped_env.control`. Rewards,
terminations, `info` and recordings use the true readings.
"""

import dataclasses
import math
from collections.abc import Mapping
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.robot.readings import Readings
from quadruped_env.simulation import Simulation
from quadruped_env.utils import rotations
from quadruped_env.utils.arrays import Floats

Quantity = Literal["encoder_offset", "imu_mounting", "latency"]

_IMU_VECTORS: Final = ("angular_velocity_b", "linear_acceleration_b", "up_b")
"""Readings in the frame of the IMU, which a mounting error turns."""
MEASURED: Final = (
    "joint_position",
    "joint_velocity",
    "joint_torque",
    "orientation",
    "angular_velocity_b",
    "linear_acceleration_b",
    "foot_force",
    "up_b",
)
"""Readings of sensors that a robot can have. All others are known to the simulator alone, and have no errors."""

_UNIT_VECTORS: Final = ("orientation", "up_b")
"""Readings of length 1, also between two of them."""
_ROUNDING: Final = 1e-9
"""Share of a control step below which a latency is a whole number of steps."""


class Sensors:
    """Errors of the sensors of N robots, constant during an episode, and the readings with these errors.

    An encoder with an offset shows its joint at another position, and the motor's controller uses the same encoder: the
    joint target is shifted, too. A turned IMU gives vectors in its own frame. Readings arrive late by the latency;
    between the readings of two control steps, which are all that is stored, they are interpolated linearly.

    `largest` has the largest value of each quantity that is randomized; the others have no error.
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
        self._turn: Floats = self.memory.zeros("imu_turn", 4, 4)
        """Matrix that turns an orientation of the base into one of the IMU; both are quaternions."""
        self._to_imu: Floats = self.memory.zeros("imu_matrix", 3, 3)
        """Matrix from the base's frame to the IMU's."""
        self._steps: NDArray[np.int64] = self.memory.zeros("latency_steps", dtype=np.int64)
        self._share: Floats = self.memory.zeros("latency_share", 1)
        # A ring of readings: the latest, and one per control step that the latency reaches back.
        self._depth = math.ceil(largest["latency"] / timestep - _ROUNDING) + 1 if "latency" in largest else 0
        ends = np.cumsum([simulation.sensordata[:, simulation.sensor_columns[name]].shape[1] for name in MEASURED])
        self._columns = [slice(start, end) for start, end in zip([0, *ends[:-1]], ends, strict=True)]
        self._ring: Floats = self.memory.zeros("readings", self._depth, int(ends[-1]))
        self._rows = np.arange(n) * self._depth
        self._measured, self._older = np.zeros((2, n, int(ends[-1])))
        own = {name: self._measured[:, columns] for name, columns in zip(MEASURED, self._columns, strict=True)}
        self._true = [getattr(simulation.readings, name) for name in MEASURED]
        self._readings = dataclasses.replace(simulation.readings, **own)

    def before_start(self, env_ids: NDArray[np.intp]) -> None:
        """Take over the errors of some envs (R,) that begin an episode, before the simulation resets them."""
        if "encoder_offset" in self._randomized:
            # The motor's controller limits targets to the joint's range by its encoder.
            limits = self._simulation.model_field("actuator_ctrlrange")
            limits[env_ids] -= self.encoder_offset[env_ids][..., None]
        if "imu_mounting" in self._randomized:
            mounting = rotations.from_roll_pitch_yaw(self.imu_mounting[env_ids])[:, None]
            # The columns of a matrix are what becomes of the unit vectors.
            self._to_imu[env_ids] = np.swapaxes(rotations.rotate_inverse(mounting, np.eye(3)), 1, 2)
            self._turn[env_ids] = np.swapaxes(rotations.multiply(np.eye(4), mounting), 1, 2)
        if "latency" in self._randomized:
            steps = self.latency[env_ids, 0] / self._timestep
            self._steps[env_ids] = whole = np.floor(steps + _ROUNDING).astype(np.int64)
            share = steps - whole
            self._share[env_ids, 0] = np.where(share > _ROUNDING, share, 0.0)

    def after_start(self, env_ids: NDArray[np.intp]) -> None:
        """Store the first readings of some envs (R,); those before the episode are the same."""
        if "latency" in self._randomized:
            self._measure()
            self._ring[env_ids] = self._measured[env_ids, None]

    def _measure(self) -> None:
        """Copy the true readings."""
        for columns, true in zip(self._columns, self._true, strict=True):
            self._measured[:, columns] = true

    def encoder_position(self) -> Floats:
        """Return the present joint positions (N, J) in rad as the encoders show them."""
        return self._simulation.readings.joint_position + self.encoder_offset

    def joint_target(self, target: Floats) -> Floats:
        """Return the joint positions (N, J) in rad at which the encoders show the targets (N, J)."""
        return target - self.encoder_offset if "encoder_offset" in self._randomized else target

    def read(self, steps: NDArray[np.int64]) -> Readings:
        """Return readings with their errors at a control step of each episode (N,); the next call overwrites them."""
        self._measure()
        if "latency" in self._randomized:
            ring, newer, older = self._ring.reshape(-1, self._ring.shape[-1]), self._measured, self._older
            ring[self._rows + steps % self._depth] = newer
            latest = steps - self._steps
            ring.take(self._rows + latest % self._depth, 0, newer, "clip")
            ring.take(self._rows + (latest - 1) % self._depth, 0, older, "clip")
            np.subtract(older, newer, older)
            np.multiply(older, self._share, older)
            np.add(newer, older, newer)
            for name in _UNIT_VECTORS:
                vector = getattr(self._readings, name)
                unit = vector / np.sqrt((vector**2).sum(axis=-1))[:, None]
                np.copyto(vector, unit, where=self._share > 0.0)
        readings = self._readings
        if "encoder_offset" in self._randomized:
            np.add(readings.joint_position, self.encoder_offset, readings.joint_position)
        if "imu_mounting" in self._randomized:
            for name in _IMU_VECTORS:
                vector = getattr(readings, name)
                vector[:] = _applied(self._to_imu, vector)
            readings.orientation[:] = _applied(self._turn, readings.orientation)
        return readings


def _applied(matrices: Floats, vectors: Floats) -> Floats:
    """Return products (N, K) of matrices (N, K, K) and vectors (N, K); a sum of columns, which is fast for small K."""
    result = matrices[:, :, 0] * vectors[:, :1]
    for i in range(1, vectors.shape[1]):
        result += matrices[:, :, i] * vectors[:, i, None]
    return result
