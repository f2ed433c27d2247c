"""Maps from the columns of any CSV to joint states, as TOML, and the reader that follows them.

    [columns]
    stamp = "time_start"                    # the column of the time
    stamp_unit = "s"                        # s, ms, us or ns; "s" unless given
    positions = ["flarm", "flfoot"]         # the columns of the positions, which name the joints ...
    velocities = { flarm = "w3" }           # ... or joint = "column"; may be left out
    efforts = { flarm = "i3" }              # may be left out
    velocity_files = { "a.csv" = "v.csv" }  # file -> the one beside it that has its velocities, in the same columns
    separator = ","                         # "," unless given

The first line names the columns. Others than these do not matter. The same file may hold a joint map
(`quadruped_env.trajectory.joint_map`). Stamps are decimals of any length and read exactly.
"""

import csv
from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from decimal import Decimal, DecimalException
from itertools import zip_longest
from pathlib import Path
from typing import Any, Final, Self

import numpy as np

from quadruped_env.documents import read_toml
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.trajectory.delimited import Layout, StampParser, blocks, lines, opened
from quadruped_env.trajectory.joint_map import check_keys, table_of
from quadruped_env.trajectory.reading import Block, Reading

STAMP_UNITS: Final = {"s": 9, "ms": 6, "us": 3, "ns": 0}
"""Unit of time -> power of ten of its ns"""

_KINDS: Final = {"positions": "position", "velocities": "velocity", "efforts": "effort"}
Columns = list[str] | dict[str, str]
"""Column names, which are the joints' too, or joint -> column"""


@dataclass(frozen=True)
class ColumnMap:
    """Which columns of a CSV hold a joint state."""

    stamp: str
    """Column of the time"""
    positions: Columns
    velocities: Columns | None = None
    efforts: Columns | None = None
    stamp_unit: str = "s"
    velocity_files: dict[str, str] | None = None
    """Name of a file -> name of the file beside it that has its velocities, in the columns of `velocities`, or of the
    positions if that is None"""
    separator: str = ","
    name: str = "ColumnMap"
    """What errors call it"""

    def __post_init__(self) -> None:
        for key in ("stamp", "stamp_unit", "separator"):
            if not isinstance(getattr(self, key), str) or not getattr(self, key):
                raise QuadrupedError(f"{self.name}: {key}: expected a text; found {getattr(self, key)!r}")
        if self.stamp_unit not in STAMP_UNITS:
            raise QuadrupedError(
                f"{self.name}: stamp_unit: expected one of {', '.join(STAMP_UNITS)}; found {self.stamp_unit!r}"
            )
        if len(self.separator) != 1 or self.separator in '"\n\r':
            raise QuadrupedError(f"{self.name}: separator: expected one character; found {self.separator!r}")
        files = {} if self.velocity_files is None else self.velocity_files
        if not isinstance(files, dict) or not all(
            isinstance(name, str) and Path(name).name == name for name in files.values()
        ):
            raise QuadrupedError(
                f"{self.name}: velocity_files: expected a table of files in the same directory; found {files!r}"
            )
        joints = _joints(self.positions)
        if not joints:
            raise QuadrupedError(f"{self.name}: positions: name one column or more")
        for key in _KINDS:
            columns = getattr(self, key)
            if columns is None:
                continue
            where = f"{self.name}: {key}"
            if not isinstance(columns, (list, dict)) or not all(
                isinstance(column, str) and column for column in _columns(columns).values()
            ):
                raise QuadrupedError(f"{where}: expected column names, or a table of them; found {columns!r}")
            if len(set(_joints(columns))) < len(columns) or set(_joints(columns)) != set(joints):
                raise QuadrupedError(
                    f"{where}: expected each joint once, those of the positions; found {', '.join(_joints(columns))}"
                )

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
                raise QuadrupedError(f"{where}: {key} is missing; add it")
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
            titles = next(table, None)
            if titles is None:
                raise reading.error(None, "the file is empty; expected a line that names the columns, and rows")
            layout = _layout([title.strip() for title in titles], columns, reading)
            yield from blocks(((table.line_num, row) for row in table), layout, reading)
        except csv.Error as error:
            raise reading.error(table.line_num, f"{error}; mend the line") from error


def _layout(titles: list[str], columns: ColumnMap, reading: Reading) -> Layout:
    names = tuple(_joints(columns.positions))

    def index(key: str, title: str) -> int:
        if titles.count(title) != 1:
            found = "no column" if title not in titles else "two columns"
            raise reading.error(
                1, f"{found} {short(title)}, which {columns.name} {key} names; found {', '.join(titles)}"
            )
        return titles.index(title)

    kinds = {key: getattr(columns, key) for key in _KINDS if getattr(columns, key) is not None}
    return Layout(
        titles=titles,
        stamp=index("stamp", columns.stamp),
        parse_stamp=_stamp_parser(STAMP_UNITS[columns.stamp_unit]),
        stamp_form=f"a time in {columns.stamp_unit}",
        columns={_KINDS[key]: [index(key, _columns(given)[name]) for name in names] for key, given in kinds.items()},
        names=names,
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


def _columns(given: Any) -> dict[str, str]:
    """Joint -> column."""
    return given if isinstance(given, dict) else {column: column for column in given}


def _joints(given: Any) -> list[str]:
    return list(given) if isinstance(given, (list, dict)) else []
