"""CSVs of any columns, read by a column map: see `quadruped_env.trajectory.maps`."""

import csv
from collections.abc import Iterable, Iterator
from dataclasses import replace
from decimal import Decimal, DecimalException
from itertools import chain, zip_longest
from typing import Final

import numpy as np

from quadruped_env.errors import short
from quadruped_env.trajectory.file_reading import Reading
from quadruped_env.trajectory.formats.delimited import (
    Layout,
    StampParser,
    is_number,
    lines,
    opened,
    salvaged_text,
    table_rows,
)
from quadruped_env.trajectory.maps import STAMP_UNITS, Column, ColumnMap
from quadruped_env.trajectory.rows import ARRAYS, KINDS, Rows

_MAX_SHOWN: Final = 12
"""Names of columns that an error lists."""


def read(reading: Reading) -> Iterator[Rows]:
    """The rows of a CSV, by the column map of the options, not validated.

    Raises:
        QuadrupedError: if a file is missing or damaged, or lacks a column.
    """
    columns = reading.options.columns
    assert columns is not None
    velocity_file = (columns.velocity_files or {}).get(reading.path.name)
    if velocity_file is None:
        return salvaged_text(_rows(reading, columns), reading)
    return salvaged_text(_rows_of_two_files(reading, columns, velocity_file), reading)


def _rows_of_two_files(reading: Reading, columns: ColumnMap, velocity_file: str) -> Iterator[Rows]:
    path = reading.path.with_name(velocity_file)
    other = replace(reading, path=path, name=str(path), progress=None)
    of_velocities = replace(columns, positions=columns.velocities or columns.positions, velocities=None, efforts=None)
    pieces = _rows(reading, replace(columns, velocities=None))
    for piece, speeds in zip_longest(pieces, _rows(other, of_velocities)):
        if piece is not None and speeds is not None and reading.options.salvage:
            # A piece that ends at damage is shorter than that of the other file.
            count = min(len(piece), len(speeds))
            piece, speeds = piece.take(np.s_[:count]), speeds.take(np.s_[:count])  # noqa: PLW2901
        if piece is None or speeds is None or not np.array_equal(piece.stamps, speeds.stamps):
            raise reading.error(
                None,
                f"{other.path.name} must have the same timestamps, row by row; found others; leave velocity_files out",
            )
        order = [speeds.names.index(name) for name in piece.names]
        values = piece.values | {"velocity": speeds.values["position"][:, order]}
        yield replace(piece, values={kind: values[kind] for kind in KINDS if kind in values})


def _rows(reading: Reading, columns: ColumnMap) -> Iterator[Rows]:
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
            yield from table_rows(rows, _layout(titles, columns, reading), reading)
        except csv.Error as error:
            raise reading.error(table.line_num, f"{error}; fix the line") from error


def _layout(titles: list[str], columns: ColumnMap, reading: Reading) -> Layout:
    def index(key: str, column: Column) -> int:
        if isinstance(column, int):
            if column > len(titles):
                raise reading.error(1, f"no column {column}, which {columns.name} {key} asks for; found {len(titles)}")
            return column - 1
        if titles.count(column) != 1:
            problem = f"{'no column' if column not in titles else 'two columns'} {short(column)}, which {columns.name}"
            found = ", ".join(map(_shown, titles[:_MAX_SHOWN])) + (", ..." if len(titles) > _MAX_SHOWN else "")
            fix = "; if it is a row already, name the columns in the map (header = [...])"
            raise reading.error(1, f"{problem} {key} names; found {found}{fix if all(map(is_number, titles)) else ''}")
        return titles.index(column)

    return Layout(
        titles=titles,
        stamp=index("stamp", columns.stamp),
        parse_stamp=_stamp_parser(STAMP_UNITS[columns.stamp_unit]),
        stamp_form=f"a time in {columns.stamp_unit}",
        columns={
            kind: [index(ARRAYS[kind], given[name]) for name in columns.joints]
            for kind, given in columns.columns.items()
        },
        names=columns.joints,
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


def _shown(title: str) -> str:
    """A column's name in a list of names."""
    return short(title)[1:-1]
