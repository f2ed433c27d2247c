"""Text with a row of numbers a line: what the project's own CSV and mapped CSV share."""

import math
import os
from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Final, TextIO

import numpy as np

from quadruped_env.documents import check_regular
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.trajectory.reading import KINDS, Block, Reading

MISSING: Final = "values that the column map marks as missing: read as not recorded (NaN)"
_ROWS_A_BLOCK: Final = 4096

StampParser = Callable[[str], int]
"""Text of a cell -> ns; ValueError if it is none"""


@dataclass(frozen=True)
class Layout:
    """Which column of a table holds what."""

    titles: Sequence[str]
    """Of all columns, as errors name them"""
    stamp: int
    """Column of the stamp"""
    parse_stamp: StampParser
    stamp_form: str
    """What a stamp must be, as errors say it"""
    columns: dict[str, list[int]]
    """Kind -> columns, a column a joint"""
    names: tuple[str, ...]
    """Joints"""
    missing: tuple[float, ...] = ()
    """Numbers that stand for no value"""
    blanks: tuple[str, ...] = ()
    """Texts that stand for no value"""

    def __post_init__(self) -> None:
        assert all(len(columns) == len(self.names) for columns in self.columns.values())


@contextmanager
def opened(reading: Reading) -> Iterator[TextIO]:
    """The file as text, whatever goes wrong with it being this package's error."""
    check_regular(reading.path, "name a file of joint states")
    try:
        # A byte-order mark is what spreadsheets put in front of UTF-8.
        with reading.path.open(encoding="utf-8-sig") as file:
            yield file
    except UnicodeDecodeError as error:
        raise reading.error(None, f"not a text file ({error.reason}); expected text of joint states") from error
    except OSError as error:
        raise reading.error(None, f"cannot be read ({error.strerror}); name a file of joint states") from error


def lines(file: TextIO, reading: Reading, first: int) -> Iterator[str]:
    """The lines that are left of a file, of which the next is number `first`, while saying how far it is.

    Raises:
        QuadrupedError: at a last line that does not end, since its last number may be cut off.
    """
    size = max(os.fstat(file.fileno()).st_size, 1)
    done = 0
    for number, line in enumerate(file, first):
        if not line.endswith("\n"):
            last = short(line.rpartition(",")[2].strip())
            raise QuadrupedError(
                f"{reading.name}: line {number}: the last line does not end, so its last number, {last}, may be cut "
                f"off; delete the line, or end it if it is whole"
            )
        done += len(line)
        if number == first:
            # Lines differ in length, and room that is never used costs nothing.
            reading.expected_rows = 2 * size // len(line)
        if number % 1000 == 0:
            reading.at(done / size)
        yield line


def blocks(table: Iterable[tuple[int, list[str]]], layout: Layout, reading: Reading) -> Iterator[Block]:
    """Blocks of the rows of a table, given as line numbers and cells.

    Raises:
        QuadrupedError: if a line has too few cells or too many, or a cell that matters is no number.
    """
    used = [(kind, column) for kind in KINDS for column in layout.columns.get(kind, ())]
    # All columns in their order are the fast case.
    picks = [column for _, column in used]
    width = len(layout.names)
    rows, stamps, numbers = array("q"), array("q"), array("d")

    parse = _parser(layout, reading)

    def block() -> Block:
        values = np.frombuffer(numbers).reshape(len(rows), len(picks))
        if layout.missing:
            marked = np.isin(values, layout.missing)
            values = np.where(marked, np.nan, values)
            reading.count(MISSING, int(np.count_nonzero(marked)))
        kinds = [kind for kind in KINDS if kind in layout.columns]
        return Block(
            np.frombuffer(rows, np.int64),
            np.frombuffer(stamps, np.int64),
            layout.names,
            {kind: values[:, i * width : (i + 1) * width] for i, kind in enumerate(kinds)},
        )

    for number, cells in table:
        if len(cells) != len(layout.titles):
            raise reading.error(
                number,
                f"expected {len(layout.titles)} columns, as in the header; found {len(cells)}; "
                f"the line is damaged or cut off: mend it or delete it",
            )
        reading.rows += 1
        try:
            stamps.append(layout.parse_stamp(cells[layout.stamp]))
            numbers.extend(map(parse, [cells[column] for column in picks]))
        except (ValueError, OverflowError):
            raise _bad_cell(cells, layout, picks, number, reading) from None
        rows.append(number)
        if len(rows) == _ROWS_A_BLOCK:
            yield block()
            rows, stamps, numbers = array("q"), array("q"), array("d")
    if rows:
        yield block()
    elif not reading.rows:
        raise reading.error(None, "there is a header and no row; the recording is empty, record again")


def _parser(layout: Layout, reading: Reading) -> Callable[[str], float]:
    """From the text of a cell to a number; NaN for texts that stand for no value."""
    if not layout.blanks:
        return parse_number

    def parse(text: str) -> float:
        if text.strip() in layout.blanks:
            reading.count(MISSING)
            return math.nan
        return parse_number(text)

    return parse


def parse_number(text: str) -> float:
    """A number.

    Python's own may hold underscores and the digits of other scripts: in a file of numbers those are damage.

    Raises:
        ValueError: if it is none.
    """
    if "_" in text or not text.isascii():
        raise ValueError(text)
    return float(text)


def parse_whole(text: str) -> int:
    """A whole number of ns within int64, written as digits.

    Raises:
        ValueError: if it is none.
    """
    if "_" in text or not text.isascii():
        raise ValueError(text)
    return array("q", [int(text)])[0]


def _bad_cell(cells: list[str], layout: Layout, picks: Iterable[int], number: int, reading: Reading) -> QuadrupedError:
    """The error for the first cell of a line that is not what it must be."""
    for column in sorted({layout.stamp, *picks}):
        is_stamp = column == layout.stamp
        try:
            _ = layout.parse_stamp(cells[column]) if is_stamp else _parser(layout, reading)(cells[column])
        except (ValueError, OverflowError):
            form = layout.stamp_form if is_stamp else "a number"
            found = short(cells[column].strip("\n"))
            problem = f"{found} is not {form}; mend the value or delete the line"
            return QuadrupedError(f"{reading.name}: line {number}, {layout.titles[column]}: {problem}")
    raise AssertionError("a cell is bad")
