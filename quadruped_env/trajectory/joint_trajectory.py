"""`JointTrajectory`: joint states over time, from memory or from a file."""

import operator
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError, QuadrupedWarning
from quadruped_env.robot import MINI_QUADRUPED, Robot
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory import saving
from quadruped_env.trajectory.interpolation import Gap, derivative, even_stamps, find_gaps, interpolate, nanoseconds_of
from quadruped_env.trajectory.joint_map import JointMap
from quadruped_env.trajectory.loading import read
from quadruped_env.trajectory.reading import Reading, ReadOptions
from quadruped_env.trajectory.rows import (
    ARRAYS,
    IN_MEMORY,
    JointState,
    Rows,
    Source,
    check_finite,
    checked_names,
    checked_stamps,
    checked_values,
    read_only,
)
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.progress import Progress


@dataclass(frozen=True, eq=False, init=False, repr=False)
class JointTrajectory:
    """Joint states over time, validated and read-only.

    Args:
        stamps: timestamps in ns, integers, increasing (T,); T is 1 or more.
        names: one per joint, each once, in the order of the columns (J,). They need not be this robot's.
        positions: rad (T, J), finite.
        velocities: rad/s (T, J), finite; None if they were not recorded.
        efforts: N m (T, J), finite or NaN (not measured); None if they were not recorded.
        source: origin of the rows, for error messages.

    Raises:
        QuadrupedError: if a value is invalid; the message names the row, the field, the value and the fix.
    """

    stamps: NDArray[np.int64]
    names: tuple[str, ...]
    positions: Floats
    velocities: Floats | None
    efforts: Floats | None
    source: Source

    def __init__(
        self,
        stamps: ArrayLike,
        names: Sequence[str],
        positions: ArrayLike,
        velocities: ArrayLike | None = None,
        efforts: ArrayLike | None = None,
        source: Source = IN_MEMORY,
    ) -> None:
        joints, times = checked_names(names, source), checked_stamps(stamps, source)
        shape = len(times), len(joints)
        arrays = {"positions": positions, "velocities": velocities, "efforts": efforts}
        values: dict[str, Any] = {
            name: None if array is None else checked_values(name, array, shape, source)
            for name, array in arrays.items()
        }
        for kind, name in ARRAYS.items():
            if values[name] is not None:
                check_finite(kind, values[name], joints, source)
        for name, value in {"stamps": times, "names": joints, "source": source, **values}.items():
            object.__setattr__(self, name, value)

    @classmethod
    def load(cls, path: str | Path, *, progress: Progress | None = None, **options: Any) -> Self:
        """Read a trajectory from a file or bag, whose format is recognised by its content.

        Formats: this project's CSV (`quadruped_env.trajectory.formats.project_csv`), any CSV with a column map, CSVs
        whose columns bear the joints' names, the output of `ros2 topic echo` (YAML and `--csv`), rosbag2 bags (MCAP and
        sqlite3, also compressed), ROS 1 bags. Messages are `JointState`, `DynamicJointState`, `JointTrajectory` or
        `Float64MultiArray`.

        What is not plausible is noted (`quadruped_env.trajectory.plausibility`) in `source.notes`, and not changed.

        Args:
            path: of the file, or of a bag's directory.
            progress: called with the fraction read.
            options: fields of `quadruped_env.trajectory.ReadOptions`.

        Returns:
            The trajectory; `source.notes` lists what was left out.

        Raises:
            QuadrupedError: if there is no such file, or something in it is invalid; the message names the file, the
                line or message, the field, the value and the fix.
            MissingExtraError: if the format needs libraries that are not installed.
        """
        rows, source = read(Reading(Path(path), ReadOptions(**options), progress))
        return cls(rows.stamps, rows.names, source=source, **_arrays_of(rows))

    def save(
        self,
        path: str | Path,
        overwrite: bool = False,
        *,
        storage: str | None = None,
        base_pose: ArrayLike | None = None,
        robot: Robot = MINI_QUADRUPED,
    ) -> None:
        """Write the trajectory to a file or bag, in full or not at all; `load` reads it back to the last bit.

        Args:
            path: `NAME.csv` is this project's CSV, `NAME` a directory with a rosbag2 bag, and `NAME.mcap` or `NAME.db3`
                a bag's bare storage file. Missing directories are made. Bags are for Humble and later, and contain
                `/joint_states` and, for the robot's joints, `/robot_description`, `/tf` and `/tf_static`.
            overwrite: replace an existing file or bag.
            storage: of a bag in a directory: `mcap` (default) or `sqlite3`.
            base_pose: position in m and quaternion wxyz of the base in `odom` (T, 7), to be part of `/tf`.
            robot: robot that a bag describes.

        Raises:
            QuadrupedError: if the file exists and must not be overwritten, or cannot be written.
            MissingExtraError: if a bag is to be written and the libraries for it are not installed.
        """
        base = None if base_pose is None else checked_values("base_pose", base_pose, (len(self), 7), self.source)
        saving.save(self.to_rows(), Path(path), robot, storage, base, overwrite)

    def to_rows(self) -> Rows:
        """Return the rows, with their numbers in the source; the arrays are shared."""
        arrays, numbers = self._arrays(), self.source.numbers
        values = {kind: arrays[name] for kind, name in ARRAYS.items() if name in arrays}
        return Rows(np.arange(len(self)) if numbers is None else numbers, self.stamps, self.names, values)

    def __repr__(self) -> str:
        return (
            f"JointTrajectory({len(self)} rows over {self.duration:g} s, {len(self.names)} joints, "
            f"{' and '.join(self.kinds)})"
        )

    def __len__(self) -> int:
        return len(self.stamps)

    def __getitem__(self, index: int) -> JointState:
        i = operator.index(index)
        return JointState(
            stamp=int(self.stamps[i]),
            names=self.names,
            position=self.positions[i],
            velocity=None if self.velocities is None else self.velocities[i],
            effort=None if self.efforts is None else self.efforts[i],
        )

    def __iter__(self) -> Iterator[JointState]:
        return (self[i] for i in range(len(self)))

    @cached_property
    def _nanoseconds(self) -> Floats:
        """Time from the first timestamp, ns (T,)."""
        return (self.stamps - self.stamps[0]).astype(np.float64)

    @cached_property
    def times(self) -> Floats:
        """Time from the first timestamp, s (T,)."""
        return read_only(self._nanoseconds / NS_PER_SECOND)

    @property
    def duration(self) -> float:
        """Time from the first timestamp to the last, s."""
        return float(self.times[-1])

    def select(self, names: Sequence[str]) -> "JointTrajectory":
        """Return the trajectory with these joints only, in this order. Raises a QuadrupedError if one is missing."""
        for name in names:
            if name not in self.names:
                raise QuadrupedError(
                    f"{self.source.name}: joint {name!r} is missing; all {len(names)} are needed, and it has "
                    f"{', '.join(self.names)}; add its positions, or map another robot's joints (--map)"
                )
        order = [self.names.index(name) for name in names]
        return self._changed(names=tuple(names), **{kind: array[:, order] for kind, array in self._arrays().items()})

    def in_joint_order(self, robot: Robot = MINI_QUADRUPED) -> "JointTrajectory":
        """Return the trajectory with a robot's joints in their order.

        Warns:
            QuadrupedWarning: if there are joints that the robot does not have; they are left out.

        Raises:
            QuadrupedError: if a joint is missing.
        """
        ordered = self.select(robot.joint_names)
        unknown = [name for name in self.names if name not in robot.joint_names]
        if unknown:
            warnings.warn(
                f"{self.source.name}: left out joints that this robot does not have: {', '.join(unknown)}",
                QuadrupedWarning,
                stacklevel=2,
            )
        return ordered

    def positions_at(self, seconds: ArrayLike) -> Floats:
        """Return joint positions at times, in the order of `names`.

        Linear between rows, constant before the first and after the last. At the time of a row the result is
        bit-identical to the positions of the row.

        Args:
            seconds: times from the first timestamp, s (...,).

        Returns:
            Positions in rad (..., J).

        Raises:
            QuadrupedError: if a time is NaN.
        """
        time = np.asarray(seconds, dtype=np.float64)
        if np.isnan(time).any():
            raise QuadrupedError(f"{self.source.name}: positions_at: a time is NaN; give numbers, in s")
        return interpolate(self._nanoseconds, self.positions, nanoseconds_of(time, self._nanoseconds[-1]))

    def at(self, stamps: ArrayLike) -> "JointTrajectory":
        """Return the trajectory at other timestamps, interpolated linearly.

        Args:
            stamps: ns, increasing (N,).

        Raises:
            QuadrupedError: if the timestamps do not increase, or lie outside the recording.
        """
        wanted, first, last = checked_stamps(stamps, Source(f"{self.source.name}: at")), self.stamps[0], self.stamps[-1]
        if wanted[0] < first or wanted[-1] > last:
            outside = wanted[0] if wanted[0] < first else wanted[-1]
            raise QuadrupedError(
                f"{self.source.name}: at: timestamp {outside} ns lies outside the recording, {first} to {last} ns; "
                f"choose timestamps within it"
            )
        nanoseconds = (wanted - self.stamps[0]).astype(np.float64)
        return self._changed(
            stamps=wanted,
            source=Source(self.source.name),
            **{kind: interpolate(self._nanoseconds, array, nanoseconds) for kind, array in self._arrays().items()},
        )

    def resample(self, rate: float) -> "JointTrajectory":
        """Return the trajectory at an even rate from its first timestamp on, interpolated linearly.

        It is not filtered: frequencies above half the rate are aliased.

        Args:
            rate: Hz.

        Raises:
            QuadrupedError: if the rate is not above 0, or above 1 GHz.
        """
        if not 0.0 < rate <= NS_PER_SECOND:
            raise QuadrupedError(f"{self.source.name}: resample: expected a rate above 0 Hz; found {rate!r}")
        return self.at(even_stamps(self.stamps, rate))

    def slice(self, start: float | None = None, stop: float | None = None) -> "JointTrajectory":
        """Return the rows from `start` on and before `stop`, in s from the first timestamp; None means unbounded.

        Raises:
            QuadrupedError: if no row is left.
        """
        first = 0 if start is None else int(np.searchsorted(self.times, start))
        last = len(self) if stop is None else int(np.searchsorted(self.times, stop))
        if first >= last:
            raise QuadrupedError(
                f"{self.source.name}: slice: no row between {start} and {stop} s; it lasts {self.duration:g} s"
            )
        arrays = {kind: array[first:last] for kind, array in self._arrays().items()}
        source = replace(self.source, numbers=self.to_rows().numbers[first:last])
        return self._changed(stamps=self.stamps[first:last], source=source, **arrays)

    def differentiate(self, window: float = 0.05) -> "JointTrajectory":
        """Return the trajectory with velocities computed from its positions, filtered without delay.

        Args:
            window: length in s of the parabola fitted around every row, three rows or more; longer is smoother.

        Raises:
            QuadrupedError: if the window is not above 0, or there is only one row.
        """
        if not 0.0 < window < np.inf or len(self) == 1:
            raise QuadrupedError(
                f"{self.source.name}: differentiate: expected a window above 0 s and two rows or more; found "
                f"{window!r} and {len(self)}"
            )
        return self._changed(velocities=derivative(self.times, self.positions, window))

    def retarget(self, joint_map: JointMap | str | Path, back: bool = False) -> "JointTrajectory":
        """Return another robot's trajectory on the joints of a map: see `quadruped_env.trajectory.joint_map`.

        Args:
            joint_map: the map, or the path of its TOML file.
            back: True for the other way: from the map's joints to its sources, in the units of the map.

        Raises:
            QuadrupedError: if the map is invalid, or a joint is missing.
        """
        rules, rows = JointMap.of(joint_map), self.to_rows()
        if back:
            rows = self.select(tuple(rules.rules)).to_rows()
            rows = replace(rows, names=rules.sources, values=rules.to_sources(rows.values))
        else:
            rows = rules.retarget(rows, self.source.name)
        return self._changed(names=rows.names, **_arrays_of(rows))

    def gaps(self, factor: float = 3.0) -> tuple[Gap, ...]:
        """Return times between rows longer than `factor` times the median."""
        return find_gaps(self.stamps, factor)

    def gaps_in_words(self, name: str) -> str:
        """Return the gaps in words, without a full stop, with the recording's name; empty without gaps."""
        gaps = self.gaps()
        if not gaps:
            return ""
        longest = max(gaps, key=lambda gap: gap.seconds)
        return f"{len(gaps)} gaps in {name}, the longest of {longest.seconds:.3g} s at {longest.start:.2f} s"

    @property
    def kinds(self) -> tuple[str, ...]:
        """Names of the arrays: positions, and velocities and efforts if they were recorded."""
        return tuple(self._arrays())

    def _arrays(self) -> dict[str, Floats]:
        """Return the name -> array (T, J), of those that were recorded."""
        arrays = {name: getattr(self, name) for name in ARRAYS.values()}
        return {name: array for name, array in arrays.items() if array is not None}

    def _changed(self, **changes: Any) -> "JointTrajectory":
        """Return the trajectory with other values of some fields, validated."""
        return JointTrajectory(**({field.name: getattr(self, field.name) for field in fields(self)} | changes))


def _arrays_of(rows: Rows) -> dict[str, Any]:
    """Return the name of an array -> its values, None if they were not recorded."""
    return {name: rows.values.get(kind) for kind, name in ARRAYS.items()}
