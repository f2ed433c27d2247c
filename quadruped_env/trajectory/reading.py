"""The options for reading a recording, and the state of one file while it is read."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, TypeVar

from quadruped_env.errors import QuadrupedError, cut
from quadruped_env.trajectory.column_map import ColumnMap
from quadruped_env.trajectory.joint_map import JointMap
from quadruped_env.trajectory.rows import KINDS
from quadruped_env.utils.progress import Progress

STAMPS: Final = ("header", "log")
"""Sources of a message's timestamp: its header, or the time at which it was recorded."""
UNITS: Final = ("rad", "deg")
REPAIRS: Final = {
    "merge": "make one row of messages that hold some of the robot's joints each, once all have come again",
    "sort": "sort the rows by timestamp",
    "drop": "leave out rows that cannot be used (timestamps that do not increase, NaN, other joints), and count them",
    "despike": "leave out rows in which a joint is elsewhere for five rows or fewer",
    "salvage": "keep the readable part of a damaged file",
}
"""Repair -> its description."""
KEEP: Final = "keep what can be read (--repair salvage)"

_Item = TypeVar("_Item")


@dataclass(frozen=True)
class ReadOptions:
    """Options for reading a recording, the keyword arguments of `JointTrajectory.load`.

    Raises:
        QuadrupedError: if a value is unknown, or two options contradict each other.
    """

    topic: str | None = None
    """Topic of the joint states, for a bag that has several; to merge topics, their names with commas between."""
    columns: ColumnMap | str | Path | None = None
    """Map of the columns of a CSV, or the path of its TOML file (`quadruped_env.trajectory.column_map`)"""
    joint_map: JointMap | str | Path | None = None
    """Map of another robot's joints to this one's, or its TOML file's path (`quadruped_env.trajectory.joint_map`)."""
    names: tuple[str, ...] | None = None
    """Names of the joints in their order, for messages without names; of a CSV without a map, the columns of the
    positions (default: the built-in robot's joints)"""
    unit: str | None = None
    """`deg` converts positions and velocities from degrees and degrees/s, `rad` takes them as they are. None does too,
    but raises an error if they look like degrees"""
    stamps: str | float = "header"
    """Source of a message's timestamp: `header`, or `log` for the time of recording, for publishers that leave the
    header's at 0. A number is the time from row to row in s, and replaces all timestamps"""
    ignore: Sequence[str] = ()
    """`velocity`, `effort` or both: values that are not read"""
    unwrap: float | None = None
    """Angle in rad, such as 2 pi, after which encoders begin again: positions go on there"""
    repair: Sequence[str] = ()
    """Repairs, of `REPAIRS`; what they leave out is noted"""

    def __post_init__(self) -> None:
        for name, convert in (("columns", ColumnMap.of), ("joint_map", JointMap.of), ("names", tuple)):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, convert(getattr(self, name)))
        if self.stamps not in STAMPS and not 1e-6 <= (self.period or 0.0) <= 1e6:
            raise QuadrupedError(
                f"stamps: expected one of {', '.join(STAMPS)}, or the time from row to row, 1e-6 to 1e6 s; found "
                f"{self.stamps!r}"
            )
        if self.unwrap is not None and not 0.01 <= self.unwrap <= 1e3:
            raise QuadrupedError(f"unwrap: expected an angle from 0.01 to 1000 rad; found {self.unwrap!r}")
        for name, given, known in (
            ("unit", [] if self.unit is None else [self.unit], UNITS),
            ("ignore", self.ignore, KINDS[1:]),
            ("repair", self.repair, tuple(REPAIRS)),
        ):
            for value in given:
                if value not in known:
                    raise QuadrupedError(f"{name}: expected {' or '.join(known)}; found {value!r}")
        if self.unit == "deg" and isinstance(self.joint_map, JointMap):
            for joint, rule in self.joint_map.rules.items():
                if rule.unit != "rad" or rule.velocity_unit is not None:
                    raise QuadrupedError(
                        f"{self.joint_map.name}: [joints.{joint}] has units of its own, so --unit deg would "
                        f"convert them twice; leave --unit out"
                    )

    @property
    def period(self) -> float | None:
        """Time from row to row, s, if it replaces the timestamps or there are none."""
        if self.stamps in STAMPS:
            return self.columns.period if isinstance(self.columns, ColumnMap) else None
        try:
            return float(self.stamps)
        except (TypeError, ValueError):
            return None


@dataclass
class Reading:
    """State of one file while it is read: the options, progress, and remarks on its rows."""

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
    unchecked: int = 0
    """Number of rows that were salvaged and that no checksum covers"""
    checked_files: set[Path] = field(default_factory=set)
    """Decompressed files whose checksum was correct"""
    notes: list[str] = field(default_factory=list)
    """Remarks on the file"""
    name: str = ""
    """Name in error messages: the path that the user gave, even if `path` is a decompressed copy"""

    def __post_init__(self) -> None:
        self.name = self.name or str(self.path)

    def repairs(self, repair: str) -> bool:
        """Return True if the options ask for a repair."""
        return repair in self.options.repair

    def error(self, row: int | None, problem: str) -> QuadrupedError:
        """Return the error for a problem in one row, or with the whole file without a row."""
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
        if not self.repairs("salvage"):
            raise self.error(None, f"the bag is damaged, cut off, or was not closed: {text}; {KEEP}, or record again")
        self.note(text)

    def remarks(self) -> tuple[str, ...]:
        """Return all remarks: the notes, and the counts of values and of rows that were left out."""
        unchecked = (
            f"salvaged without a checksum, so that damage in their numbers would not show: {self.unchecked} of "
            f"{self.rows} {self.row_name}s"
        )
        counted = (f"{count} {remark}" for remark, count in self.counted.items() if count)
        left_out = (f"left out {count} of {self.rows}: {reason}" for reason, count in self.left_out.items() if count)
        return (*self.notes, *([unchecked] if self.unchecked else ()), *counted, *left_out)


def salvaged(items: Iterator[_Item], reading: Reading, is_text: bool) -> Iterator[_Item]:
    """Yield the rows before the damage, with a remark on it, if the options ask to salvage; otherwise all rows.

    Args:
        items: rows of a damaged file, whose iterator raises a QuadrupedError at the damage.
        reading: of the file.
        is_text: whether the file is text, which has no checksums; readers of bags count their messages themselves.

    Raises:
        QuadrupedError: at the damage, if it is not to be salvaged or no row comes before it.
    """
    count = 0
    try:
        for item in items:
            count += 1
            yield item
    except QuadrupedError as error:
        if not reading.repairs("salvage") or not count:
            raise
        reading.note(f"damaged, and read up to the damage: {error}")
        if is_text and reading.path not in reading.checked_files:
            reading.unchecked += count
