"""What every format shares in being read: the options, the blocks of rows, and how messages become blocks."""

import math
from array import array
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, cut, short
from quadruped_env.ros.joint_state import RawJointState
from quadruped_env.trajectory.joint_map import JointMap
from quadruped_env.trajectory.joint_trajectory import JointTrajectory
from quadruped_env.trajectory.validation import Source

if TYPE_CHECKING:
    from quadruped_env.trajectory.column_map import ColumnMap

KINDS: Final = ("position", "velocity", "effort")
"""What a joint state holds of a joint, in the order of ROS's message"""
STAMPS: Final = ("header", "log")
"""Whose time a message's stamp is: the header's, or that of its recording"""

TORQUE_ONLY: Final = (
    "torque-only: efforts and no positions, and a joint state needs the position of every joint; record them too"
)
"""What is wrong with commands of torques and the like"""

_ROWS_A_BLOCK: Final = 4096
_MAX_PLACES: Final = 5
"""Runs of rows that a remark lists"""

Progress = Callable[[float], None]
"""Is told the share that is done, in [0, 1]"""


@dataclass(frozen=True)
class ReadOptions:
    """What `JointTrajectory.load` may be told; see there."""

    columns: "ColumnMap | None" = None
    joint_map: JointMap | None = None
    names: tuple[str, ...] | None = None
    topic: str | None = None
    stamps: str = "header"
    degrees: bool | None = None
    ignore: tuple[str, ...] = ()
    sort: bool = False
    drop: bool = False
    salvage: bool = False

    def __post_init__(self) -> None:
        if self.stamps not in STAMPS:
            raise QuadrupedError(f"stamps: expected one of {', '.join(STAMPS)}; found {self.stamps!r}")
        for kind in self.ignore:
            if kind not in KINDS[1:]:
                raise QuadrupedError(f"ignore: expected {' or '.join(KINDS[1:])}; found {kind!r}")
        if self.degrees and self.joint_map is not None:
            for joint, rule in self.joint_map.rules.items():
                if rule.unit != "rad" or rule.velocity_unit is not None:
                    raise QuadrupedError(
                        f"{self.joint_map.name}: [joints.{joint}] has units of its own, and degrees were asked for "
                        f"too; leave --degrees out, or they would be converted twice"
                    )


@dataclass
class Reading:
    """One file as it is read: the options, and what became of its rows."""

    path: Path
    options: ReadOptions
    progress: Progress | None = None
    row_name: str = "row"
    """What the format calls a row"""
    rows: int = 0
    """Read so far, whether kept or not"""
    expected_rows: int = 0
    """In all; 0 where that is not known"""
    left_out: Counter[str] = field(default_factory=Counter)
    """Why rows were left out -> how many"""
    counted: Counter[str] = field(default_factory=Counter)
    """What a reader of the numbers should know -> how often it was found"""
    unchecked: list[tuple[int, int]] = field(default_factory=list)
    """First and last of the rows, one after another, that were salvaged and that no checksum covers"""
    checked_files: set[Path] = field(default_factory=set)
    """Files that were unpacked, and whose checksum held"""
    notes: list[str] = field(default_factory=list)
    """What a reader of the numbers should know about them"""

    name: str = ""
    """What errors call it: the path as it was given, whatever is unpacked from it"""

    def __post_init__(self) -> None:
        self.name = self.name or str(self.path)

    def source(self, rows: NDArray[np.int64]) -> Source:
        """Where rows with these numbers (n,) come from."""
        return Source(self.name, self.row_name, rows=rows)

    def error(self, row: int | None, problem: str) -> QuadrupedError:
        """The error for a problem, in one row or with the whole file."""
        place = "" if row is None else f" {self.row_name} {row}:"
        return QuadrupedError(f"{self.name}:{place} {problem}")

    def at(self, share: float) -> None:
        """Say how far it is."""
        if self.progress is not None:
            self.progress(min(share, 1.0))

    def note(self, text: str) -> None:
        """Remember something that a reader of the numbers should know, once."""
        text = cut(text)
        if text not in self.notes:
            self.notes.append(text)

    def count(self, what: str, number: int = 1) -> None:
        """Count something that a reader of the numbers should know."""
        if number:
            self.counted[what] += number

    def mark_unchecked(self, first: int, last: int | None = None) -> None:
        """Remember that no checksum covers a row that was salvaged, or the rows up to another; in their order."""
        last = first if last is None else last
        if self.unchecked and first == self.unchecked[-1][1] + 1:
            first, _ = self.unchecked.pop()
        self.unchecked.append((first, last))

    @property
    def unchecked_rows(self) -> int:
        """How many rows were salvaged that no checksum covers."""
        return sum(last - first + 1 for first, last in self.unchecked)

    def leave_out(self, why: str, count: int = 1) -> None:
        """Count rows that are not kept."""
        if count:
            self.left_out[why] += count

    def remarks(self) -> tuple[str, ...]:
        """The notes, and what was left out."""
        counted = (f"{count} {what}" for what, count in self.counted.items())
        left_out = (f"left out {count} of {self.rows}: {why}" for why, count in self.left_out.items())
        return (*self.notes, *self._unchecked_remark(), *counted, *left_out)

    def _unchecked_remark(self) -> Iterator[str]:
        if self.unchecked:
            places = [str(first) if first == last else f"{first} to {last}" for first, last in self.unchecked]
            where = ", ".join(places[:_MAX_PLACES]) + (", ..." if len(places) > _MAX_PLACES else "")
            yield (
                f"salvaged without a checksum, so that damage in their numbers would not show: {self.unchecked_rows} "
                f"of {self.rows} {self.row_name}s ({self.row_name} {where})"
            )


