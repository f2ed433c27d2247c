"""What a trajectory must be, and how its errors name a row."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError

_ROWS_A_CHECK: Final = 65536


@dataclass(frozen=True, eq=False)
class Source:
    """Where a trajectory's rows came from, as errors name it."""

    name: str = "JointTrajectory"
    """A file, or the type for one made in memory"""
    row_name: str = "row"
    """What the source calls a row"""
    first_row: int = 0
    """The number that it gives to the first one"""
    rows: NDArray[np.int64] | None = None
    """The numbers that it gives to all (T,), where they do not follow each other"""
    notes: tuple[str, ...] = ()
    """What to know about the numbers: rows that were left out, damage"""

    def row(self, index: int) -> str:
        """How to find one row."""
        number = self.first_row + index if self.rows is None else self.rows[index]
        return f"{self.name}: {self.row_name} {number}"


IN_MEMORY: Final = Source()
"""Of a trajectory that comes from no file"""


def read_only(array: NDArray[Any]) -> NDArray[Any]:
    """The array, which nobody can write to any more."""
    array.flags.writeable = False
    return array


def checked_names(names: Sequence[str], source: Source) -> tuple[str, ...]:
    """Joint names, each once.

    Raises:
        QuadrupedError: if they are not so.
    """
    if isinstance(names, str) or not all(isinstance(name, str) and name for name in names) or not len(names):
        raise QuadrupedError(f"{source.name}: names must be joint names, one a column; found {names!r}")
    for i, name in enumerate(names):
        if name in names[:i]:
            raise QuadrupedError(f"{source.name}: joint {name!r} is named twice; keep one of its columns")
    return tuple(names)


def checked_stamps(stamps: ArrayLike, source: Source) -> NDArray[np.int64]:
    """Stamps (T,) in ns, rising, not negative, read-only; T is 1 or more.

    Raises:
        QuadrupedError: if they are not so.
    """
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
    array = raw if raw.dtype == np.int64 and not raw.flags.writeable else raw.astype(np.int64)
    if array[0] < 0:
        raise QuadrupedError(f"{source.row(0)}, stamp_ns: {array[0]} is negative; count from 0 or later")
    falling = np.flatnonzero(array[1:] <= array[:-1])
    if len(falling):
        i = falling[0] + 1
        raise falling_stamp(source, int(i), int(array[i]), int(array[i - 1]))
    return read_only(array)


def falling_stamp(source: Source, row: int, stamp: int, before: int) -> QuadrupedError:
    """The error for a row whose stamp does not come after that of the row before."""
    return QuadrupedError(
        f"{source.row(row)}, stamp_ns: {stamp} does not come after {before} of the row before; put the rows in order "
        f"of time (--sort), and keep one row a stamp (--drop leaves out those that are not later)"
    )


def checked_values(name: str, values: ArrayLike, shape: tuple[int, int], source: Source) -> NDArray[np.float64]:
    """Numbers of that shape, read-only, whatever they are.

    Raises:
        QuadrupedError: if they are not so.
    """
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
    # Of an array that nobody can write to, no copy is needed.
    if raw.dtype == np.float64 and not raw.flags.writeable:
        return raw
    return read_only(np.array(raw, dtype=np.float64))


_FIELDS: Final = {
    "positions": ("position", "leave the row out (--drop)"),
    "velocities": ("velocity", "leave the velocities out if not all are known (--ignore velocity)"),
    "efforts": ("effort", "NaN stands for an effort that was not measured"),
}
"""Array -> its name in a `JointState`, and what to do about a value that is not finite."""


def check_finite(name: str, values: NDArray[np.float64], names: tuple[str, ...], source: Source) -> None:
    """Raise a QuadrupedError if a position or velocity is not finite, or an effort infinite."""
    # In blocks: a mask of a long recording is as large as one of its joints.
    for start in range(0, len(values), _ROWS_A_CHECK):
        block = values[start : start + _ROWS_A_CHECK]
        bad = np.isinf(block) if name == "efforts" else ~np.isfinite(block)
        if bad.any():
            row, column = np.argwhere(bad)[0]
            singular, cure = _FIELDS[name]
            raise QuadrupedError(
                f"{source.row(start + row)}, {singular}.{names[column]}: {block[row, column]} is not finite; {cure}"
            )
