"""Joint maps: another robot's joints as this robot's, as tables `[joints.<joint>]` of a TOML file.

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

A joint that several motors move, as in five-bar legs, has their factors instead of `source`:

    [joints.LF_hip_joint]
    sources = { m0 = 0.5, m1 = -0.5 }     # position = sign * scale / gear * (0.5 * m0 - 0.5 * m1) + offset

Velocities are combined in the same way, and efforts so that the power stays the same: the effort of a joint with
one source is the source's divided by `sign * scale / gear`. The map is for files (`retarget`) and for single messages
(`JointMap.to_joints`), as of live nodes, and back: `JointMap.to_sources` gives the sources that bring joints to their
targets.
"""

import json
import math
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from typing import Final, Literal, Self

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory.map_file import check_forms, check_keys, check_values, read_table
from quadruped_env.trajectory.rows import Rows
from quadruped_env.utils.arrays import Floats

_TURN: Final = 2.0 * math.pi
UNITS: Final = {"rad": 1.0, "deg": math.pi / 180.0, "turn": _TURN, "ticks": _TURN}
"""Unit of an angle -> rad; of ticks, all of a turn"""
VELOCITY_UNITS: Final = {**{f"{unit}/s": angle for unit, angle in UNITS.items()}, "rpm": math.pi / 30.0}
"""Unit of an angular velocity -> rad/s; of ticks per second, all of a turn"""


@dataclass(frozen=True)
class JointRule:
    """Conversion of joints of another robot to one of this robot: `sign * scale / gear * source + offset`."""

    source: str | None = None
    """Name of the other robot's joint; None keeps the joint at its offset"""
    sign: float = 1.0
    scale: float = 1.0
    offset: float = 0.0
    """In `unit`"""
    unit: Literal["rad", "deg", "turn", "ticks"] = "rad"
    """Of the source and the offset"""
    velocity_unit: Literal["rad/s", "deg/s", "turn/s", "ticks/s", "rpm"] | None = None
    """Of the source's velocity; None is `unit` per second"""
    effort_scale: float = 1.0
    """N m per unit of the source's effort"""
    sources: dict[str, float] | None = None
    """The other robot's joints -> their factors, instead of `source`"""
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
        """Return a map as it is given: itself, or the path of its TOML file."""
        return given if isinstance(given, JointMap) else cls.load(given)

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read a map from the tables `[joints.<joint>]` of a TOML file.

        Raises:
            QuadrupedError: if there is no such file or something in it is wrong; the message names the table.
        """
        rules = {}
        for joint, table in read_table(path, "joints").items():
            check_keys(table, JointRule, f"{path}: [joints.{joint}]")
            rules[joint] = JointRule(**table)
        return cls(rules, str(path))

    @property
    def sources(self) -> tuple[str, ...]:
        """The other robot's joints that are used, each once."""
        return tuple(dict.fromkeys(name for rule in self.rules.values() for name in rule.gears))

    @property
    def rates(self) -> Floats:
        """Velocity of each source, in its unit, where its position changes by one unit per second (sources,)."""
        factors = {name: rule.factors for rule in self.rules.values() for name in rule.gears}
        return np.array([factors[name][0] / factors[name][1] for name in self.sources])

    def limits(self, largest: float) -> dict[str, Floats]:
        """Return kind -> magnitude (sources,) of each source, in its unit, beyond which a joint is beyond `largest`.

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
    def _matrices(self) -> dict[str, Floats]:
        """Kind -> matrix (joints, sources) that turns values of the sources into values of the joints."""
        gears = np.array([[rule.gears.get(name, 0.0) for name in self.sources] for rule in self.rules.values()])

        def factors(of: Callable[[JointRule], float]) -> Floats:
            return np.array([[of(rule)] for rule in self.rules.values()])

        return {
            "position": gears * factors(lambda rule: rule.factors[0]),
            "velocity": gears * factors(lambda rule: rule.factors[1]),
            "effort": _inverse(gears).T * factors(lambda rule: rule.effort_scale),
        }

    @cached_property
    def _inverses(self) -> dict[str, Floats]:
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
    def _offsets(self) -> Floats:
        """Offsets of the joints, rad (joints,)."""
        return np.array([rule.offset * rule.factors[0] for rule in self.rules.values()])

    def to_joints(
        self, names: Sequence[str], values: Mapping[str, Floats], recording: str = "the message"
    ) -> dict[str, Floats]:
        """Return the values of this robot's joints from the other robot's.

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
        """Return another robot's rows on the joints of the map; see `to_joints`."""
        return replace(rows, names=tuple(self.rules), values=self.to_joints(rows.names, rows.values, recording))

    def to_sources(self, values: Mapping[str, Floats]) -> dict[str, Floats]:
        """Return the values of the other robot's joints from this robot's: the inverse of `to_joints`.

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
        """Return the map as TOML, which `load` reads."""
        lines = []
        for joint, rule in self.rules.items():
            lines.append(f"[joints.{json.dumps(joint)}]")
            for one in fields(rule):
                value = getattr(rule, one.name)
                if value != one.default:
                    if isinstance(value, Mapping):
                        pairs = (f"{json.dumps(name)} = {float(weight)!r}" for name, weight in value.items())
                        given = f"{{ {', '.join(pairs)} }}"
                    else:
                        given = json.dumps(value) if isinstance(value, str) else repr(float(value))
                    lines.append(f"{one.name} = {given}")
            lines.append("")
        return "\n".join(lines)


def _combined(matrix: Floats, values: Floats, missing: float) -> Floats:
    """Return a matrix (m, n) times values (..., n); `missing` for rows of zeros. A factor of 0 hides NaN."""
    if values.ndim == 1:
        # A single message, ten times faster than by rows.
        products = np.multiply(matrix, values, out=np.zeros_like(matrix), where=matrix != 0.0)
        return np.where(matrix.any(axis=1), products.sum(axis=1), missing)
    columns = []
    for row in matrix:
        used = np.flatnonzero(row)
        columns.append(sum(values[..., i] * row[i] for i in used) if len(used) else np.full(values.shape[:-1], missing))
    return np.stack(columns, axis=-1)


def _inverse(matrix: Floats) -> Floats:
    """Return the inverse of a matrix (m, n), by least squares where it has none; zeros for rows and columns of zeros.

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


