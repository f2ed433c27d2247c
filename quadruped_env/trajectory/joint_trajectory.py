"""The one trajectory type: joint states over time."""

import operator
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Final, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import JOINT_NAMES

NANOSECONDS: Final = 1e9
"""in a second"""


@dataclass(frozen=True)
class Source:
    """Where a trajectory's rows came from, as errors name it."""

    name: str = "JointTrajectory"
    """A file, or the type for one made in memory"""
    row_name: str = "row"
    """What the source calls a row"""
    first_row: int = 0
    """The number that it gives to the first one"""

    def row(self, index: int) -> str:
        """How to find one row."""
        return f"{self.name}: {self.row_name} {self.first_row + index}"


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
        source: Source = Source(),
    ) -> None:
        checked_names = _checked_names(names, source)
        checked_stamps = _checked_stamps(stamps, source)
        shape = len(checked_stamps), len(checked_names)
        values: dict[str, Any] = {
            "stamps": checked_stamps,
            "names": checked_names,
            "positions": _checked_values("positions", positions, shape, source),
            "velocities": None if velocities is None else _checked_values("velocities", velocities, shape, source),
            "efforts": None if efforts is None else _checked_values("efforts", efforts, shape, source),
            "source": source,
        }
        for name in ("positions", "velocities", "efforts"):
            if values[name] is not None:
                _check_finite(name, values[name], checked_names, source)
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read a trajectory from a file: see `quadruped_env.trajectory.csv` for the format.

        Raises:
            QuadrupedError: if there is no such file, or something in it is wrong; the message names the file, the
                line, the field, the value and the cure.
        """
        from quadruped_env.trajectory import csv

        stamps, names, values, source = csv.read(Path(path))
        return cls(stamps, names, values["position"], values.get("velocity"), values.get("effort"), source)

    def save(self, path: str | Path, overwrite: bool = False) -> None:
        """Write the trajectory to a file, in full or not at all; `load` gives it back to the last bit.

        Args:
            path: ends in `.csv`; directories on the way are made.
            overwrite: whether to replace a file that is already there.

        Raises:
            QuadrupedError: if the file is there already, or cannot be written.
        """
        from quadruped_env.trajectory import csv

        values = {"position": self.positions, "velocity": self.velocities, "effort": self.efforts}
        csv.write(Path(path), self.stamps, self.names, values, overwrite)

    def __repr__(self) -> str:
        kinds = [name for name in ("velocities", "efforts") if getattr(self, name) is not None]
        return (
            f"JointTrajectory({len(self)} rows over {self.duration:g} s, {len(self.names)} joints, "
            f"{' and '.join(['positions', *kinds])})"
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
        return _read_only(self._nanoseconds / NANOSECONDS)

    @property
    def duration(self) -> float:
        """Time from the first stamp to the last, s."""
        return float(self.times[-1])

    def in_joint_order(self) -> "JointTrajectory":
        """The trajectory with its columns in the order of `JOINT_NAMES`.

        Raises:
            QuadrupedError: if a joint is unknown or missing.
        """
        if self.names == JOINT_NAMES:
            return self
        for name in self.names:
            if name not in JOINT_NAMES:
                raise QuadrupedError(
                    f"{self.source.name}: unknown joint {name!r}; this robot's joints are {', '.join(JOINT_NAMES)}; "
                    f"rename it, or leave it out"
                )
        for name in JOINT_NAMES:
            if name not in self.names:
                raise QuadrupedError(
                    f"{self.source.name}: joint {name!r} is missing; all {len(JOINT_NAMES)} are needed, and it has "
                    f"{', '.join(self.names)}; add its positions"
                )
        order = [self.names.index(name) for name in JOINT_NAMES]
        return JointTrajectory(
            self.stamps,
            JOINT_NAMES,
            self.positions[:, order],
            None if self.velocities is None else self.velocities[:, order],
            None if self.efforts is None else self.efforts[:, order],
            self.source,
        )

    @cached_property
    def _joint_positions(self) -> NDArray[np.float64]:
        return self.in_joint_order().positions

    def positions_at(self, seconds: ArrayLike) -> NDArray[np.float64]:
        """Joint positions (..., 8) in rad, in the order of `JOINT_NAMES`, at times (...,) in s from the first stamp.

        Linear between rows; before the first and after the last it holds their values. At a row's own time it
        gives that row's values to the last bit.

        Raises:
            QuadrupedError: if a joint is unknown or missing, or a time is NaN.
        """
        positions = self._joint_positions
        time = np.asarray(seconds, dtype=np.float64) * NANOSECONDS
        if np.isnan(time).any():
            raise QuadrupedError(f"{self.source.name}: positions_at: a time is NaN; give numbers, in s")
        stamps = self._nanoseconds
        time = time.clip(0.0, stamps[-1])
        # k times a period in s is rarely a whole number of ns in floating point, and means one.
        whole = np.rint(time)
        time = np.where(np.abs(time - whole) <= 1e-15 * whole, whole, time)
        before = np.searchsorted(stamps, time, side="right") - 1
        after = np.minimum(before + 1, len(stamps) - 1)
        share = (time - stamps[before]) / np.maximum(stamps[after] - stamps[before], 1.0)
        return positions[before] + share[..., None] * (positions[after] - positions[before])


def _read_only(array: NDArray[Any]) -> NDArray[Any]:
    array.flags.writeable = False
    return array


def _checked_names(names: Sequence[str], source: Source) -> tuple[str, ...]:
    if isinstance(names, str) or not all(isinstance(name, str) and name for name in names) or not len(names):
        raise QuadrupedError(f"{source.name}: names must be joint names, one a column; found {names!r}")
    for i, name in enumerate(names):
        if name in names[:i]:
            raise QuadrupedError(f"{source.name}: joint {name!r} is named twice; keep one of its columns")
    return tuple(names)


def _checked_stamps(stamps: ArrayLike, source: Source) -> NDArray[np.int64]:
    raw = np.asarray(stamps)
    if raw.ndim != 1 or not len(raw):
        raise QuadrupedError(
            f"{source.name}: stamps must have shape (T,), T 1 or more; found {raw.shape}; record one row or more"
        )
    if raw.dtype.kind not in "iu" or raw.max() > np.iinfo(np.int64).max:
        raise QuadrupedError(
            f"{source.name}: stamps must be whole ns within int64; found {raw.dtype}; "
            f"from seconds: np.rint(seconds * 1e9).astype(np.int64)"
        )
    array = raw.astype(np.int64)
    if array[0] < 0:
        raise QuadrupedError(f"{source.row(0)}, stamp_ns: {array[0]} is negative; count from 0 or later")
    falling = np.flatnonzero(array[1:] <= array[:-1])
    if len(falling):
        i = falling[0] + 1
        raise QuadrupedError(
            f"{source.row(i)}, stamp_ns: {array[i]} does not come after {array[i - 1]} of the row before; "
            f"put the rows in order of time and keep one row a stamp"
        )
    return _read_only(array)


def _checked_values(name: str, values: ArrayLike, shape: tuple[int, int], source: Source) -> NDArray[np.float64]:
    try:
        raw = np.asarray(values)
    except ValueError:  # rows of unequal lengths
        raw = np.empty(0, dtype=object)
    if raw.dtype.kind not in "fiu" or raw.shape != shape:
        found = "rows of unequal lengths or not numbers" if raw.dtype.kind not in "fiu" else str(raw.shape)
        raise QuadrupedError(
            f"{source.name}: {name} must be numbers of shape {shape}, one row a stamp and one column a name; "
            f"found {found}; leave out what has no partner"
        )
    return _read_only(np.array(raw, dtype=np.float64))


_FIELDS: Final = {
    "positions": ("position", "leave the row out"),
    "velocities": ("velocity", "leave the velocities out if not all are known"),
    "efforts": ("effort", "NaN stands for an effort that was not measured"),
}
"""Array -> its name in a `JointState`, and what to do about a value that is not finite."""


def _check_finite(name: str, values: NDArray[np.float64], names: tuple[str, ...], source: Source) -> None:
    bad = np.isinf(values) if name == "efforts" else ~np.isfinite(values)
    if bad.any():
        row, column = np.argwhere(bad)[0]
        singular, cure = _FIELDS[name]
        raise QuadrupedError(
            f"{source.row(row)}, {singular}.{names[column]}: {values[row, column]} is not finite; {cure}"
        )
