"""Maps from another robot's joints to this one's, as TOML.

    [joints.LF_hip_joint]     # a table a joint of this robot
    source = "flarm"          # the other robot's joint; without it the joint stays at its offset
    sign = -1                 # 1 or -1; 1 unless given
    scale = 1.0               # above 0; 1 unless given
    offset = 35.0             # in `unit`; 0 unless given
    unit = "deg"              # of the source and the offset: "rad" or "deg"; "rad" unless given
    velocity_unit = "rpm"     # of the source's velocity: "rad/s", "deg/s" or "rpm"; `unit` a second unless given

    position = sign * scale * source + offset

Velocities are multiplied likewise. Efforts are divided by `sign * scale`, which keeps the power.
"""

import math
import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Final, Self

from quadruped_env.documents import read_toml
from quadruped_env.errors import QuadrupedError, short

UNITS: Final = {"rad": 1.0, "deg": math.pi / 180.0}
"""Unit of an angle -> rad"""
VELOCITY_UNITS: Final = {"rad/s": 1.0, "deg/s": math.pi / 180.0, "rpm": math.pi / 30.0}
"""Unit of an angular velocity -> rad/s"""


@dataclass(frozen=True)
class JointRule:
    """How one joint follows one of another robot: `sign * scale * source + offset`."""

    source: str | None = None
    """Name of the other robot's joint; None keeps the joint at its offset"""
    sign: float = 1.0
    scale: float = 1.0
    offset: float = 0.0
    """In `unit`"""
    unit: str = "rad"
    """Of the source and the offset"""
    velocity_unit: str | None = None
    """Of the source's velocity; None is `unit` a second"""

    @property
    def gear(self) -> float:
        """How far the joint turns when the source turns by 1."""
        return self.sign * self.scale

    @property
    def factor(self) -> float:
        """What a position of the source is multiplied with to give rad."""
        return self.gear * UNITS[self.unit]

    @property
    def velocity_factor(self) -> float:
        """What a velocity of the source is multiplied with to give rad/s."""
        return self.gear * VELOCITY_UNITS[self.velocity_unit or f"{self.unit}/s"]

    @property
    def offset_rad(self) -> float:
        """The offset in rad."""
        return self.offset * UNITS[self.unit]


@dataclass(frozen=True)
class JointMap:
    """How every joint of one robot follows those of another."""

    rules: Mapping[str, JointRule]
    """Joint -> rule, in the order of the joints in the result"""
    name: str = "JointMap"
    """What errors call it"""

    def __post_init__(self) -> None:
        if not self.rules:
            raise QuadrupedError(f"{self.name}: no joint is mapped; give a table [joints.<joint>] for each")
        for joint, rule in self.rules.items():
            _check_rule(f"{self.name}: [joints.{joint}]", rule)
        if not self.sources:
            raise QuadrupedError(f"{self.name}: no joint has a source; name the other robot's joints")

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read a map from the tables `[joints.<joint>]` of a TOML file.

        Raises:
            QuadrupedError: if there is no such file or something in it is wrong; the message names the table.
        """
        tables = table_of(read_toml(Path(path)), "joints", str(path))
        rules = {}
        for joint, table in tables.items():
            where = f"{path}: [joints.{joint}]"
            check_keys(table, (field.name for field in fields(JointRule)), where)
            rules[joint] = JointRule(**table)
        return cls(rules, str(path))

    @property
    def sources(self) -> tuple[str, ...]:
        """The other robot's joints that are used, each once."""
        return tuple(dict.fromkeys(rule.source for rule in self.rules.values() if rule.source is not None))


def table_of(document: Mapping[str, Any], key: str, where: str) -> dict[str, Any]:
    """A table of a TOML document.

    Raises:
        QuadrupedError: if it is not there, or no table.
    """
    table = document.get(key)
    if not isinstance(table, dict):
        raise QuadrupedError(f"{where}: expected a table [{key}]; found {'none' if table is None else short(table)}")
    return table


def check_keys(table: Any, known: Iterable[str], where: str) -> None:
    """Raise a QuadrupedError unless it is a table with none but the known keys."""
    names = tuple(known)
    if not isinstance(table, dict):
        raise QuadrupedError(f"{where}: expected a table; found {short(table)}")
    for key in table:
        if key not in names:
            raise QuadrupedError(f"{where}: unknown key {short(key)}; known are {', '.join(names)}")


def _check_rule(where: str, rule: JointRule) -> None:
    expected = {
        "source": ("the name of a joint", rule.source is None or (isinstance(rule.source, str) and rule.source)),
        "sign": ("1 or -1", _is_number(rule.sign) and rule.sign in {1, -1}),
        "scale": ("a number above 0", _is_number(rule.scale) and rule.scale > 0.0),
        "offset": ("a number", _is_number(rule.offset)),
        "velocity_unit": (
            " or ".join(map(repr, VELOCITY_UNITS)),
            rule.velocity_unit is None
            or (isinstance(rule.velocity_unit, str) and rule.velocity_unit in VELOCITY_UNITS),
        ),
        "unit": (" or ".join(map(repr, UNITS)), isinstance(rule.unit, str) and rule.unit in UNITS),
    }
    for key, (wanted, holds) in expected.items():
        if not holds:
            raise QuadrupedError(f"{where} {key}: expected {wanted}; found {short(getattr(rule, key))}")


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= sys.float_info.max
