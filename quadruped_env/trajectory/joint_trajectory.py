"""The one trajectory type: joint states over time."""

import builtins
import operator
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError, QuadrupedWarning
from quadruped_env.robot import JOINT_NAMES
from quadruped_env.trajectory.joint_map import JointMap
from quadruped_env.trajectory.signals import NANOSECONDS, Gap, derivative, find_gaps, interpolate
from quadruped_env.trajectory.validation import (
    IN_MEMORY,
    Source,
    check_finite,
    checked_names,
    checked_stamps,
    checked_values,
    read_only,
)

if TYPE_CHECKING:
    from quadruped_env.trajectory.column_map import ColumnMap


@dataclass(frozen=True, eq=False)
class JointState:
    """One row of a trajectory: what ROS calls a `sensor_msgs/JointState`."""

    stamp: int
    """ns"""
    names: tuple[str, ...]
    """(J,)"""
    position: NDArray[np.float64]
    """rad (J,)"""
    velocity: NDArray[np.float64] | None
    """rad/s (J,)"""
    effort: NDArray[np.float64] | None
    """N m (J,); NaN where it was not measured"""


@dataclass(frozen=True, eq=False, init=False, repr=False)
class JointTrajectory:
    """Joint states over time, checked and read-only.

    Args:
        stamps: ns, integers, rising (T,); T is 1 or more.
        names: one a joint, each once, in the order of the columns (J,). They need not be this robot's.
        positions: rad (T, J), finite.
        velocities: rad/s (T, J), finite; None where they were not recorded.
        efforts: N m (T, J), finite or NaN (not measured); None where they were not recorded.
        source: what errors call it.

    Raises:
        QuadrupedError: if they are not so; the message names the row, the field, the value and the cure.
    """

    stamps: NDArray[np.int64]
    names: tuple[str, ...]
    positions: NDArray[np.float64]
    velocities: NDArray[np.float64] | None
    efforts: NDArray[np.float64] | None
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
        values: dict[str, Any] = {
            "stamps": times,
            "names": joints,
            "positions": checked_values("positions", positions, shape, source),
            "velocities": None if velocities is None else checked_values("velocities", velocities, shape, source),
            "efforts": None if efforts is None else checked_values("efforts", efforts, shape, source),
            "source": source,
        }
        for name in ("positions", "velocities", "efforts"):
            if values[name] is not None:
                check_finite(name, values[name], joints, source)
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @classmethod
    def load(
        cls,
        path: str | Path,
        *,
        columns: "ColumnMap | str | Path | None" = None,
        joint_map: JointMap | str | Path | None = None,
        names: Sequence[str] | None = None,
        topic: str | None = None,
        stamps: str = "header",
        degrees: bool | None = None,
        ignore: Sequence[str] = (),
        sort: bool = False,
        drop: bool = False,
        salvage: bool = False,
        progress: Callable[[float], None] | None = None,
    ) -> "JointTrajectory":
        """Read a trajectory from a file or bag, whose format is recognised by what is in it.

        Formats: this project's CSV (`quadruped_env.trajectory.csv`), any CSV with a column map, what `ros2 topic echo`
        prints (YAML and `--csv`), rosbag2 bags (MCAP and sqlite3, compressed too), ROS 1 bags.

        Args:
            path: of the file, or of a bag's directory.
            columns: which columns of a CSV are what, or the TOML file that says so (`trajectory.column_map`).
            joint_map: takes another robot's joints to this one's, or the TOML file that does (`trajectory.joint_map`).
            names: the joints in their order, for messages that have no names.
            topic: of the joint states in a bag that has several.
            stamps: `header`, or `log` for the time of recording, where publishers left the header's at 0.
            degrees: whether positions and velocities are in degrees (/s) and to be converted; None takes them for
                rad and refuses what looks like degrees; False does not look.
            ignore: `velocity`, `effort` or both: not to be read.
            sort: whether to put rows in the order of their stamps, rather than to refuse falling ones.
            drop: whether to leave out rows that cannot be used, rather than to refuse them: stamps that do not rise,
                numbers that are not finite, messages with other joints or unequal lengths.
            salvage: whether to keep what can be read of a damaged file, rather than to refuse it.
            progress: is told the share that is read.

        Returns:
            The trajectory; `source.notes` say what was left out.

        Raises:
            QuadrupedError: if there is no such file, or something in it is wrong; the message names the file, the
                line or message, the field, the value and the cure.
            MissingExtraError: if the format needs libraries that are not installed.
        """
        from quadruped_env.trajectory import formats

        options = formats.options(
            columns=columns,
            joint_map=joint_map,
            names=None if names is None else tuple(names),
            topic=topic,
            stamps=stamps,
            degrees=degrees,
            ignore=tuple(ignore),
            sort=sort,
            drop=drop,
            salvage=salvage,
        )
        return formats.load(path, options, progress)

    def save(
        self,
        path: str | Path,
        overwrite: bool = False,
        *,
        storage: str | None = None,
        tf_rate: float = 20.0,
        compress: bool = False,
        base_pose: ArrayLike | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> None:
        """Write the trajectory to a file or bag, in full or not at all; `load` gives it back to the last bit.

        Args:
            path: `NAME.csv` is this project's CSV, `NAME` a directory with a rosbag2 bag, and `NAME.mcap` or `NAME.db3`
                a bag's bare storage file. Directories on the way are made. Bags are for Humble and later, and hold
                `/joint_states` and, for this robot's joints, `/robot_description`, `/tf` and `/tf_static`.
            overwrite: whether to replace a file or bag that is already there.
            storage: of a bag in a directory: `mcap` (unless said otherwise) or `sqlite3`.
            tf_rate: Hz of `/tf`, which stands at multiples of its period; 0 leaves it out.
            compress: whether to compress a bag with zstd.
            base_pose: position in m and quaternion wxyz of `base_link` in `odom` (T, 7), to be part of `/tf`.
            progress: is told the share that is written.

        Raises:
            QuadrupedError: if the file is there already, or cannot be written.
            MissingExtraError: if a bag is to be written and the libraries for it are not installed.
        """
        from quadruped_env.trajectory import saving

        base = None if base_pose is None else checked_values("base_pose", base_pose, (len(self), 7), self.source)
        options = saving.WriteOptions(storage, tf_rate, compress, overwrite)
        saving.save(saving.pieces_of(self, base, progress), Path(path), options)

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
    def _nanoseconds(self) -> NDArray[np.float64]:
        """Time from the first stamp, ns (T,)."""
        return (self.stamps - self.stamps[0]).astype(np.float64)

    @cached_property
    def times(self) -> NDArray[np.float64]:
        """Time from the first stamp, s (T,)."""
        return read_only(self._nanoseconds / NANOSECONDS)

    @property
    def duration(self) -> float:
        """Time from the first stamp to the last, s."""
        return float(self.times[-1])

    def select(self, names: Sequence[str]) -> "JointTrajectory":
        """The trajectory with these joints only, in this order.

        Raises:
            QuadrupedError: if one of them is missing.
        """
        if tuple(names) == self.names:
            return self
        for name in names:
            if name not in self.names:
                raise QuadrupedError(
                    f"{self.source.name}: joint {name!r} is missing; all {len(names)} are needed, and it has "
                    f"{', '.join(self.names)}; add its positions, or map another robot's joints (--map)"
                )
        order = [self.names.index(name) for name in names]
        return self._changed(names=names, **{kind: array[:, order] for kind, array in self._arrays().items()})

    def in_joint_order(self) -> "JointTrajectory":
        """The trajectory with this robot's joints in the order of `JOINT_NAMES`.

        Warns:
            QuadrupedWarning: of joints that this robot does not have; they are left out.

        Raises:
            QuadrupedError: if a joint is missing.
        """
        ordered = self.select(JOINT_NAMES)
        unknown = [name for name in self.names if name not in JOINT_NAMES]
        if unknown:
            warnings.warn(
                f"{self.source.name}: left out what this robot does not have: {', '.join(unknown)}",
                QuadrupedWarning,
                stacklevel=2,
            )
        return ordered

    @cached_property
    def _joint_positions(self) -> NDArray[np.float64]:
        return self.in_joint_order().positions

    def positions_at(self, seconds: ArrayLike) -> NDArray[np.float64]:
        """Joint positions (..., 8) in rad, in the order of `JOINT_NAMES`, at times (...,) in s from the first stamp.

        Linear between rows; before the first and after the last it holds their values. At a row's own time it
        gives that row's values to the last bit.

        Raises:
            QuadrupedError: if a joint is missing, or a time is NaN.
        """
        positions = self._joint_positions
        time = np.asarray(seconds, dtype=np.float64) * NANOSECONDS
        if np.isnan(time).any():
            raise QuadrupedError(f"{self.source.name}: positions_at: a time is NaN; give numbers, in s")
        time = time.clip(0.0, self._nanoseconds[-1])
        # k times a period in s is rarely a whole number of ns in floating point, and means one.
        whole = np.rint(time)
        time = np.where(np.abs(time - whole) <= 1e-15 * whole, whole, time)
        return interpolate(self._nanoseconds, positions, time)

    def at(self, stamps: ArrayLike) -> "JointTrajectory":
        """The trajectory with rows at these stamps, in ns, on straight lines between its own.

        Raises:
            QuadrupedError: if the stamps do not rise, or one lies before the first or after the last of its own.
        """
        wanted = checked_stamps(stamps, Source(f"{self.source.name}: at"))
        if wanted[0] < self.stamps[0] or wanted[-1] > self.stamps[-1]:
            outside = wanted[0] if wanted[0] < self.stamps[0] else wanted[-1]
            raise QuadrupedError(
                f"{self.source.name}: at: stamp {outside} ns lies outside the recording, {self.stamps[0]} to "
                f"{self.stamps[-1]} ns; ask for stamps within it"
            )
        nanoseconds = (wanted - self.stamps[0]).astype(np.float64)
        return self._changed(
            stamps=wanted,
            source=Source(self.source.name),
            **{kind: interpolate(self._nanoseconds, array, nanoseconds) for kind, array in self._arrays().items()},
        )

    def resample(self, rate: float) -> "JointTrajectory":
        """The trajectory with rows at an even rate, in Hz, from its first stamp on; straight lines between its own.

        Nothing is filtered: what swings faster than half the rate becomes something slower.

        Raises:
            QuadrupedError: if the rate is not above 0, or above 1 GHz.
        """
        if not 0.0 < rate <= NANOSECONDS:
            raise QuadrupedError(f"{self.source.name}: resample: expected a rate above 0 Hz; found {rate!r}")
        count = int(self._nanoseconds[-1] * rate / NANOSECONDS + 1e-6) + 1
        nanoseconds = np.rint(np.arange(count) * (NANOSECONDS / rate)).astype(np.int64)
        return self.at(np.minimum(self.stamps[0] + nanoseconds, self.stamps[-1]))

    def slice(self, start: float | None = None, stop: float | None = None) -> "JointTrajectory":
        """The rows from `start` on and before `stop`, in s from the first stamp; None is the end of that side.

        Raises:
            QuadrupedError: if no row is left.
        """
        first = 0 if start is None else int(np.searchsorted(self.times, start))
        last = len(self) if stop is None else int(np.searchsorted(self.times, stop))
        if first >= last:
            raise QuadrupedError(
                f"{self.source.name}: slice: no row between {start} and {stop} s; it lasts {self.duration:g} s"
            )
        return self.rows(np.s_[first:last])

    def rows(self, rows: builtins.slice) -> "JointTrajectory":
        """Rows that follow each other, by their numbers, counted from 0.

        Raises:
            QuadrupedError: if it is none, or they do not follow each other.
        """
        start, stop, step = rows.indices(len(self))
        if step != 1 or start >= stop:
            raise QuadrupedError(f"{self.source.name}: rows: expected rows that follow each other; found {rows}")
        known = self.source.rows
        source = replace(
            self.source,
            first_row=self.source.first_row + start,
            rows=None if known is None else known[start:stop],
        )
        arrays = {kind: array[start:stop] for kind, array in self._arrays().items()}
        return self._changed(stamps=self.stamps[start:stop], source=source, **arrays)

    def differentiate(self, window: float = 0.05) -> "JointTrajectory":
        """The trajectory with velocities that are made of its positions, filtered and not delayed.

        Args:
            window: s, over which a parabola is fitted around every row; at least three rows. A longer one is smoother.

        Raises:
            QuadrupedError: if the window is not above 0, or there is one row only.
        """
        if not 0.0 < window < np.inf or len(self) == 1:
            raise QuadrupedError(
                f"{self.source.name}: differentiate: expected a window above 0 s and two rows or more; found "
                f"{window!r} and {len(self)}"
            )
        rows = max(3, 2 * round(window / (2.0 * float(np.median(np.diff(self.times))))) + 1)
        return self._changed(velocities=derivative(self.times, self.positions, rows))

    def retarget(self, joint_map: JointMap | str | Path) -> "JointTrajectory":
        """Another robot's trajectory on the joints of a map: see `quadruped_env.trajectory.joint_map`.

        Args:
            joint_map: the map, or the TOML file that it is in.

        Raises:
            QuadrupedError: if the map is wrong, or a joint that it names as a source is missing.
        """
        if not isinstance(joint_map, JointMap):
            joint_map = JointMap.load(joint_map)
        for joint, rule in joint_map.rules.items():
            if rule.source is not None and rule.source not in self.names:
                raise QuadrupedError(
                    f"{joint_map.name}: [joints.{joint}] source: {self.source.name} has no joint {rule.source!r}; "
                    f"it has {', '.join(self.names)}"
                )
        rules = joint_map.rules.values()
        offsets = np.array([rule.offset_rad for rule in rules])
        factors = np.array([rule.factor for rule in rules])
        velocity_factors = np.array([rule.velocity_factor for rule in rules])
        gears = np.array([rule.gear for rule in rules])

        def of_sources(array: NDArray[np.float64], missing: float) -> NDArray[np.float64]:
            columns = [
                np.full(len(self), missing) if rule.source is None else array[:, self.names.index(rule.source)]
                for rule in rules
            ]
            return np.stack(columns, axis=1)

        return self._changed(
            names=tuple(joint_map.rules),
            positions=of_sources(self.positions, 0.0) * factors + offsets,
            velocities=None if self.velocities is None else of_sources(self.velocities, 0.0) * velocity_factors,
            efforts=None if self.efforts is None else of_sources(self.efforts, np.nan) / gears,
        )

    def from_degrees(self) -> "JointTrajectory":
        """The trajectory in rad and rad/s, for one whose numbers are degrees and degrees/s."""
        velocities = None if self.velocities is None else np.radians(self.velocities)
        return self._changed(positions=np.radians(self.positions), velocities=velocities)

    def gaps(self, factor: float = 3.0) -> tuple["Gap", ...]:
        """Where rows are missing: times between rows longer than `factor` times the usual (the median)."""
        return find_gaps(self.stamps, factor)

    @property
    def kinds(self) -> tuple[str, ...]:
        """Which arrays are there: positions, and velocities and efforts if they were recorded."""
        return tuple(self._arrays())

    def _arrays(self) -> dict[str, NDArray[np.float64]]:
        """The arrays (T, J) that are there, by name."""
        arrays = {"positions": self.positions, "velocities": self.velocities, "efforts": self.efforts}
        return {name: array for name, array in arrays.items() if array is not None}

    def _changed(self, **changes: Any) -> "JointTrajectory":
        """The trajectory with other values of some of its fields."""
        return JointTrajectory(**({field.name: getattr(self, field.name) for field in fields(self)} | changes))
