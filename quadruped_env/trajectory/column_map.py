"""Column maps: which columns of a CSV hold joint states, as the table `[columns]` of a TOML file.

    [columns]
    stamp = "time_start"                    # the column of the timestamp
    stamp_unit = "s"                        # s, ms, us or ns; default: "s"
    period = 0.02                           # instead of stamp: the time from row to row, s
    positions = ["flarm", "flfoot"]         # the columns of the positions, which also name the joints ...
    velocities = { flarm = "w3" }           # ... or joint = "column"; optional
    efforts = { flarm = "i3" }              # optional
    velocity_files = { "a.csv" = "v.csv" }  # file -> the file next to it with its velocities, in the columns of
                                            # velocities or positions
    separator = ","                         # default: ","
    decimal = ","                           # decimal sign, usual next to separator = ";"; default: "."
    header = ["t", "q0", "q1"]              # names of all columns, for a file without a header line
    missing = [2.146e9, "-"]                # values that mean "no value": numbers, or texts such as ""

The first line names the columns, unless `header` does. Other columns are ignored. A column may also be given by its
number, 1 for the first: `stamp = 1`, `positions = { flarm = 2, flfoot = 5 }`. If all columns are given by number, the
file is expected to have no header line; `header = true` says that it has one, `header = false` that it does not.

A value is missing if it equals a number of `missing` once it is read as float64 (2146000000.0 equals 2.146e9), or a
text of it once the spaces around it are removed. It counts as not recorded and becomes NaN. An effort may be NaN; a row
with such a position or velocity is an error unless it is left out (`drop`) or the velocities are not read (`ignore`).
Timestamps are never missing. The notes say how many values were missing. Timestamps are decimals of any length, or
dates and times of ISO 8601 to the ns (UTC unless they name a zone), and are read exactly.
"""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, Literal, Self

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.trajectory.map_file import check_forms, check_keys, check_values, read_table
from quadruped_env.trajectory.rows import ARRAYS, TORQUE_ONLY
from quadruped_env.utils.parameters import is_quantity

STAMP_UNITS: Final = {"s": 9, "ms": 6, "us": 3, "ns": 0}
"""Unit of time -> its length in ns, as a power of ten."""

Column = str | int
"""Name of a column, or its number, 1 for the first."""
Columns = list[str] | dict[str, Any]
"""Names of columns, which are the joints' names too, or joint -> column."""


@dataclass(frozen=True)
class ColumnMap:
    """The columns of a CSV that hold a joint state; the keys of `[columns]`.

    Raises:
        QuadrupedError: if a value is invalid; the message names the key.
    """

    stamp: Column | None
    positions: Columns
    velocities: Columns | None = None
    efforts: Columns | None = None
    stamp_unit: Literal["s", "ms", "us", "ns"] = "s"
    velocity_files: dict[str, str] | None = None
    separator: str = ","
    decimal: Literal[".", ","] = "."
    header: list[str] | bool | None = None
    missing: float | str | list[Any] | None = None
    period: float | None = None
    name: str = "ColumnMap"
    """Name in error messages."""

    def __post_init__(self) -> None:
        check_forms(self.name, self)
        column = "a name, or a number from 1 on"
        expected = {
            "stamp": (column, self.stamp is None or _is_column(self.stamp)),
            "period": (
                "a time of 1e-6 to 1e6 s, instead of stamp",
                self.period is None or (self.stamp is None and 1e-6 <= self.period <= 1e6),
            ),
            "separator": ("one character", len(self.separator) == 1 and self.separator not in '"\n\r'),
            "velocity_files": (
                "files in the same directory",
                all(Path(name).name == name for name in (self.velocity_files or {}).values()),
            ),
            "missing": (
                "numbers or texts",
                all(isinstance(mark, str) or is_quantity(mark, -math.inf, math.inf) for mark in self.marks),
            ),
            "header": (
                "the names of all columns",
                not isinstance(self.header, list) or (self.header and all(self.header)),
            ),
        }
        for kind, columns in self.columns.items():
            given = getattr(self, ARRAYS[kind])
            once = set(given) == set(self.joints) and len(set(given)) == len(given) > 0
            wanted = f"each joint of the positions once, and as a column {column}"
            expected[ARRAYS[kind]] = wanted, once and all(map(_is_column, columns.values()))
        check_values(self.name, self, expected)
        named = next((column for column in self.used if isinstance(column, str)), None)
        if self.header is False and named is not None:
            raise QuadrupedError(
                f"{self.name}: column {short(named)} is given by name, and header = false says that no line names the "
                f"columns; give its number, or the names of all columns (header = [...])"
            )

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints, in the order of their positions."""
        return tuple(self.positions)

    @property
    def columns(self) -> dict[str, dict[str, Column]]:
        """Kind -> joint -> column, of the kinds that are given."""
        given = {kind: getattr(self, key) for kind, key in ARRAYS.items()}
        return {
            kind: columns if isinstance(columns, dict) else {column: column for column in columns}
            for kind, columns in given.items()
            if columns is not None
        }

    @property
    def used(self) -> list[Column]:
        """All columns that are read."""
        stamp = [] if self.stamp is None else [self.stamp]
        return [*stamp, *(column for columns in self.columns.values() for column in columns.values())]

    @property
    def has_header_line(self) -> bool:
        """True if the first line of the file names its columns."""
        if self.header is None:
            return any(isinstance(column, str) for column in self.used)
        return self.header is True

    @property
    def marks(self) -> list[Any]:
        """The values that mean "no value"."""
        if self.missing is None:
            return []
        return self.missing if isinstance(self.missing, list) else [self.missing]

    @classmethod
    def of(cls, given: "ColumnMap | str | Path") -> "ColumnMap":
        """Return a map as it is given: itself, or the path of its TOML file."""
        return given if isinstance(given, ColumnMap) else cls.load(given)

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read a map from the table `[columns]` of a TOML file.

        Raises:
            QuadrupedError: if there is no such file or something in it is wrong; the message names the key.
        """
        table, where = read_table(path, "columns"), f"{path}: [columns]"
        check_keys(table, cls, where)
        if "positions" not in table:
            problem = TORQUE_ONLY if "efforts" in table else "add it"
            raise QuadrupedError(f"{where}: positions is missing; {problem}")
        return cls(**{"stamp": None, **table}, name=where)


def _is_column(value: object) -> bool:
    return value != "" if isinstance(value, str) else type(value) is int and value >= 1
