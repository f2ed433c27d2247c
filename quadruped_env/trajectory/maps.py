"""Maps of other robots' recordings, as TOML: columns of a CSV to joint states, and other joints to this robot's.

`[columns]` is a column map, `[joints.<joint>]` a joint map; a file may hold one of them or both.

    [columns]
    stamp = "time_start"                    # the column of the timestamp
    stamp_unit = "s"                        # s, ms, us or ns; default: "s"
    positions = ["flarm", "flfoot"]         # the columns of the positions, which also name the joints ...
    velocities = { flarm = "w3" }           # ... or joint = "column"; optional
    efforts = { flarm = "i3" }              # optional
    velocity_files = { "a.csv" = "v.csv" }  # file -> the file next to it with its velocities, in the same columns
    separator = ","                         # default: ","
    decimal = ","                           # decimal sign, usual next to separator = ";"; default: "."
    header = ["t", "q0", "q1"]              # names of all columns, for a file without a header line
    missing = [2.146e9, "-"]                # values that mean "no value": numbers, or texts such as ""

The first line names the columns, unless `header` does. Other columns are ignored. A column may also be given by its
number, 1 for the first:

    stamp = 1
    positions = { flarm = 2, flfoot = 5 }

Without a column of timestamps, `period = 0.02` is the time from row to row in s; it takes the place of `stamp`.

If all columns are given by number, the file is expected to have no header line; `header = true` says that it has one,
`header = false` that it does not.

A value is missing if it equals a number of `missing` once it is read as float64 (2146000000.0 equals 2.146e9), or a
text of it once the spaces around it are removed. It counts as not recorded and becomes NaN. An effort may be NaN; a row
with such a position or velocity is an error unless it is left out (`drop`) or the velocities are not read (`ignore`).
Timestamps are never missing. The notes say how many values were missing. Timestamps are decimals of any length, or
dates and times of ISO 8601 to the ns (UTC unless they name a zone), and are read exactly.

    [joints.LF_hip_joint]     # one table per joint of this robot
    source = "flarm"          # the other robot's joint; without it the joint stays at its offset
    sign = -1                 # 1 or -1; default: 1
    scale = 1.0               # above 0; default: 1
    gear = 9.0                # turns of the source per turn of the joint, if it is measured before a gear; default: 1
    offset = 35.0             # in `unit`; default: 0
    unit = "deg"              # of the source and the offset: "rad", "deg", "turn" or "ticks"; default: "rad"
    ticks_per_turn = 4096     # of an encoder, where a unit is in ticks
    velocity_unit = "rpm"     # of the source: "rad/s", "deg/s", "turn/s", "ticks/s", "rpm"; default: `unit` per second
    effort_scale = 0.65       # N m per unit of the source's effort, as for currents; default: 1

    position = sign * scale / gear * source + offset

Scale and gear hold for position and velocity, so a unit is no scale: with `scale = 6.2832` for turns, a velocity in rpm
would be 2 pi times too large.

A joint that several motors move, as in five-bar legs, has their factors in place of `source`:

    [joints.LF_hip_joint]
    sources = { m0 = 0.5, m1 = -0.5 }     # position = sign * scale / gear * (0.5 * m0 - 0.5 * m1) + offset

Velocities are combined in the same way, and efforts so that the power stays the same: that of a joint with one source
is the source's divided by `sign * scale / gear`. The map is for files (`retarget`) and for single messages
(`JointMap.to_joints`), as of live nodes, and back: `JointMap.to_sources` gives the sources that bring joints to their
targets.
"""

import json
import math
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Final, Self

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.trajectory.rows import ARRAYS, TORQUE_ONLY, Rows
from quadruped_env.utils.documents import read_toml
from quadruped_env.utils.parameters import is_quantity

