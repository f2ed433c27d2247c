"""`Trace`: a robot over time. Rollouts, recordings, films and the viewer hold their samples in it.

A quantity is declared once, as an annotated field of `Trace` or of a subclass. The recorder allocates from the
declaration, and every trace is checked against it.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cache, cached_property
from typing import Annotated, Any, Generic, Literal, Self, TypeVar, get_args

import numpy as np
from numpy.typing import DTypeLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import Robot
from quadruped_env.robot.readings import Readings
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.simulation import Terrain, flat
from quadruped_env.trajectory import JointTrajectory


@dataclass(frozen=True)
class Quantity:
    """Shape and type of a quantity of one env at one time."""

    shape: tuple[int | Literal["joints", "legs", "terms"], ...] = ()
    """Lengths; `joints` and `legs` are the robot's numbers of them, `terms` is any number"""
    truth: bool = False
    """True for truth values, False for floating-point numbers"""

    def shape_for(self, robot: Robot) -> tuple[int | None, ...]:
        """Lengths for a robot; None for any number."""
        lengths = {"joints": robot.num_joints, "legs": robot.num_legs, "terms": None}
        return tuple(lengths[axis] if isinstance(axis, str) else axis for axis in self.shape)


_Floats = NDArray[np.floating[Any]]
Scalar = Annotated[_Floats, Quantity()]
Velocity = Annotated[_Floats, Quantity((2,))]
Pose = Annotated[_Floats, Quantity((7,))]
PerJoint = Annotated[_Floats, Quantity(("joints",))]
PerLeg = Annotated[_Floats, Quantity(("legs",))]
PositionPerLeg = Annotated[_Floats, Quantity(("legs", 3))]
PerTerm = Annotated[_Floats, Quantity(("terms",))]
Flag = Annotated[NDArray[np.bool_], Quantity(truth=True)]
FlagPerLeg = Annotated[NDArray[np.bool_], Quantity(("legs",), truth=True)]


@dataclass(frozen=True, kw_only=True, eq=False)
class Trace:
    """A robot with J joints and L legs over time: T samples of N envs.

    Arrays have the shape (T, N, ...), or (T, ...) in a trace of one env, or (...) in a single sample of one env. None
    stands for a quantity that is not known.

    Raises:
        QuadrupedError: if an array does not have the shape of its quantity.
    """

    robot: Robot
    timestep: float
    """Time between samples, s"""
    base_pose: Pose
    """Position in m and quaternion wxyz of the base in the world (T, N, 7)"""
    joint_position: PerJoint
    """Joint positions, rad (T, N, J)"""
    joint_velocity: PerJoint | None = None
    """Joint velocities, rad/s (T, N, J)"""
    joint_torque: PerJoint | None = None
    """Motor torques in the last physics step of each control step, N m (T, N, J)"""
    velocity: Velocity | None = None
    """Forward velocity in m/s and yaw rate in rad/s, in the body frame (T, N, 2)"""
    command: Velocity | None = None
    """Velocity command in the same units (T, N, 2); None for a controller that follows none"""
    contact: FlagPerLeg | None = None
    """True for each foot on the ground (T, N, L)"""
    terrain: Terrain = flat
    """Ground below the robot"""
    first_stamp: int = 0
    """Timestamp of the first sample, ns"""

    def __post_init__(self) -> None:
        axes = np.shape(self.base_pose)[:-1]
        for name, quantity in self.quantities().items():
            array = getattr(self, name)
            if array is not None:
                _check_shape(name, np.shape(array), (*axes, *quantity.shape_for(self.robot)))

    @classmethod
    @cache
    def quantities(cls) -> dict[str, Quantity]:
        """Declared quantities: name -> quantity."""
        return {
            declared.name: note
            for declared in fields(cls)
            for part in (declared.type, *get_args(declared.type))
            for note in getattr(part, "__metadata__", ())
        }

    def __len__(self) -> int:
        return len(self.base_pose)

    @property
    def seconds(self) -> float:
        """Duration, s."""
        return len(self) * self.timestep

    @property
    def base_position(self) -> _Floats:
        """Position of the base in the world, m (T, N, 3)."""
        return self.base_pose[..., :3]

    @property
    def orientation(self) -> _Floats:
        """Quaternion wxyz of the base (T, N, 4)."""
        return self.base_pose[..., 3:]

    def select(self, envs: int | Sequence[int] | NDArray[Any]) -> Self:
        """Copy of some of the envs, by indices or mask (N,); an index alone is `env`."""
        return self._view((slice(None), envs))

    def env(self, index: int) -> Self:
        """Trace of one env. It shares the arrays."""
        return self.select(index)

    def window(self, start: int = 0, stop: int | None = None) -> Self:
        """The samples from index `start` up to, but without, `stop`; None is the end. It shares the arrays."""
        first, *_ = slice(start, stop).indices(len(self))
        return self._view(slice(start, stop), first_stamp=self.first_stamp + int(self._stamps(np.array(first))))

    def _view(self, index: Any, **changes: Any) -> Self:
        arrays: dict[str, Any] = {name: getattr(self, name) for name in self.quantities()}
        views = {name: array[index] for name, array in arrays.items() if array is not None}
        return replace(self, **views, **changes)

    @classmethod
    def stack(cls, samples: Sequence[Self], every: int = 1) -> Self:
        """Trace of single samples of one env, arrays (...), whose first axis is time (T, ...).

        Args:
            samples: one or more, in order.
            every: distance of the samples to keep; the last one is kept.
        """
        kept = samples[::-1][::every][::-1]
        known = [name for name in cls.quantities() if getattr(kept[0], name) is not None]
        arrays: dict[str, Any] = {name: np.array([getattr(sample, name) for sample in kept]) for name in known}
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

    def _stamps(self, samples: NDArray[np.intp]) -> NDArray[np.int64]:
        """Timestamps of samples (indices) from the first one, ns."""
        return np.rint(samples * self.timestep * NS_PER_SECOND).astype(np.int64)


