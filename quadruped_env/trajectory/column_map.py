"""Maps from the columns of any CSV to joint states, as TOML, and the reader that follows them.

    [columns]
    stamp = "time_start"                    # the column of the time
    stamp_unit = "s"                        # s, ms, us or ns; "s" unless given
    positions = ["flarm", "flfoot"]         # the columns of the positions, which name the joints ...
    velocities = { flarm = "w3" }           # ... or joint = "column"; may be left out
    efforts = { flarm = "i3" }              # may be left out
    velocity_files = { "a.csv" = "v.csv" }  # file -> the one beside it that has its velocities, in the same columns
    separator = ","                         # "," unless given
    header = ["t", "q0", "q1"]              # names of all columns, for a file whose first line is a row already
    missing = [2.146e9, "-"]                # values that stand for "no value": numbers, or texts such as ""

The first line names the columns, unless `header` does. Other columns do not matter. A column may also be given by its
number, 1 for the first:

    stamp = 1
    positions = { flarm = 2, flfoot = 5 }

A file whose columns are all given by number has no line of names; `header = true` says that it has one, `header =
false` that it has none.

A value is missing if it equals a number of `missing` once it is read as float64 (2146000000.0 equals 2.146e9), or a
text of it once spaces around it are gone. It counts as not recorded and becomes NaN. An effort may be NaN; a row with
such a position or velocity is an error unless it is left out (`drop`) or the velocities are not read (`ignore`). Stamps
are never missing. The account says how many values were missing.

The same file may hold a joint map (`quadruped_env.trajectory.joint_map`). Stamps are decimals of any length and read
exactly.
"""

import csv
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, fields, replace
from decimal import Decimal, DecimalException
from itertools import chain, zip_longest
from pathlib import Path
from typing import Any, Final, Self

import numpy as np

from quadruped_env.documents import read_toml
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.trajectory.delimited import Layout, StampParser, blocks, lines, opened, parse_number
from quadruped_env.trajectory.joint_map import check_keys, table_of
from quadruped_env.trajectory.reading import TORQUE_ONLY, Block, Reading

STAMP_UNITS: Final = {"s": 9, "ms": 6, "us": 3, "ns": 0}
"""Unit of time -> power of ten of its ns"""

_COLUMN_FORM: Final = "name or number from 1 on"
_MAX_SHOWN: Final = 12
"""Names of columns that an error lists"""
_KINDS: Final = {"positions": "position", "velocities": "velocity", "efforts": "effort"}
Column = str | int
"""Name of a column, or its number, from 1 on"""
Columns = list[str] | dict[str, Column]
"""Column names, which are the joints' too, or joint -> column"""
Mark = float | str
"""A value that stands for none: a number, or a text"""