STAMP_UNITS: Final = {"s": 9, "ms": 6, "us": 3, "ns": 0}
"""Unit of time -> its length in ns, as a power of ten."""
_TURN: Final = 2.0 * math.pi
UNITS: Final = {"rad": 1.0, "deg": math.pi / 180.0, "turn": _TURN, "ticks": _TURN}
"""Unit of an angle -> rad; of ticks, all of a turn"""
VELOCITY_UNITS: Final = {**{f"{unit}/s": angle for unit, angle in UNITS.items()}, "rpm": math.pi / 30.0}
"""Unit of an angular velocity -> rad/s; of ticks per second, all of a turn"""

_COLUMN_FORM: Final = "name or number from 1 on"

Column = str | int
"""Name of a column, or its number, 1 for the first"""
Columns = list[str] | dict[str, Column]
"""Names of columns, which are the joints' names too, or joint -> column"""
Mark = float | str
"""A value that means "no value": a number or a text"""


@dataclass(frozen=True)
class ColumnMap:
    """The columns of a CSV that hold a joint state; all keys are described above."""

    stamp: Column | None
    """Column of the timestamp; None without one"""
    positions: Columns
    velocities: Columns | None = None
    efforts: Columns | None = None
    stamp_unit: str = "s"
    velocity_files: dict[str, str] | None = None
    """Name of a file -> name of the file next to it that has its velocities, in the columns of `velocities`, by default
    in those of `positions`"""
    separator: str = ","
    decimal: str = "."
    """Decimal sign, a point or a comma"""
    header: list[str] | bool | None = None
    """Names of all columns, for a file without a header line; or whether there is a header line, which there is by
    default unless all columns are given by number"""
    missing: Mark | list[Mark] | None = None
    """Values that mean "no value"; they are read as NaN"""
    period: float | None = None
    """Time from row to row, s, without a column of timestamps"""
    name: str = "ColumnMap"
    """Name in error messages"""

    def __post_init__(self) -> None:
        files = {} if self.velocity_files is None else self.velocity_files
        unit, separator = self.stamp_unit, self.separator
        expected = {
            "stamp": (f"a column, {_COLUMN_FORM}", self.stamp is None or _is_column(self.stamp)),
            "period": (
                "a time of 1e-6 to 1e6 s, in place of stamp",
                self.period is None or (self.stamp is None and _is_finite(self.period) and 1e-6 <= self.period <= 1e6),
            ),
            "stamp_unit": (f"one of {', '.join(STAMP_UNITS)}", isinstance(unit, str) and unit in STAMP_UNITS),
            "separator": (
                "one character",
                isinstance(separator, str) and len(separator) == 1 and separator not in '"\n\r',
            ),
            "decimal": ('"." or ","', isinstance(self.decimal, str) and self.decimal in {".", ","}),
            "velocity_files": (
                "a table of files in the same directory",
                isinstance(files, dict)
                and all(isinstance(name, str) and Path(name).name == name for name in files.values()),
            ),
            "missing": (
                "a number, a text, or a list of them",
                all(isinstance(mark, str) or is_quantity(mark, -math.inf, math.inf) for mark in self.marks),
            ),
        }
        _check(self.name + ":", self, expected)
        if not self.joints:
            raise QuadrupedError(f"{self.name}: positions: name one column or more")
        for key in ARRAYS.values():
            columns = getattr(self, key)
            if columns is None:
                continue
            where = f"{self.name}: {key}"
            if not _are_columns(columns):
                raise QuadrupedError(
                    f"{where}: expected column names, or a table joint = column of {_COLUMN_FORM}s; found "
                    f"{short(columns)}"
                )
            if len(set(_joints(columns))) < len(columns) or set(_joints(columns)) != set(self.joints):
                raise QuadrupedError(
                    f"{where}: expected each joint once, those of the positions; found {', '.join(_joints(columns))}"
                )
        self._check_header()

    def _check_header(self) -> None:
        """Raise a QuadrupedError if `header` is invalid, or contradicts columns that are given by name."""
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
    def joints(self) -> tuple[str, ...]:
        """Names of the joints, in the order of their positions."""
        return tuple(_joints(self.positions))

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
        """A map as it is given: itself, or the path of its TOML file."""
        return given if isinstance(given, ColumnMap) else cls.load(given)

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read a map from the table `[columns]` of a TOML file.

        Raises:
            QuadrupedError: if there is no such file or something in it is wrong; the message names the key.
        """
        table = _table(read_toml(Path(path)), "columns", str(path))
        where = f"{path}: [columns]"
        _check_keys(table, (field.name for field in fields(cls) if field.name != "name"), where)
        if "positions" not in table:
            problem = TORQUE_ONLY if "efforts" in table else "add it"
            raise QuadrupedError(f"{where}: positions is missing; {problem}")
        return cls(**{"stamp": None, **table}, name=where)


@dataclass(frozen=True)
class JointRule:
    """Conversion of joints of another robot to one of this robot: `sign * scale / gear * source + offset`."""

    source: str | None = None
    """Name of the other robot's joint; None keeps the joint at its offset"""
    sign: float = 1.0
    scale: float = 1.0
    offset: float = 0.0
    """In `unit`"""
    unit: str = "rad"
    """Of the source and the offset"""
    velocity_unit: str | None = None
    """Of the source's velocity; None is `unit` per second"""
    effort_scale: float = 1.0
    """N m per unit of the source's effort"""
    sources: Mapping[str, float] | None = None
    """The other robot's joints -> their factors, in place of `source`"""
    gear: float = 1.0
    """Turns of the source per turn of the joint"""
    ticks_per_turn: float | None = None
    """Ticks of the source's encoder, for units in ticks"""

    @property
    def units(self) -> tuple[str, str]:
        """Units of the source's position and velocity."""
        return self.unit, self.velocity_unit or f"{self.unit}/s"

    @property
    def factors(self) -> tuple[float, float]:
        """Units of the source's position and velocity, in rad and rad/s."""
        position, velocity = self.units
        ticks = self.ticks_per_turn or 1.0
        return (
            UNITS[position] / (ticks if position == "ticks" else 1.0),
            VELOCITY_UNITS[velocity] / (ticks if velocity == "ticks/s" else 1.0),
        )

    @property
    def gears(self) -> dict[str, float]:
        """Source -> angle of the joint per angle of the source."""
        weights = self.sources or ({} if self.source is None else {self.source: 1.0})
        return {name: self.sign * self.scale * weight / self.gear for name, weight in weights.items()}