class Sample(NamedTuple):
    """One message, and its number in the file."""

    row: int
    state: RawJointState


@dataclass(frozen=True, eq=False)
class Block:
    """Some rows, as they were read."""

    rows: NDArray[np.int64]
    """Their numbers in the file (n,)"""
    stamps: NDArray[np.int64]
    """ns (n,)"""
    names: tuple[str, ...]
    values: dict[str, NDArray[np.float64]]
    """Kind -> (n, J)"""

    def take(self, index: Any) -> "Block":
        """Some of the rows."""
        values = {kind: array[index] for kind, array in self.values.items()}
        return Block(self.rows[index], self.stamps[index], self.names, values)

    def trajectory(self, reading: Reading) -> JointTrajectory:
        """The rows, checked.

        Raises:
            QuadrupedError: if one is not as a trajectory's must be.
        """
        return JointTrajectory(
            self.stamps,
            self.names,
            self.values["position"],
            self.values.get("velocity"),
            self.values.get("effort"),
            reading.source(self.rows),
        )


def assemble(samples: Iterable[Sample], reading: Reading) -> Iterator[Block]:
    """Blocks of the messages that fit together: the same joints, and as many numbers as joints.

    The first message that can be used decides which joints there are, and whether there are velocities and efforts.

    Raises:
        QuadrupedError: if a message does not fit and is not to be left out.
    """
    builder = _Builder(reading)
    for sample in samples:
        reading.rows += 1
        problem = builder.add(sample)
        if problem is not None:
            if not reading.options.drop:
                raise reading.error(sample.row, f"{problem}; mend it, or leave such messages out (--drop)")
            reading.leave_out(problem)
        elif len(builder.rows) == _ROWS_A_BLOCK:
            yield builder.block()
    if len(builder.rows):
        yield builder.block()


