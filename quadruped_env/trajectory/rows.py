"""Joint states as plain arrays, which readers and writers of all formats exchange, and their validation."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.arrays import Bools, Floats

ARRAYS: Final = {"position": "positions", "velocity": "velocities", "effort": "efforts"}
"""Kind of value, named as in ROS's message and in its order -> the array of a `JointTrajectory` that holds it."""
KINDS: Final = tuple(ARRAYS)

TORQUE_ONLY: Final = (
    "torque-only: efforts and no positions, and a joint state needs the position of every joint; record them too"
)
"""Why recordings of torque commands cannot be used, for error messages."""


@dataclass(frozen=True, eq=False)
class JointState:
    """One row of a trajectory: in ROS, a `sensor_msgs/JointState`."""

    stamp: int
    """ns"""
    names: tuple[str, ...]
    """(J,)"""
    position: Floats
    """rad (J,)"""
    velocity: Floats | None
    """rad/s (J,)"""
    effort: Floats | None
    """N m (J,); NaN where it was not measured"""


@dataclass(frozen=True, eq=False)
class Source:
    """Origin of a trajectory's rows, for error messages."""

    name: str = "JointTrajectory"
    """A file, or the type for a trajectory made in memory"""
    row_name: str = "row"
    """The source's word for a row, such as `line` or `message`"""
    numbers: NDArray[np.int64] | None = None
    """The source's numbers of the rows (T,); None counts them from 0"""
    notes: tuple[str, ...] = ()
    """Remarks on the numbers: rows that were left out, damage, what is not plausible"""

    def row(self, index: int) -> str:
        """Return the name of a row, for error messages."""
        return f"{self.name}: {self.row_name} {index if self.numbers is None else int(self.numbers[index])}"


@dataclass(frozen=True, eq=False)
class Rows:
    """Consecutive joint states of a recording, not validated: see `validation.validate`."""

    numbers: NDArray[np.int64]
    """Line or message numbers in the file (n,)"""
    stamps: NDArray[np.int64]
    """Timestamps in ns (n,)"""
    names: tuple[str, ...]
    """Joints (J,)"""
    values: dict[str, Floats]
    """Kind -> (n, J) in rad, rad/s or N m, in the order of `KINDS`; velocities and efforts only if recorded"""

    def __len__(self) -> int:
        return len(self.stamps)

    def take(self, index: Any) -> "Rows":
        """Return the rows that a NumPy index, mask or slice selects."""
        values = {kind: array[index] for kind, array in self.values.items()}
        return Rows(self.numbers[index], self.stamps[index], self.names, values)


_NOT_FINITE: Final = {
    "position": "leave the row out (--repair drop)",
    "velocity": "leave the velocities out if not all are known (--ignore velocity)",
    "effort": "NaN stands for an effort that was not measured",
}
"""Kind -> the fix for a value that is not finite."""


IN_MEMORY: Final = Source()
"""The source of a trajectory that was not read from a file."""


def read_only(array: NDArray[Any]) -> NDArray[Any]:
    """Return the same array, made read-only."""
    array.flags.writeable = False
    return array


def validate(rows: Rows, source: Source) -> None:
    """Raise a QuadrupedError unless the rows can become a trajectory; the message names the row and the field."""
    checked_names(rows.names, source)
    _check_order(rows.stamps, source)
    for kind, values in rows.values.items():
        check_finite(kind, values, rows.names, source)


def checked_names(names: Sequence[str], source: Source) -> tuple[str, ...]:
    """Return joint names, each once. Raises a QuadrupedError if a name is empty or repeated, or there is none."""
    if isinstance(names, str) or not all(isinstance(name, str) and name for name in names) or not len(names):
        raise QuadrupedError(f"{source.name}: names must be joint names, one per column; found {names!r}")
    for i, name in enumerate(names):
        if name in names[:i]:
            raise QuadrupedError(f"{source.name}: joint {name!r} is named twice; keep one of its columns")
    return tuple(names)


def checked_stamps(stamps: ArrayLike, source: Source) -> NDArray[np.int64]:
    """Return timestamps (T,) in ns, increasing, not negative, read-only; T is 1 or more.

    Raises:
        QuadrupedError: if they have another shape or type, are negative or do not increase.
    """
    raw = np.asarray(stamps)
    if raw.ndim != 1 or not len(raw):
        raise QuadrupedError(
            f"{source.name}: stamps: expected shape (T,), T 1 or more; found {raw.shape}; record one row or more"
        )
    if raw.dtype.kind not in "iu" or raw.max() > np.iinfo(np.int64).max:
        raise QuadrupedError(
            f"{source.name}: stamps: expected whole ns within int64; found {raw.dtype}; "
            f"from seconds: np.rint(seconds * 1e9).astype(np.int64)"
        )
    array = raw if raw.dtype == np.int64 and not raw.flags.writeable else raw.astype(np.int64)
    _check_order(array, source)
    return read_only(array)


def _check_order(stamps: NDArray[np.int64], source: Source) -> None:
    """Raise a QuadrupedError if a timestamp is negative, or not later than the one before."""
    if stamps[0] < 0:
        raise QuadrupedError(f"{source.row(0)}, stamp_ns: {stamps[0]} is negative; count from 0 or later")
    repeated = np.flatnonzero(stamps[1:] <= stamps[:-1])
    if len(repeated):
        i = int(repeated[0]) + 1
        raise QuadrupedError(
            f"{source.row(i)}, stamp_ns: {stamps[i]} does not come after {stamps[i - 1]} of the row before; sort the "
            f"rows by time (--repair sort), and keep one row per timestamp (--repair drop leaves out those that are "
            f"not later); or, if the clock was set back or repeats, give the time from row to row in s (--stamps 0.01)"
        )


def checked_values(name: str, values: ArrayLike, shape: tuple[int, int], source: Source) -> Floats:
    """Return numbers of a shape, finite or not, read-only.

    Raises:
        QuadrupedError: if they are not numbers or have another shape.
    """
    try:
        raw = np.asarray(values)
    except ValueError:  # rows of unequal lengths
        raw = np.empty(0, dtype=object)
    if raw.dtype.kind not in "fiu" or raw.shape != shape:
        found = "rows of unequal lengths or not numbers" if raw.dtype.kind not in "fiu" else str(raw.shape)
        raise QuadrupedError(
            f"{source.name}: {name} must be numbers of shape {shape}, one row per timestamp and one column per name; "
            f"found {found}; leave out rows and columns without a partner"
        )
    # A read-only array needs no copy.
    if raw.dtype == np.float64 and not raw.flags.writeable:
        return raw
    return read_only(np.array(raw, dtype=np.float64))


def check_finite(kind: str, values: Floats, names: tuple[str, ...], source: Source) -> None:
    """Raise a QuadrupedError if a position or velocity is not finite, or an effort infinite."""
    bad = invalid(kind, values)
    if bad.any():
        row, column = np.argwhere(bad)[0]
        raise QuadrupedError(
            f"{source.row(row)}, {kind}.{names[column]}: {values[row, column]} is not finite; {_NOT_FINITE[kind]}"
        )


def invalid(kind: str, values: Floats) -> Bools:
    """Return the mask of invalid values: positions and velocities must be finite, and efforts may be NaN."""
    return np.isinf(values) if kind == "effort" else ~np.isfinite(values)
