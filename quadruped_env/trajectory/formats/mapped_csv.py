"""CSVs, read by a map of their columns: see `quadruped_env.trajectory.column_map`."""

import csv
import math
import re
from array import array
from collections.abc import Iterator
from dataclasses import replace
from datetime import datetime
from decimal import Decimal, DecimalException
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.column_map import STAMP_UNITS, Column, ColumnMap
from quadruped_env.trajectory.formats.delimited import is_number, lines, opened, parse_number
from quadruped_env.trajectory.reading import Reading, salvaged
from quadruped_env.trajectory.rows import ARRAYS, KINDS, Rows

MISSING: Final = "values that the column map marks as missing: read as not recorded (NaN)"
_MAX_SHOWN: Final = 12
"""Names of columns that an error lists."""
_KIND_WORDS: Final = {
    "position": "position",
    "pos": "position",
    "velocity": "velocity",
    "vel": "velocity",
    "effort": "effort",
    "torque": "effort",
}
_OTHER_WORDS: Final = frozenset(("cmd", "command", "target", "desired", "des", "ref", "reference", "error", "raw"))
"""Words of columns that were not measured."""
_TIME_TITLE: Final = re.compile(
    r"_*(?P<word>t|time|stamp|time_?stamp|elapsed|seconds|secs?|s|ms|us|ns)([ _\[(]+(?P<unit>s|sec|ms|us|ns)[\])]?)?$",
    re.IGNORECASE,
)


def read(reading: Reading, columns: ColumnMap | None = None) -> Rows:
    """Return the rows of a CSV, read by a column map (default: the one in the options), not validated.

    Raises:
        QuadrupedError: if the file is missing or damaged, or lacks a column.
    """
    given = columns or reading.options.columns
    assert isinstance(given, ColumnMap)
    if given.stamp is None and reading.options.period is None:
        raise reading.error(
            None,
            f"{given.name}: no timestamps: name their column (stamp), or give the time from row to row in s "
            f"(period in the map, or --stamps 0.02)",
        )
    if velocity_file := (given.velocity_files or {}).get(reading.path.name):
        return _read_with_velocities(given, velocity_file, reading)
    reading.row_name = "line"
    layout = _Layout(given, reading)
    numbers, stamps, values = array("q"), array("q"), array("d")
    for number, stamp, found in salvaged(_lines(layout, reading), reading, is_text=True):
        numbers.append(number)
        stamps.append(stamp)
        values.extend(found)
    table = np.frombuffer(values).reshape(len(numbers), -1)
    marked = np.isin(table, [mark for mark in given.marks if not isinstance(mark, str)])
    reading.counted[MISSING] += int(np.count_nonzero(marked))
    kinds = tuple(given.columns)
    parts = np.split(np.where(marked, np.nan, table), len(kinds), axis=1)
    arrays = dict(zip(kinds, parts, strict=True))
    return Rows(np.frombuffer(numbers, np.int64), np.frombuffer(stamps, np.int64), given.joints, arrays)


def _read_with_velocities(columns: ColumnMap, name: str, reading: Reading) -> Rows:
    """Return the rows with the velocities of another file."""
    rows = read(reading, replace(columns, velocities=None, velocity_files=None))
    path = reading.path.with_name(name)
    other = replace(reading, path=path, name=str(path), rows=0, progress=None)
    positions = columns.velocities or columns.positions
    speeds = read(other, replace(columns, positions=positions, velocities=None, efforts=None, velocity_files=None))
    if reading.repairs("salvage"):
        # A file that ends at damage is shorter than the other.
        count = min(len(rows), len(speeds))
        rows, speeds = rows.take(np.s_[:count]), speeds.take(np.s_[:count])
    if not np.array_equal(rows.stamps, speeds.stamps):
        raise reading.error(
            None, f"{name} must have the same timestamps, row by row; found others; leave velocity_files out"
        )
    order = [speeds.names.index(name) for name in rows.names]
    values = rows.values | {"velocity": speeds.values["position"][:, order]}
    return replace(rows, values={kind: values[kind] for kind in KINDS if kind in values})


