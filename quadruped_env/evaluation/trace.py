"""`Trace`: a robot over time. Rollouts, recordings, films and the viewer hold their samples in it."""

from collections.abc import Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import DTypeLike, NDArray

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import Robot
from quadruped_env.robot.readings import Readings
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.simulation import Terrain, flat
from quadruped_env.trajectory import JointTrajectory

Array = NDArray[Any]


@dataclass(frozen=True, kw_only=True, eq=False)
class Trace:
    """A robot with J joints and L legs over time: T samples of N envs.

    Arrays have the shape (T, N, ...), or (T, ...) in a trace of one env, or (...) in a single sample of one env. None
    stands for a quantity that is not known.

    Raises:
        QuadrupedError: if arrays differ in the axes of time and envs, or in the number of joints from the robot.
    """

    robot: Robot
    timestep: float
    """Time between samples, s"""
    base_pose: Array
    """Position in m and quaternion wxyz of the base in the world (T, N, 7)"""
    joint_position: Array
    """Joint positions, rad (T, N, J)"""
    joint_velocity: Array | None = None
    """Joint velocities, rad/s (T, N, J)"""
    joint_torque: Array | None = None
    """Motor torques in the last physics step of each control step, N m (T, N, J)"""
    velocity: Array | None = None
    """Velocities of the robot's `velocity_commands`, in the body frame, m/s and rad/s (T, N, V)"""
    command: Array | None = None
    """Velocity command in the same units (T, N, V); None for a controller that follows none"""
    contact: NDArray[np.bool_] | None = None
    """True for each foot on the ground (T, N, L)"""
    terrain: Terrain = flat
    """Ground below the robot"""
    first_stamp: int = 0
    """Timestamp of the first sample, ns"""

    def __post_init__(self) -> None:
        axes, joints = np.shape(self.base_pose)[:-1], self.robot.num_joints
        for name, array in self.quantities().items():
            if array.shape[: len(axes)] != axes:
                raise QuadrupedError(f"trace: {name} must have the axes {axes} of base_pose first; found {array.shape}")
            if name.startswith("joint_") and array.shape != (*axes, joints):
                raise QuadrupedError(f"trace: {name} must have shape {(*axes, joints)}; found {array.shape}")

    def quantities(self) -> dict[str, Array]:
        """Return known arrays by name."""
        values = {declared.name: getattr(self, declared.name) for declared in fields(self)}
        return {name: value for name, value in values.items() if isinstance(value, np.ndarray)}

    def __len__(self) -> int:
        return len(self.base_pose)

    @property
    def seconds(self) -> float:
        """Duration, s."""
        return len(self) * self.timestep

    @property
    def base_position(self) -> Array:
        """Position of the base in the world, m (T, N, 3)."""
        return self.base_pose[..., :3]

    @property
    def orientation(self) -> Array:
        """Quaternion wxyz of the base (T, N, 4)."""
        return self.base_pose[..., 3:]

    def select(self, envs: int | Sequence[int] | NDArray[Any]) -> Self:
        """Copy some of the envs, by indices or mask (N,); an index alone is `env`."""
        return self._view((slice(None), envs))

    def env(self, index: int) -> Self:
        """Return the trace of one env. It shares the arrays."""
        return self.select(index)

    def window(self, start: int = 0, stop: int | None = None) -> Self:
        """Return the samples from index `start` up to, but without, `stop`; None is the end. They share the arrays."""
        first, *_ = slice(start, stop).indices(len(self))
        return self._view(slice(start, stop), first_stamp=self.first_stamp + int(self._stamps(np.array(first))))

    def _view(self, index: Any, **changes: Any) -> Self:
        return replace(self, **{name: array[index] for name, array in self.quantities().items()}, **changes)

    @classmethod
    def stack(cls, samples: Sequence[Self], every: int = 1) -> Self:
        """Join single samples (one or more, in order) of one env, arrays (...), to a trace (T, ...).

        Every n-th sample is kept, counted backwards from the last one.
        """
        kept = samples[::-1][::every][::-1]
        arrays: dict[str, Any] = {
            name: np.array([getattr(sample, name) for sample in kept]) for name in kept[0].quantities()
        }
        return replace(kept[0], **arrays, timestep=every * kept[0].timestep)

    @cached_property
    def joints(self) -> JointTrajectory:
        """Joint positions, velocities and torques of a trace of one env.

        Raises:
            QuadrupedError: if the trace has several envs, or a value is not finite.
        """
        if self.joint_position.ndim != 2:
            raise QuadrupedError(
                f"joints: expected a trace of one env over time; found joint positions of shape "
                f"{self.joint_position.shape}; take one env with env(index)"
            )
        stamps = self.first_stamp + self._stamps(np.arange(len(self)))
        names = self.robot.joint_names
        return JointTrajectory(stamps, names, self.joint_position, self.joint_velocity, self.joint_torque)

    def save(self, path: Path, overwrite: bool = False) -> None:
        """Write the joints of a trace of one env to a CSV or, with the base's pose in `odom`, a bag.

        Raises:
            QuadrupedError, MissingExtraError: as `JointTrajectory.save`.
        """
        self.joints.save(path, overwrite, base_pose=self.base_pose, robot=self.robot)

    def _stamps(self, samples: NDArray[np.intp]) -> NDArray[np.int64]:
        """Return the timestamps of samples (indices) from the first one, ns."""
        return np.rint(samples * self.timestep * NS_PER_SECOND).astype(np.int64)


@dataclass(frozen=True, kw_only=True, eq=False)
class CommandedTrace(Trace):
    """Trace in which the optional quantities of `Trace` are always known."""

    joint_velocity: Array = field()
    joint_torque: Array = field()
    velocity: Array = field()
    command: Array = field()
    contact: NDArray[np.bool_] = field()


def measured(robot: Robot, readings: Readings) -> dict[str, NDArray[np.float64]]:
    """Return the quantities of a `Trace` that readings of N envs hold: name -> (N, ...), in part live views."""
    linear, angular = readings.linear_velocity_b, readings.angular_velocity_b
    velocities = [linear[:, 0], angular[:, 2], linear[:, 1]]
    return {
        "base_pose": np.concatenate([readings.base_position, readings.orientation], axis=1),
        "joint_position": readings.joint_position,
        "joint_velocity": readings.joint_velocity,
        "joint_torque": readings.joint_torque,
        "velocity": np.stack(velocities[: len(velocity_commands(robot))], axis=1),
    }


class Recorder:
    """Records samples of N envs, one per control step.

    Args:
        robot: robot of the envs.
        steps: number of samples T. Samples that are never written are zero.
        dtype: type of the floating-point quantities.
    """

    def __init__(self, robot: Robot, steps: int, dtype: DTypeLike = np.float64) -> None:
        self._robot, self._steps, self._dtype = robot, steps, dtype
        self._arrays: dict[str, Any] = {}
        self.written = 0
        """Number of samples written."""

    def write(self, readings: Readings, **values: Array) -> None:
        """Write the next sample: the readings of N envs, and further quantities (N, ...)."""
        sample = {**measured(self._robot, readings), **values}
        if not self._arrays:
            for name, value in sample.items():
                dtype = np.bool_ if value.dtype == np.bool_ else self._dtype
                self._arrays[name] = np.zeros((self._steps, *value.shape), dtype)
        for name, value in sample.items():
            self._arrays[name][self.written] = value
        self.written += 1

    def arrays(self) -> dict[str, Any]:
        """Return all T samples by name, read-only, as fields of a trace; this ends the recording."""
        for array in self._arrays.values():
            array.flags.writeable = False
        return self._arrays