class _Builder:
    """Collects messages that fit together into a block."""

    def __init__(self, reading: Reading) -> None:
        self._reading = reading
        self._names: tuple[str, ...] = ()
        self._kinds: tuple[str, ...] = ()
        self._orders: dict[tuple[str, ...], list[int] | None] = {}
        """Names as a message has them -> where the block's joints stand in it; None where they stand alike"""
        self._clear()

    def _clear(self) -> None:
        self.rows, self._stamps = array("q"), array("q")
        self._numbers = {kind: array("d") for kind in self._kinds}

    def add(self, sample: Sample) -> str | None:
        """Take a message, or say what is wrong with it."""
        state = sample.state
        names = state.names
        if not state.position and state.effort:
            return TORQUE_ONLY
        if names not in self._orders:
            problem = self._learn(names, len(state.position))
            if problem is not None:
                return problem
        order = self._orders[names]
        count = len(self._names)
        if len(state.position) != count:
            return f"{count} names and {len(state.position)} positions"
        fields = {"position": state.position, "velocity": _known(state.velocity), "effort": state.effort}
        for kind in self._reading.options.ignore:
            fields[kind] = array("d")
        for kind, values in fields.items():
            if len(values) not in {0, count}:
                return f"{count} names and {len(values)} {'velocities' if kind == 'velocity' else 'efforts'}"
        kinds = tuple(kind for kind, values in fields.items() if values)
        if not self._kinds:
            self._kinds = kinds
            self._clear()
        elif kinds != self._kinds:
            odd = min(set(kinds) ^ set(self._kinds))
            there, before = ("has", "lack") if odd in kinds else ("lacks", "have")
            return f"it {there} the {odd} that the messages before it {before}"
        for kind in kinds:
            values = fields[kind]
            self._numbers[kind].extend(values if order is None else array("d", [values[i] for i in order]))
        self.rows.append(sample.row)
        self._stamps.append(state.stamp)
        return None

    def _learn(self, names: tuple[str, ...], positions: int) -> str | None:
        """Take note of names that were not met before, or say what is wrong with them."""
        given = self._reading.options.names
        actual = names or given or ()
        if not names and positions and given is None:
            return f"{positions} positions and no names: give the joints in their order (--names)"
        if not actual or not all(actual):
            return f"{positions} positions and {len(actual)} names, of which {actual.count('')} are empty"
        if len(set(actual)) < len(actual):
            twice = next(name for i, name in enumerate(actual) if name in actual[:i])
            return f"joint {short(twice)} is named twice"
        if not self._names:
            self._names = actual
        if set(actual) != set(self._names):
            other = min(set(actual) ^ set(self._names))
            there, before = ("has", "lack") if other in actual else ("lacks", "have")
            return f"it {there} joint {short(other)}, which the messages before it {before}"
        self._orders[names] = None if actual == self._names else [actual.index(name) for name in self._names]
        return None

    def block(self) -> Block:
        """What was collected since the last one."""
        shape = (len(self.rows), len(self._names))
        values = {kind: np.frombuffer(numbers).reshape(shape) for kind, numbers in self._numbers.items()}
        block = Block(np.frombuffer(self.rows, np.int64), np.frombuffer(self._stamps, np.int64), self._names, values)
        self._clear()
        return block


def _known(values: "array[float]") -> "array[float]":
    """The numbers, or none if none of them is known: some publishers send NaN for what they do not measure."""
    if values and math.isnan(values[0]) and all(map(math.isnan, values)):
        return array("d")
    return values


def salvaged(blocks: Iterator[Any], reading: Reading, is_text: bool) -> Iterator[Any]:
    """Blocks or samples that come before the damage, with a note of it, where that is asked for.

    Text has no checksums of its own; of bags, their readers know.
    """
    first = last = None
    try:
        for block in blocks:
            rows = (block.row, block.row) if isinstance(block, Sample) else (int(block.rows[0]), int(block.rows[-1]))
            first, last = rows[0] if first is None else first, rows[1]
            yield block
    except QuadrupedError as error:
        if not reading.options.salvage or first is None:
            raise
        reading.note(f"damaged, and read up to the damage: {error}")
        if is_text and reading.path not in reading.checked_files:
            reading.mark_unchecked(first, last)


def without_ignored(blocks: Iterator[Block], reading: Reading) -> Iterator[Block]:
    """The blocks without what the options say to ignore."""
    for block in blocks:
        yield replace(block, values={k: v for k, v in block.values.items() if k not in reading.options.ignore})


def joined(blocks: Sequence[Block]) -> Block:
    """The rows of all blocks, which have the same joints and kinds."""
    return Block(
        np.concatenate([block.rows for block in blocks]),
        np.concatenate([block.stamps for block in blocks]),
        blocks[0].names,
        {kind: np.concatenate([block.values[kind] for block in blocks]) for kind in blocks[0].values},
    )