def by_titles(line: str, text: str, reading: Reading) -> ColumnMap | None:
    """Return the column map of a CSV whose columns bear the names of joints, from its first line; None if they do not.

    The joints are named by the options, or are the built-in robot's. A title is a joint's name, or holds it with a
    word for the kind (`position.LF_hip_joint`, `/joint_states/LF_hip_joint/velocity`). The unit of the time is in its
    title, or is s. Numbers have decimal commas if the beginning of the file, `text`, holds only such numbers, and
    commas do not separate its columns.
    """
    names = reading.options.names or MINI_QUADRUPED.joint_names
    patterns = {name: re.compile(rf"(?<![^\W_]){re.escape(name)}(?![^\W_])") for name in names}
    for separator in sorted(",;\t", key=line.count, reverse=True):
        titles = [title.strip().strip('"') for title in line.rstrip("\n").split(separator)]
        found: dict[str, dict[str, Column]] = {}
        for title in titles:
            for name, pattern in patterns.items():
                if not pattern.search(title):
                    continue
                words = re.findall("[a-z]+", pattern.sub(" ", title, count=1).lower())
                kinds = {_KIND_WORDS[word] for word in words if word in _KIND_WORDS} or {"" if words else "position"}
                kind = "" if _OTHER_WORDS.intersection(words) or len(kinds) > 1 else kinds.pop()
                if name in found.get(kind, ()) and kind:
                    raise reading.error(1, f"two columns hold the {kind} of {name}; name one in a map (--columns FILE)")
                if kind:
                    found.setdefault(kind, {})[name] = title
        if "position" not in found:
            continue
        joints = found["position"]
        if reading.options.names and (missing := [name for name in names if name not in joints]):
            raise reading.error(1, f"no column bears the name {short(missing[0])} (--names); found {short(line)}")
        kinds_of_all = {kind: columns for kind, columns in found.items() if set(columns) == set(joints)}
        times = [match for title in titles if (match := _TIME_TITLE.match(title))]
        unit: Any = (times[0]["unit"] or times[0]["word"] or "s").lower() if times else ""
        unit = unit if unit in STAMP_UNITS else "s"
        time = f"time in {unit} from {short(times[0].string)}, " if times else ""
        commas = separator != "," and re.search(r"\d,\d", text) and not re.search(r"\d\.\d", text)
        reading.note(
            f"read by the names of its columns: {time}{', '.join(ARRAYS[kind] for kind in kinds_of_all)} of "
            f"{len(joints)} joints, in rad{', with decimal commas' if commas else ''}"
        )
        return ColumnMap(
            times[0].string if times else None,
            joints,
            kinds_of_all.get("velocity"),
            kinds_of_all.get("effort"),
            unit or "s",
            separator=separator,
            decimal="," if commas else ".",
            name="columns by their names",
        )
    return None


def _lines(layout: "_Layout", reading: Reading) -> Iterator[tuple[int, int, list[float]]]:
    """Yield the number, timestamp in ns, and used cells of each line; titles are given to the layout.

    Raises:
        QuadrupedError: if the file cannot be read, has no row, lacks a column, or a line is damaged.
    """
    with opened(reading) as file:
        table = csv.reader(lines(file, reading), delimiter=layout.columns.separator, strict=True)
        try:
            for cells in table:
                if not layout.titles and layout.take_titles(cells):
                    continue
                if len(cells) != len(layout.titles):
                    raise reading.error(
                        table.line_num,
                        f"expected {len(layout.titles)} columns, as in the header; found {len(cells)}; "
                        f"the line is damaged or cut off: fix it, or keep the lines before it (--repair salvage)",
                    )
                reading.rows += 1
                try:
                    stamp = reading.rows - 1 if layout.stamp is None else layout.parse_stamp(cells[layout.stamp])
                    found = [layout.parse(cells[column]) for column in layout.used]
                    _ = array("q", [stamp])
                except (ValueError, OverflowError):
                    raise _bad_cell(cells, layout, table.line_num, reading) from None
                yield table.line_num, stamp, found
        except csv.Error as error:
            raise reading.error(table.line_num, f"{error}; fix the line") from error
    if not layout.titles:
        expected = "a line that names the columns, and rows" if layout.columns.has_header_line else "rows"
        raise reading.error(None, f"the file is empty; expected {expected}")
    if not reading.rows:
        raise reading.error(None, "there is a header and no row; the recording is empty, record again")