@dataclass(frozen=True)
class JointMap:
    """Conversion of another robot's joints to this one's."""

    rules: Mapping[str, JointRule]
    """Joint -> rule, in the order of the joints in the result"""
    name: str = "JointMap"
    """Name in error messages"""

    def __post_init__(self) -> None:
        if not self.rules:
            raise QuadrupedError(f"{self.name}: no joint is mapped; add one table [joints.<joint>] per joint")
        for joint, rule in self.rules.items():
            check_rule(f"{self.name}: [joints.{joint}]", rule)
        if not self.sources:
            raise QuadrupedError(f"{self.name}: no joint has a source; name the other robot's joints")
        first: dict[str, str] = {}
        for joint, rule in self.rules.items():
            for name in rule.gears:
                before = self.rules[first.setdefault(name, joint)]
                if rule.factors != before.factors:
                    raise QuadrupedError(
                        f"{self.name}: {name} is in {' and '.join(before.units)} for [joints.{first[name]}], and in "
                        f"{' and '.join(rule.units)} for [joints.{joint}]; give both the same unit, velocity_unit and "
                        f"ticks_per_turn"
                    )

    @classmethod
    def of(cls, given: "JointMap | str | Path") -> "JointMap":
        """A map as it is given: itself, or the path of its TOML file."""
        return given if isinstance(given, JointMap) else cls.load(given)

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read a map from the tables `[joints.<joint>]` of a TOML file.

        Raises:
            QuadrupedError: if there is no such file or something in it is wrong; the message names the table.
        """
        tables = _table(read_toml(Path(path)), "joints", str(path))
        rules = {}
        for joint, table in tables.items():
            where = f"{path}: [joints.{joint}]"
            _check_keys(table, (field.name for field in fields(JointRule)), where)
            rules[joint] = JointRule(**table)
        return cls(rules, str(path))

    @property
    def sources(self) -> tuple[str, ...]:
        """The other robot's joints that are used, each once."""
        return tuple(dict.fromkeys(name for rule in self.rules.values() for name in rule.gears))

    @property
    def rates(self) -> NDArray[np.float64]:
        """Velocity of each source, in its unit, where its position changes by one unit per second (sources,)."""
        factors = {name: rule.factors for rule in self.rules.values() for name in rule.gears}
        return np.array([factors[name][0] / factors[name][1] for name in self.sources])

    def limits(self, largest: float) -> dict[str, NDArray[np.float64]]:
        """Kind -> magnitude of each source, in its unit, beyond which a joint is certainly beyond `largest` (sources,).

        Args:
            largest: magnitude of the joints' positions and velocities, rad and rad/s.
        """
        bounds = {"position": largest + np.abs(self._offsets), "velocity": np.full(len(self.rules), largest)}
        with np.errstate(divide="ignore"):
            return {kind: (bound[:, None] / np.abs(self._matrices[kind])).min(axis=0) for kind, bound in bounds.items()}

    @property
    def periods(self) -> tuple[float, ...]:
        """Angles of the joints after which encoders of the sources begin again, rad; a turn is one of them."""
        angles = {round(abs(gear), 9) for rule in self.rules.values() for gear in rule.gears.values()} | {1.0}
        return tuple(2.0 * math.pi * angle for angle in sorted(angles, reverse=True) if angle > 0.05)

    @cached_property
    def _matrices(self) -> dict[str, NDArray[np.float64]]:
        """Kind -> matrix (joints, sources) by which values of the sources become those of the joints."""
        gears = np.array([[rule.gears.get(name, 0.0) for name in self.sources] for rule in self.rules.values()])

        def factors(of: Callable[[JointRule], float]) -> NDArray[np.float64]:
            return np.array([[of(rule)] for rule in self.rules.values()])

        return {
            "position": gears * factors(lambda rule: rule.factors[0]),
            "velocity": gears * factors(lambda rule: rule.factors[1]),
            "effort": _inverse(gears).T * factors(lambda rule: rule.effort_scale),
        }

    @cached_property
    def _inverses(self) -> dict[str, NDArray[np.float64]]:
        """Kind -> matrix (sources, joints) for the way back."""
        driven = [joint for joint, rule in self.rules.items() if rule.gears]
        matrix = self._matrices["position"]
        if len(driven) != len(self.sources) or np.linalg.matrix_rank(matrix) < len(driven):
            raise QuadrupedError(
                f"{self.name}: {len(driven)} joints with sources do not determine the {len(self.sources)} sources "
                f"{', '.join(self.sources)}, so nothing can be sent back; map as many joints, independent of each other"
            )
        return {kind: _inverse(matrix) for kind, matrix in self._matrices.items()}

    @property
    def _offsets(self) -> NDArray[np.float64]:
        """Offsets of the joints, rad (joints,)."""
        return np.array([rule.offset * rule.factors[0] for rule in self.rules.values()])

    def to_joints(
        self, names: Sequence[str], values: Mapping[str, NDArray[np.float64]], recording: str = "the message"
    ) -> dict[str, NDArray[np.float64]]:
        """Values of this robot's joints, from those of the other robot's.

        Args:
            names: of the other robot's joints, in the order of the columns; they may be more than the sources.
            values: kind (`position`, `velocity`, `effort`) -> array (..., len(names)), in the units of the map.
            recording: their origin, for errors.

        Returns:
            Kind -> array (..., joints) in rad, rad/s and N m, in the order of `rules`. Joints without a source are at
            their offset, at rest, and have no effort (NaN).

        Raises:
            QuadrupedError: if a source is missing.
        """
        for joint, rule in self.rules.items():
            for name in rule.gears:
                if name not in names:
                    raise QuadrupedError(
                        f"{self.name}: [joints.{joint}] source: {recording} has no joint {name!r}; "
                        f"it has {', '.join(names)}"
                    )
        order = [names.index(name) for name in self.sources]
        found = {
            kind: _combined(self._matrices[kind], array[..., order], np.nan if kind == "effort" else 0.0)
            for kind, array in values.items()
        }
        if "position" in found:
            found["position"] = found["position"] + self._offsets
        return found

    def retarget(self, rows: Rows, recording: str) -> Rows:
        """Another robot's rows on the joints of the map; see `to_joints`."""
        return replace(rows, names=tuple(self.rules), values=self.to_joints(rows.names, rows.values, recording))

    def to_sources(self, values: Mapping[str, NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
        """Values of the other robot's joints, from those of this robot's: the inverse of `to_joints`.

        Args:
            values: kind -> array (..., joints), in the order of `rules`.

        Returns:
            Kind -> array (..., sources) in the units of the map, in the order of `sources`.

        Raises:
            QuadrupedError: if the joints do not determine the sources.
        """
        moved = {kind: array - self._offsets if kind == "position" else array for kind, array in values.items()}
        return {kind: _combined(self._inverses[kind], array, np.nan) for kind, array in moved.items()}

    def text(self) -> str:
        """The map as TOML, which `load` reads."""
        lines = []
        for joint, rule in self.rules.items():
            lines.append(f"[joints.{json.dumps(joint)}]")
            for one in fields(rule):
                value = getattr(rule, one.name)
                if value != one.default:
                    pairs = value.items() if isinstance(value, Mapping) else ()
                    table = ", ".join(f"{json.dumps(name)} = {weight!r}" for name, weight in pairs)
                    given = json.dumps(value) if isinstance(value, str) else repr(value)
                    lines.append(f"{one.name} = {f'{{ {table} }}' if table else given}")
            lines.append("")
        return "\n".join(lines)


def _combined(matrix: NDArray[np.float64], values: NDArray[np.float64], missing: float) -> NDArray[np.float64]:
    """A matrix (m, n) times values (..., n); `missing` for rows of zeros. A factor of 0 hides NaN."""
    if values.ndim == 1:
        # A single message, ten times faster than by rows.
        products = np.multiply(matrix, values, out=np.zeros_like(matrix), where=matrix != 0.0)
        return np.where(matrix.any(axis=1), products.sum(axis=1), missing)
    columns = []
    for row in matrix:
        used = np.flatnonzero(row)
        columns.append(sum(values[..., i] * row[i] for i in used) if len(used) else np.full(values.shape[:-1], missing))
    return np.stack(columns, axis=-1)


def _inverse(matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    """The inverse of a matrix (m, n), by least squares where it has none; zeros for rows and columns of zeros.

    A row and a column that have a single number in common are inverted by division, without an error of rounding.
    """
    used = matrix != 0.0
    single = used & (used.sum(axis=0) == 1) & (used.sum(axis=1) == 1)[:, None]
    result = np.zeros(matrix.T.shape)
    result[single.T] = 1.0 / matrix.T[single.T]
    rest = np.where(single, 0.0, matrix)
    if rest.any():
        inverse = np.linalg.pinv(rest)
        result += np.where(np.abs(inverse) < 1e-12 * np.abs(inverse).max(), 0.0, inverse)
    return result


def _table(document: Mapping[str, Any], key: str, where: str) -> dict[str, Any]:
    """A table of a TOML document. Raises a QuadrupedError if the key is missing, or is not a table."""
    table = document.get(key)
    if not isinstance(table, dict):
        raise QuadrupedError(f"{where}: expected a table [{key}]; found {'none' if table is None else short(table)}")
    return table


def _check_keys(table: Any, known: Iterable[str], where: str) -> None:
    """Raise a QuadrupedError unless it is a table with known keys only."""
    names = tuple(known)
    if not isinstance(table, dict):
        raise QuadrupedError(f"{where}: expected a table; found {short(table)}")
    for key in table:
        if key not in names:
            raise QuadrupedError(f"{where}: unknown key {short(key)}; known are {', '.join(names)}")


def check_rule(where: str, rule: JointRule) -> None:
    """Raise a QuadrupedError unless all values of a rule are valid; the message names the key."""
    source, unit, velocity_unit, sources = rule.source, rule.unit, rule.velocity_unit, rule.sources
    expected = {
        "source": ("the name of a joint", source is None or (isinstance(source, str) and source)),
        "sources": (
            "a table joint = factor, with factors other than 0, in place of source",
            sources is None
            or (
                source is None
                and isinstance(sources, Mapping)
                and len(sources) > 0
                and all(isinstance(name, str) and name and _is_finite(w) and w != 0.0 for name, w in sources.items())
            ),
        ),
        "effort_scale": ("a number other than 0", _is_finite(rule.effort_scale) and rule.effort_scale != 0.0),
        "sign": ("1 or -1", _is_finite(rule.sign) and rule.sign in {1, -1}),
        "scale": ("a number above 0", _is_positive(rule.scale)),
        "gear": ("a number above 0", _is_positive(rule.gear)),
        "offset": ("a number", _is_finite(rule.offset)),
        "velocity_unit": (
            " or ".join(map(repr, VELOCITY_UNITS)),
            velocity_unit is None or (isinstance(velocity_unit, str) and velocity_unit in VELOCITY_UNITS),
        ),
        "unit": (" or ".join(map(repr, UNITS)), isinstance(unit, str) and unit in UNITS),
    }
    _check(where, rule, expected)
    if any("ticks" in one for one in rule.units) != (rule.ticks_per_turn is not None):
        raise QuadrupedError(
            f"{where} ticks_per_turn: expected the ticks of an encoder in a turn where a unit is in ticks, and only "
            f"there; found {short(rule.ticks_per_turn)} with {' and '.join(rule.units)}"
        )
    _check(
        where,
        rule,
        {"ticks_per_turn": ("a number above 0", rule.ticks_per_turn is None or _is_positive(rule.ticks_per_turn))},
    )
    # A scale holds for the velocity, too, and a unit does not.
    hidden = [name for name, size in UNITS.items() if name != "rad" and math.isclose(rule.scale, size, rel_tol=1e-3)]
    if velocity_unit is not None and unit == "rad" and hidden:
        raise QuadrupedError(
            f"{where} scale: {rule.scale:g} is the unit {hidden[0]} in rad, and would multiply the velocity in "
            f'{velocity_unit}, too; give unit = "{hidden[0]}" in its place'
        )


def _check(where: str, checked: object, expected: Mapping[str, tuple[str, object]]) -> None:
    """Raise a QuadrupedError for the first field that is not as expected: field -> description, whether it holds."""
    for key, (wanted, holds) in expected.items():
        if not holds:
            raise QuadrupedError(f"{where} {key}: expected {wanted}; found {short(getattr(checked, key))}")


def _is_column(value: object) -> bool:
    return value != "" if isinstance(value, str) else type(value) is int and value >= 1


def _are_columns(given: Any) -> bool:
    """True for columns of joints; in a list they also name the joints and therefore must not be numbers."""
    if isinstance(given, dict):
        return all(map(_is_column, given.values()))
    return isinstance(given, list) and all(isinstance(column, str) and column for column in given)


def _joints(given: Any) -> list[str]:
    return list(given) if isinstance(given, (list, dict)) else []


def _is_positive(value: object) -> bool:
    return is_quantity(value, sys.float_info.min, sys.float_info.max)


def _is_finite(value: object) -> bool:
    return is_quantity(value, -sys.float_info.max, sys.float_info.max)
