"""Text files with one row of numbers per line: shared by the project's own CSV and mapped CSVs."""

import csv
import math
import os
import re
from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Final, TextIO

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.trajectory.file_reading import Reading, salvaged
from quadruped_env.trajectory.rows import KINDS, Rows
from quadruped_env.utils.documents import check_regular

MISSING: Final = "values that the column map marks as missing: read as not recorded (NaN)"
_ROWS_PER_PIECE: Final = 4096

StampParser = Callable[[str], int]
"""Text of a cell -> ns. Raises ValueError for an invalid timestamp."""


@dataclass(frozen=True)
class Layout:
    """The columns of a table."""

    titles: Sequence[str]
    """Names of all columns, for error messages"""
    stamp: int | None
    """Index of the column of the timestamp; without one, rows are 1 ns apart"""
    parse_stamp: StampParser
    stamp_form: str
    """Description of a valid timestamp, for error messages"""
    columns: dict[str, list[int]]
    """Kind -> indices of its columns, one per joint"""
    names: tuple[str, ...]
    """Joints (J,)"""
    missing: tuple[float, ...] = ()
    """Numbers that mark a missing value"""
    blanks: tuple[str, ...] = ()
    """Texts that mark a missing value"""
    decimal: str = "."
    """Decimal point or comma"""


@contextmanager
def opened(reading: Reading) -> Iterator[TextIO]:
    """The file, opened as text; errors of the system and the encoding become this package's."""
    check_regular(reading.path, "name a file of joint states")
    try:
        # Spreadsheets put a byte-order mark in front of UTF-8.
        with reading.path.open(encoding="utf-8-sig") as file:
            yield file
    except UnicodeDecodeError as error:
        raise reading.error(None, f"not a text file ({error.reason}); expected text of joint states") from error
    except OSError as error:
        raise reading.error(None, f"cannot be read ({error.strerror}); name a file of joint states") from error


def lines(file: TextIO, reading: Reading, first: int) -> Iterator[str]:
    """The remaining lines of a file, with progress, each with a line end. The next line has number `first`.

    A last line without one gets it, and a remark, since its last number may be cut off.
    """
    size = max(os.fstat(file.fileno()).st_size, 1)
    done = 0
    for number, line in enumerate(file, first):
        if not line.endswith("\n"):
            last = short(line.rpartition(",")[2].strip())
            reading.note(f"line {number}: the last line does not end, so its last value, {last}, may be cut off")
            line += "\n"  # noqa: PLW2901
        done += len(line)
        if number % 1000 == 0:
            reading.report_progress(done / size)
        yield line


def table_rows(table: Iterable[tuple[int, list[str]]], layout: Layout, reading: Reading) -> Iterator[Rows]:
    """The rows of a table, given as line numbers and cells.

    Raises:
        QuadrupedError: if a line has too few or too many cells, or a cell that is used is not a number. If the options
            ask to salvage, the rows before it come first.
    """
    used = [column for kind in KINDS for column in layout.columns.get(kind, ())]
    width = len(layout.names)
    numbers, stamps, values = array("q"), array("q"), array("d")
    parse = _parser(layout, reading)

    def piece() -> Rows:
        # Without what a bad cell has left unfinished.
        table = np.frombuffer(values)[: len(numbers) * len(used)].reshape(len(numbers), len(used))
        if layout.missing:
            marked = np.isin(table, layout.missing)
            table = np.where(marked, np.nan, table)
            reading.count(MISSING, int(np.count_nonzero(marked)))
        kinds = [kind for kind in KINDS if kind in layout.columns]
        return Rows(
            np.frombuffer(numbers, np.int64),
            np.frombuffer(stamps, np.int64)[: len(numbers)],
            layout.names,
            {kind: table[:, i * width : (i + 1) * width] for i, kind in enumerate(kinds)},
        )

    try:
        for number, cells in table:
            if len(cells) != len(layout.titles):
                raise reading.error(
                    number,
                    f"expected {len(layout.titles)} columns, as in the header; found {len(cells)}; "
                    f"the line is damaged or cut off: fix it, or keep the lines before it (--salvage)",
                )
            reading.rows += 1
            try:
                stamps.append(reading.rows - 1 if layout.stamp is None else layout.parse_stamp(cells[layout.stamp]))
                values.extend(map(parse, [cells[column] for column in used]))
            except (ValueError, OverflowError):
                raise _bad_cell(cells, layout, used, number, reading) from None
            numbers.append(number)
            if len(numbers) == _ROWS_PER_PIECE:
                yield piece()
                numbers, stamps, values = array("q"), array("q"), array("d")
    except (ValueError, OSError, csv.Error):
        if reading.options.salvage and numbers:
            yield piece()
        raise
    if numbers:
        yield piece()
    elif not reading.rows:
        raise reading.error(None, "there is a header and no row; the recording is empty, record again")


def salvaged_text(pieces: Iterator[Rows], reading: Reading) -> Iterator[Rows]:
    """The rows of a text file, up to the damage if the options ask to salvage."""
    return salvaged(pieces, reading, lambda rows: (int(rows.numbers[0]), int(rows.numbers[-1])), is_text=True)


def _parser(layout: Layout, reading: Reading) -> Callable[[str], float]:
    """Parser of the numbers in cells; NaN for texts that mark a missing value."""
    if not layout.blanks and layout.decimal == ".":
        return parse_number

    def parse(text: str) -> float:
        if text.strip() in layout.blanks:
            reading.count(MISSING)
            return math.nan
        return parse_number(with_point(text, layout.decimal))

    return parse


def with_point(text: str, decimal: str) -> str:
    """A number with a decimal point. Raises ValueError if it has one already, and `decimal` is the comma."""
    if decimal == ".":
        return text
    if "." in text:
        raise ValueError(text)
    return text.replace(",", ".")


def parse_number(text: str) -> float:
    """A number.

    Python's own parser accepts underscores and digits of other scripts, which are damage in a file of numbers.

    Raises:
        ValueError: if the text is not such a number.
    """
    if "_" in text or not text.isascii():
        raise ValueError(text)
    return float(text)


def is_number(text: str) -> bool:
    """True if `parse_number` reads a text."""
    try:
        parse_number(text)
    except ValueError:
        return False
    return True


def parse_whole(text: str) -> int:
    """A whole number within int64, in ASCII digits.

    Raises:
        ValueError: if the text is not such a number.
    """
    if "_" in text or not text.isascii():
        raise ValueError(text)
    return array("q", [int(text)])[0]


def _bad_cell(cells: list[str], layout: Layout, used: Iterable[int], number: int, reading: Reading) -> QuadrupedError:
    """The error for the first invalid cell of a line."""
    for column in sorted({*used} if layout.stamp is None else {layout.stamp, *used}):
        is_stamp = column == layout.stamp
        try:
            _ = layout.parse_stamp(cells[column]) if is_stamp else _parser(layout, reading)(cells[column])
        except (ValueError, OverflowError):
            form = layout.stamp_form if is_stamp else "a number"
            found = short(cells[column].strip("\n"))
            comma = layout.decimal == "." and re.fullmatch(r"\s*[-+]?\d+,\d+([eE][-+]?\d+)?\s*", cells[column])
            fix = ', or if this is a decimal comma, say so in a map (decimal = ",")' if comma else ""
            problem = f"{found} is not {form}; fix the value or delete the line{fix}"
            return QuadrupedError(f"{reading.name}: line {number}, {layout.titles[column]}: {problem}")
    raise AssertionError("every cell is valid")