@dataclass(frozen=True)
class ColumnMap:
    """Which columns of a CSV hold a joint state."""

    stamp: Column
    """Column of the time"""
    positions: Columns
    velocities: Columns | None = None
    efforts: Columns | None = None
    stamp_unit: str = "s"
    velocity_files: dict[str, str] | None = None
    """Name of a file -> name of the file beside it that has its velocities, in the columns of `velocities`, or of the
    positions if that is None"""
    separator: str = ","
    header: list[str] | bool | None = None
    """Names of all columns, of a file whose first line is a row; or whether the first line names them, which it does
    by default unless all columns are given by number"""
    missing: Mark | list[Mark] | None = None
    """Values that stand for none; they are read as NaN"""
    name: str = "ColumnMap"
    """What errors call it"""

    def __post_init__(self) -> None:
        for key in ("stamp_unit", "separator"):
            if not isinstance(getattr(self, key), str) or not getattr(self, key):
                raise QuadrupedError(f"{self.name}: {key}: expected a text; found {short(getattr(self, key))}")
        if not _is_column(self.stamp):
            raise QuadrupedError(f"{self.name}: stamp: expected a column, {_COLUMN_FORM}; found {short(self.stamp)}")
        if self.stamp_unit not in STAMP_UNITS:
            raise QuadrupedError(
                f"{self.name}: stamp_unit: expected one of {', '.join(STAMP_UNITS)}; found {short(self.stamp_unit)}"
            )
        if len(self.separator) != 1 or self.separator in '"\n\r':
            raise QuadrupedError(f"{self.name}: separator: expected one character; found {short(self.separator)}")
        files = {} if self.velocity_files is None else self.velocity_files
        if not isinstance(files, dict) or not all(
            isinstance(name, str) and Path(name).name == name for name in files.values()
        ):
            raise QuadrupedError(
                f"{self.name}: velocity_files: expected a table of files in the same directory; found {short(files)}"
            )
        joints = _joints(self.positions)
        if not joints:
            raise QuadrupedError(f"{self.name}: positions: name one column or more")
        for key in _KINDS:
            columns = getattr(self, key)
            if columns is None:
                continue
            where = f"{self.name}: {key}"
            if not _are_columns(columns):
                raise QuadrupedError(
                    f"{where}: expected column names, or a table joint = column of {_COLUMN_FORM}s; found "
                    f"{short(columns)}"
                )
            if len(set(_joints(columns))) < len(columns) or set(_joints(columns)) != set(joints):
                raise QuadrupedError(
                    f"{where}: expected each joint once, those of the positions; found {', '.join(_joints(columns))}"
                )
        self._check_header()
        if not all(isinstance(mark, str) or _is_number(mark) for mark in self.marks):
            raise QuadrupedError(
                f"{self.name}: missing: expected a number, a text, or a list of them; found {short(self.missing)}"
            )

    def _check_header(self) -> None:
        """Raise a QuadrupedError if the names of the columns are not what they must be."""
        header = self.header
        if isinstance(header, list):
            if not header or not all(isinstance(title, str) and title for title in header):
                raise QuadrupedError(f"{self.name}: header: expected the names of all columns; found {short(header)}")
        elif header is not None and not isinstance(header, bool):
            raise QuadrupedError(f"{self.name}: header: expected names, true or false; found {short(header)}")
        named = next((column for column in self.used if isinstance(column, str)), None)
        if header is False and named is not None:
            raise QuadrupedError(
                f"{self.name}: column {short(named)} is given by name, and header = false says that no line names the "
                f"columns; give its number, or the names of all columns (header = [...])"
            )

    @property
    def used(self) -> list[Column]:
        """All columns that are read, as they are given."""
        given = [_columns(getattr(self, key)) for key in _KINDS if getattr(self, key) is not None]
        return [self.stamp, *(column for columns in given for column in columns.values())]

    @property
    def has_header_line(self) -> bool:
        """Whether the first line of the file names its columns."""
        if self.header is None:
            return any(isinstance(column, str) for column in self.used)
        return self.header is True

    @property
    def marks(self) -> list[Any]:
        """The values that stand for none."""
        if self.missing is None:
            return []
        return self.missing if isinstance(self.missing, list) else [self.missing]

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read a map from the table `[columns]` of a TOML file.

        Raises:
            QuadrupedError: if there is no such file or something in it is wrong; the message names the key.
        """
        table = table_of(read_toml(Path(path)), "columns", str(path))
        where = f"{path}: [columns]"
        check_keys(table, (field.name for field in fields(cls) if field.name != "name"), where)
        for key in ("stamp", "positions"):
            if key not in table:
                torque_only = key == "positions" and "efforts" in table
                problem = f"; {TORQUE_ONLY}" if torque_only else "; add it"
                raise QuadrupedError(f"{where}: {key} is missing{problem}")
        return cls(**table, name=where)


def read(reading: Reading) -> Iterator[Block]:
    """The rows of a CSV, by the column map of the options.

    Raises:
        QuadrupedError: if a file is missing or damaged, or lacks a column.
    """
    columns = reading.options.columns
    assert columns is not None
    velocity_file = (columns.velocity_files or {}).get(reading.path.name)
    if velocity_file is None:
        yield from _read_file(reading, columns)
        return
    path = reading.path.with_name(velocity_file)
    other = replace(reading, path=path, name=str(path), progress=None)
    speeds = replace(columns, positions=columns.velocities or columns.positions, velocities=None, efforts=None)
    positions = _read_file(reading, replace(columns, velocities=None))
    for block, speed in zip_longest(positions, _read_file(other, speeds)):
        if block is None or speed is None or not np.array_equal(block.stamps, speed.stamps):
            raise reading.error(
                None, f"{other.path.name} must have the same stamps, row by row; found others; leave velocity_files out"
            )
        order = [speed.names.index(name) for name in block.names]
        yield replace(block, values=block.values | {"velocity": speed.values["position"][:, order]})


def _read_file(reading: Reading, columns: ColumnMap) -> Iterator[Block]:
    reading.row_name = "line"
    with opened(reading) as file:
        table = csv.reader(lines(file, reading, 1), delimiter=columns.separator, strict=True)
        try:
            first = next(table, None)
            if first is None:
                expected = "a line that names the columns, and rows" if columns.has_header_line else "rows"
                raise reading.error(None, f"the file is empty; expected {expected}")
            rows: Iterable[tuple[int, list[str]]] = ((table.line_num, row) for row in table)
            if columns.has_header_line:
                titles = [title.strip() for title in first]
            else:
                rows = chain([(table.line_num, first)], rows)
                given = columns.header if isinstance(columns.header, list) else None
                titles = given or [f"column {number}" for number in range(1, len(first) + 1)]
            yield from blocks(rows, _layout(titles, columns, reading), reading)
        except csv.Error as error:
            raise reading.error(table.line_num, f"{error}; mend the line") from error


def _layout(titles: list[str], columns: ColumnMap, reading: Reading) -> Layout:
    names = tuple(_joints(columns.positions))

    def index(key: str, column: Column) -> int:
        if isinstance(column, int):
            if column > len(titles):
                raise reading.error(1, f"no column {column}, which {columns.name} {key} asks for; found {len(titles)}")
            return column - 1
        if titles.count(column) != 1:
            problem = f"{'no column' if column not in titles else 'two columns'} {short(column)}, which {columns.name}"
            found = ", ".join(map(_shown, titles[:_MAX_SHOWN])) + (", ..." if len(titles) > _MAX_SHOWN else "")
            cure = "; if it is a row already, name the columns in the map (header = [...])"
            raise reading.error(
                1, f"{problem} {key} names; found {found}{cure if all(map(_looks_like_a_number, titles)) else ''}"
            )
        return titles.index(column)

    kinds = {key: getattr(columns, key) for key in _KINDS if getattr(columns, key) is not None}
    return Layout(
        titles=titles,
        stamp=index("stamp", columns.stamp),
        parse_stamp=_stamp_parser(STAMP_UNITS[columns.stamp_unit]),
        stamp_form=f"a time in {columns.stamp_unit}",
        columns={_KINDS[key]: [index(key, _columns(given)[name]) for name in names] for key, given in kinds.items()},
        names=names,
        missing=tuple(mark for mark in columns.marks if not isinstance(mark, str)),
        blanks=tuple(mark.strip() for mark in columns.marks if isinstance(mark, str)),
    )


def _stamp_parser(power: int) -> StampParser:
    def parse(text: str) -> int:
        if "_" in text or not text.isascii():
            raise ValueError(text)
        try:
            time = Decimal(text).scaleb(power)
        except DecimalException as error:
            raise ValueError(text) from error
        # Before it is rounded: 1e999999999 has more digits than fit into memory.
        if not time.is_finite() or abs(time) >= 2**63 - 1:
            raise ValueError(text)
        return round(time)

    return parse


def _columns(given: Any) -> dict[str, Column]:
    """Joint -> column."""
    return given if isinstance(given, dict) else {column: column for column in given}


def _is_column(value: object) -> bool:
    return value != "" if isinstance(value, str) else type(value) is int and value >= 1


def _are_columns(given: Any) -> bool:
    """Whether columns are given for joints; in a list they name the joints too, which numbers cannot."""
    if isinstance(given, dict):
        return all(map(_is_column, given.values()))
    return isinstance(given, list) and all(isinstance(column, str) and column for column in given)


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _looks_like_a_number(text: str) -> bool:
    try:
        parse_number(text)
    except ValueError:
        return False
    return True


def _shown(title: str) -> str:
    """A column's name in a list of them."""
    return short(title)[1:-1]


def _joints(given: Any) -> list[str]:
    return list(given) if isinstance(given, (list, dict)) else []
