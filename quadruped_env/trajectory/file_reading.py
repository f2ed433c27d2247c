"""State of one file while it is read: the options, progress, and remarks on its rows."""

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, TypeVar

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, cut
from quadruped_env.trajectory.read_options import ReadOptions
from quadruped_env.trajectory.validation import Source
from quadruped_env.utils.progress import Progress

KEEP: Final = "keep what can be read (--salvage)"
_MAX_RANGES: Final = 5
"""Ranges of rows that a remark lists."""

_Item = TypeVar("_Item")


@dataclass
class Reading:
    """State of one file while it is read."""

    path: Path
    options: ReadOptions
    progress: Progress | None = None
    row_name: str = "row"
    """The format's word for a row"""
    rows: int = 0
    """Rows read so far, kept or not"""
    left_out: Counter[str] = field(default_factory=Counter)
    """Reason for leaving rows out -> number of rows"""
    counted: Counter[str] = field(default_factory=Counter)
    """Remark on single values -> number of values"""
    unchecked: list[tuple[int, int]] = field(default_factory=list)
    """First and last of consecutive rows that were salvaged and that no checksum covers"""
    checked_files: set[Path] = field(default_factory=set)
    """Decompressed files whose checksum was correct"""
    notes: list[str] = field(default_factory=list)
    """Remarks on the file"""
    name: str = ""
    """Name in error messages: the path that the user gave, even if `path` is a decompressed copy"""

    def __post_init__(self) -> None:
        self.name = self.name or str(self.path)

    def source(self, numbers: NDArray[np.int64]) -> Source:
        """The source of rows with these numbers (n,)."""
        return Source(self.name, self.row_name, rows=numbers)

    def error(self, row: int | None, problem: str) -> QuadrupedError:
        """The error for a problem in one row, or with the whole file without a row."""
        place = "" if row is None else f" {self.row_name} {row}:"
        return QuadrupedError(f"{self.name}:{place} {problem}")

    def report_progress(self, fraction: float) -> None:
        """Call the progress callback with a fraction, which may be a little over 1."""
        if self.progress is not None:
            self.progress(min(fraction, 1.0))

    def note(self, text: str) -> None:
        """Add a remark on the file, once."""
        text = cut(text)
        if text not in self.notes:
            self.notes.append(text)

    def damage(self, text: str) -> None:
        """Add a remark on damage. Raises a QuadrupedError if the options do not ask to salvage."""
        if not self.options.salvage:
            raise self.error(None, f"the bag is damaged, cut off, or was not closed: {text}; {KEEP}, or record again")
        self.note(text)

    def count(self, remark: str, number: int = 1) -> None:
        """Count values that a remark applies to."""
        if number:
            self.counted[remark] += number

    def leave_out(self, reason: str, count: int = 1) -> None:
        """Count rows that are not kept."""
        if count:
            self.left_out[reason] += count

    def mark_unchecked(self, first: int, last: int | None = None) -> None:
        """Record that no checksum covers a salvaged row, or the rows up to `last`; called in the order of the rows."""
        last = first if last is None else last
        if self.unchecked and first == self.unchecked[-1][1] + 1:
            first, _ = self.unchecked.pop()
        self.unchecked.append((first, last))

    @property
    def unchecked_rows(self) -> int:
        """Number of rows that were salvaged and that no checksum covers."""
        return sum(last - first + 1 for first, last in self.unchecked)

    def remarks(self) -> tuple[str, ...]:
        """All remarks: the notes, and the counts of values and of rows that were left out."""
        counted = (f"{count} {remark}" for remark, count in self.counted.items())
        left_out = (f"left out {count} of {self.rows}: {reason}" for reason, count in self.left_out.items())
        return (*self.notes, *self._unchecked_remark(), *counted, *left_out)

    def _unchecked_remark(self) -> Iterator[str]:
        if self.unchecked:
            ranges = [str(first) if first == last else f"{first} to {last}" for first, last in self.unchecked]
            where = ", ".join(ranges[:_MAX_RANGES]) + (", ..." if len(ranges) > _MAX_RANGES else "")
            yield (
                f"salvaged without a checksum, so that damage in their numbers would not show: {self.unchecked_rows} "
                f"of {self.rows} {self.row_name}s ({self.row_name} {where})"
            )


def salvaged(
    items: Iterator[_Item], reading: Reading, numbers: Callable[[_Item], tuple[int, int]], is_text: bool
) -> Iterator[_Item]:
    """The items before the damage, with a remark on it, if the options ask to salvage; otherwise all items.

    Args:
        items: of a damaged file, whose iterator raises a QuadrupedError at the damage.
        reading: of the file.
        numbers: called with an item; returns the numbers of its first and last row.
        is_text: whether the file is text, which has no checksums; readers of bags mark their messages themselves.

    Raises:
        QuadrupedError: at the damage, if it is not to be salvaged or no item comes before it.
    """
    first = last = None
    try:
        for item in items:
            start, last = numbers(item)
            first = start if first is None else first
            yield item
    except QuadrupedError as error:
        if not reading.options.salvage or first is None:
            raise
        reading.note(f"damaged, and read up to the damage: {error}")
        if is_text and reading.path not in reading.checked_files:
            reading.mark_unchecked(first, last)