@dataclass(frozen=True, kw_only=True, eq=False)
class CommandedTrace(Trace):
    """Trace in which the optional quantities of `Trace` are always known."""

    joint_velocity: PerJoint = field()
    joint_torque: PerJoint = field()
    velocity: Velocity = field()
    command: Velocity = field()
    contact: FlagPerLeg = field()


def measured(readings: Readings) -> dict[str, NDArray[np.float64]]:
    """Quantities of a `Trace` that readings of N envs state: name -> (N, ...), in part live views."""
    return {
        "base_pose": np.concatenate([readings.base_position, readings.orientation], axis=1),
        "joint_position": readings.joint_position,
        "joint_velocity": readings.joint_velocity,
        "joint_torque": readings.joint_torque,
        "velocity": np.stack([readings.linear_velocity_b[:, 0], readings.angular_velocity_b[:, 2]], axis=1),
    }


TraceT = TypeVar("TraceT", bound=Trace)


class Recorder(Generic[TraceT]):
    """Records samples of N envs, one per control step, as a kind of trace declares them.

    Args:
        kind: `Trace` or a subclass.
        robot: robot of the trace.
        steps: number of samples T. Samples that are never written are zero.
        dtype: type of the floating-point quantities.
    """

    def __init__(self, kind: type[TraceT], robot: Robot, steps: int, dtype: DTypeLike = np.float64) -> None:
        self._kind, self._robot, self._steps, self._dtype = kind, robot, steps, dtype
        self._arrays: dict[str, Any] = {}
        self.written = 0
        """Number of samples written."""

    def write(self, readings: Readings, **values: NDArray[Any]) -> None:
        """Write the next sample. The first one decides which quantities are recorded.

        Args:
            readings: of N envs.
            values: quantity of the kind of trace -> (N, ...), besides those that readings state.

        Raises:
            QuadrupedError: if all samples are written, a quantity is not the kind's or was not in the first sample, or
                a value does not have the shape of its quantity.
        """
        if self.written == self._steps:
            raise QuadrupedError(f"recorder: all {self._steps} samples are written")
        sample = {**measured(readings), **values}
        if not self._arrays:
            self._allocate(sample)
        if sample.keys() != self._arrays.keys():
            names = ", ".join(sorted(sample.keys() ^ self._arrays.keys()))
            raise QuadrupedError(
                f"recorder: every sample has the quantities of the first one; only one of them has {names}"
            )
        for name, value in sample.items():
            place = self._arrays[name][self.written]
            _check_shape(name, np.shape(value), place.shape)
            place[...] = value
        self.written += 1

    def _allocate(self, sample: dict[str, NDArray[Any]]) -> None:
        declared, envs = self._kind.quantities(), len(sample["base_pose"])
        unknown = ", ".join(sorted(sample.keys() - declared.keys()))
        if unknown:
            raise QuadrupedError(
                f"recorder: {self._kind.__name__} has no quantity {unknown}; it has {', '.join(declared)}"
            )
        for name, value in sample.items():
            _check_shape(name, np.shape(value), (envs, *declared[name].shape_for(self._robot)))
        self._arrays = {
            name: np.zeros((self._steps, *np.shape(value)), np.bool_ if declared[name].truth else self._dtype)
            for name, value in sample.items()
        }

    def trace(self, **values: Any) -> TraceT:
        """The trace of all T samples, read-only, which ends the recording; `values` are its fields not recorded."""
        for array in self._arrays.values():
            array.flags.writeable = False
        return self._kind(robot=self._robot, **self._arrays, **values)


def _check_shape(name: str, found: tuple[int, ...], expected: tuple[int | None, ...]) -> None:
    if found == expected:
        return
    fits = len(found) == len(expected) and all(want in (None, got) for got, want in zip(found, expected, strict=True))
    if not fits:
        lengths = ", ".join("any" if length is None else str(length) for length in expected)
        raise QuadrupedError(f"trace: {name} must have shape ({lengths}); found {found}")