class _Layout:
    """The columns of a file, by a column map and, once its first line is read, by their titles."""

    def __init__(self, columns: ColumnMap, reading: Reading) -> None:
        self.columns = columns
        self.titles: list[str] = []
        self.stamp: int | None = None
        """Index of the column of the timestamp; without one, rows are 1 ns apart"""
        self.used: list[int] = []
        """Indices of all other columns that are read, kind by kind"""
        self._blanks = {mark.strip() for mark in columns.marks if isinstance(mark, str)}
        self._reading = reading

    def take_titles(self, first: list[str]) -> bool:
        """Find the columns by the cells of the first line. Returns False if that line is a row already."""
        columns = self.columns
        if columns.has_header_line:
            self.titles = [title.strip() for title in first]
        elif isinstance(columns.header, list):
            self.titles = columns.header
        else:
            self.titles = [f"column {number}" for number in range(1, len(first) + 1)]
        self.stamp = None if columns.stamp is None else self._index("stamp", columns.stamp)
        self.used = [
            self._index(ARRAYS[kind], given[name]) for kind, given in columns.columns.items() for name in columns.joints
        ]
        return columns.has_header_line

    def _index(self, key: str, column: Column) -> int:
        titles, columns, reading = self.titles, self.columns, self._reading
        if isinstance(column, int):
            if column > len(titles):
                raise reading.error(1, f"no column {column}, which {columns.name} {key} asks for; found {len(titles)}")
            return column - 1
        if titles.count(column) != 1:
            problem = f"{'no column' if column not in titles else 'two columns'} {short(column)}, which {columns.name}"
            found = ", ".join(short(title)[1:-1] for title in titles[:_MAX_SHOWN])
            found += ", ..." if len(titles) > _MAX_SHOWN else ""
            fix = "; if it is a row already, name the columns in the map (header = [...])"
            raise reading.error(1, f"{problem} {key} names; found {found}{fix if all(map(is_number, titles)) else ''}")
        return titles.index(column)

    def parse(self, text: str) -> float:
        """Return the number in a cell; NaN for a mark of a missing value. Raises ValueError for another text."""
        if self._blanks and text.strip() in self._blanks:
            self._reading.counted[MISSING] += 1
            return math.nan
        return parse_number(self._with_point(text))

    def parse_stamp(self, text: str) -> int:
        """Return the timestamp in a cell, ns. Raises ValueError if it is not one."""
        if "_" in text or not text.isascii():
            raise ValueError(text)
        if ":" in text:
            return _date_and_time(text.replace(",", "."))
        try:
            time = Decimal(self._with_point(text)).scaleb(STAMP_UNITS[self.columns.stamp_unit])
        except DecimalException as error:
            raise ValueError(text) from error
        # Before it is rounded: 1e999999999 has more digits than fit into memory.
        if not time.is_finite() or abs(time) >= 2**63 - 1:
            raise ValueError(text)
        return round(time)

    def _with_point(self, text: str) -> str:
        """Return a number with a decimal point. Raises ValueError for a point where the decimal sign is a comma."""
        if self.columns.decimal == ".":
            return text
        if "." in text:
            raise ValueError(text)
        return text.replace(",", ".")


def _bad_cell(cells: list[str], layout: _Layout, number: int, reading: Reading) -> QuadrupedError:
    """Return the error for the first invalid cell of a line."""
    for column in sorted({*layout.used} if layout.stamp is None else {layout.stamp, *layout.used}):
        is_stamp = column == layout.stamp
        try:
            _ = layout.parse_stamp(cells[column]) if is_stamp else layout.parse(cells[column])
        except (ValueError, OverflowError):
            form = f"a time in {layout.columns.stamp_unit}" if is_stamp else "a number"
            comma = re.fullmatch(r"\s*[-+]?\d+,\d+([eE][-+]?\d+)?\s*", cells[column])
            fix = ', or if this is a decimal comma, say so in a map (decimal = ",")' if comma else ""
            problem = f"{short(cells[column])} is not {form}; fix the value or delete the line{fix}"
            return QuadrupedError(f"{reading.name}: line {number}, {layout.titles[column]}: {problem}")
    raise AssertionError("every cell is valid")


def _date_and_time(text: str) -> int:
    """Return ns of a date and time of ISO 8601, UTC if it names no zone. Raises ValueError if it is not one."""
    found = re.fullmatch(r"(?P<whole>[^.]+:\d\d)(\.(?P<part>\d{1,9}))?(?P<zone>Z|[+-]\d\d:?\d\d)?", text.strip())
    if found is None:
        raise ValueError(text)
    time = datetime.fromisoformat(found["whole"] + (found["zone"] or "Z"))
    return int(time.timestamp()) * NS_PER_SECOND + int((found["part"] or "").ljust(9, "0"))