def check_rule(where: str, rule: JointRule) -> None:
    """Raise a QuadrupedError unless all values of a rule are valid; the message names the key."""
    check_forms(where, rule)
    weights = rule.sources
    ticks = any("ticks" in unit for unit in rule.units)
    expected = {
        "source": ("the name of a joint", rule.source != ""),
        "sources": (
            "a table joint = factor, with factors other than 0, instead of source",
            weights is None or (rule.source is None and weights and all(name and w for name, w in weights.items())),
        ),
        "effort_scale": ("a number other than 0", rule.effort_scale),
        "sign": ("1 or -1", rule.sign in {1, -1}),
        "scale": ("a number above 0", rule.scale >= sys.float_info.min),
        "gear": ("a number above 0", rule.gear >= sys.float_info.min),
        "ticks_per_turn": (
            f"a number above 0 where a unit is in ticks, and only there (here {' and '.join(rule.units)})",
            rule.ticks_per_turn is None if not ticks else (rule.ticks_per_turn or 0.0) >= sys.float_info.min,
        ),
    }
    check_values(where, rule, expected)
    # A scale holds for the velocity, too, and a unit does not.
    hidden = [name for name, size in UNITS.items() if name != "rad" and math.isclose(rule.scale, size, rel_tol=1e-3)]
    if rule.velocity_unit is not None and rule.unit == "rad" and hidden:
        raise QuadrupedError(
            f"{where} scale: {rule.scale:g} is the unit {hidden[0]} in rad, and would multiply the velocity in "
            f'{rule.velocity_unit}, too; give unit = "{hidden[0]}" in its place'
        )
