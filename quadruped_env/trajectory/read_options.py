"""The options for reading a recording: one table for Python and for the command line.

To add an option, add a field to `ReadOptions`, its flag to `FLAGS`, and a keyword to `JointTrajectory.load`.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, Self

from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory.maps import ColumnMap, JointMap
from quadruped_env.trajectory.rows import KINDS

STAMPS: Final = ("header", "log")
"""Sources of a message's timestamp: its header, or the time at which it was recorded."""

FLAGS: Final[Mapping[str, Mapping[str, Any]]] = {
    "--topic": {
        "dest": "topic",
        "metavar": "A[,B,...]",
        "help": "topic of the joint states, for a bag or JSON lines that have several; several with --merge",
    },
    "--columns": {
        "dest": "columns",
        "type": Path,
        "metavar": "MAP.toml",
        "help": "map of the columns of a CSV: table [columns]",
    },
    "--map": {
        "dest": "joint_map",
        "type": Path,
        "metavar": "MAP.toml",
        "help": "map of another robot's joints to this one's: tables [joints.<joint>]",
    },
    "--names": {
        "dest": "names",
        "type": lambda text: text.split(","),
        "metavar": "A,B,...",
        "help": "names of the joints in their order, for messages without names; of a CSV, the names "
        "of its columns of positions",
    },
    "--degrees": {
        "dest": "degrees",
        "action": "store_const",
        "const": True,
        "help": "positions and velocities are in degrees: convert them",
    },
    "--radians": {
        "dest": "degrees",
        "action": "store_const",
        "const": False,
        "help": "positions and velocities are in rad, even if they look like degrees",
    },
    "--stamps": {
        "dest": "stamps",
        "metavar": "header|log|S",
        "help": "timestamps: those of the headers, the times at which a bag recorded the messages, or none of them but "
        "this time in s from row to row; default: header",
    },
    "--ignore": {
        "dest": "ignore",
        "action": "append",
        "choices": KINDS[1:],
        "help": "do not read these values; may be given twice",
    },
    "--unwrap": {
        "dest": "unwrap",
        "type": float,
        "nargs": "?",
        "const": 2.0 * math.pi,
        "metavar": "RAD",
        "help": "undo the jumps of encoders that begin again after this angle (default of the angle: a turn)",
    },
    **{
        f"--{name}": {"dest": name, "action": "store_true", "help": text}
        for name, text in (
            ("despike", "leave out rows in which a joint is elsewhere, if it is for a few rows"),
            ("merge", "make one row of messages that hold some of the robot's joints each"),
            ("sort", "sort the rows by timestamp"),
            (
                "drop",
                "leave out rows that cannot be used (timestamps that do not increase, NaN, other joints), and count "
                "them",
            ),
            ("salvage", "keep the readable part of a damaged file"),
        )
    },
}
"""Flag -> arguments of argparse's `add_argument`; flags of the same option exclude each other."""


@dataclass(frozen=True)
class ReadOptions:
    """Options of `JointTrajectory.load`, which describes them.

    Raises:
        QuadrupedError: if a value is unknown, or two options contradict each other.
    """

    topic: str | None = None
    columns: ColumnMap | None = None
    joint_map: JointMap | None = None
    names: tuple[str, ...] | None = None
    degrees: bool | None = None
    stamps: str | float = "header"
    ignore: tuple[str, ...] = ()
    unwrap: float | None = None
    despike: bool = False
    merge: bool = False
    sort: bool = False
    drop: bool = False
    salvage: bool = False

    def __post_init__(self) -> None:
        if self.stamps not in STAMPS and not 1e-6 <= (self.period or 0.0) <= 1e6:
            raise QuadrupedError(
                f"stamps: expected one of {', '.join(STAMPS)}, or the time from row to row, 1e-6 to 1e6 s; found "
                f"{self.stamps!r}"
            )
        if self.unwrap is not None and not 0.01 <= self.unwrap <= 1e3:
            raise QuadrupedError(f"unwrap: expected an angle from 0.01 to 1000 rad; found {self.unwrap!r}")
        for kind in self.ignore:
            if kind not in KINDS[1:]:
                raise QuadrupedError(f"ignore: expected {' or '.join(KINDS[1:])}; found {kind!r}")
        if self.degrees and self.joint_map is not None:
            for joint, rule in self.joint_map.rules.items():
                if rule.unit != "rad" or rule.velocity_unit is not None:
                    raise QuadrupedError(
                        f"{self.joint_map.name}: [joints.{joint}] has units of its own, so --degrees would "
                        f"convert them twice; leave --degrees out"
                    )

    @property
    def period(self) -> float | None:
        """Time from row to row, s, if it replaces the timestamps or there are none."""
        if self.stamps in STAMPS:
            return None if self.columns is None else self.columns.period
        try:
            return float(self.stamps)
        except (TypeError, ValueError):
            return None

    @classmethod
    def of(cls, **given: Any) -> Self:
        """Options as `JointTrajectory.load` takes them: a map may be the path of its TOML file."""
        for name, convert in (
            ("columns", ColumnMap.of),
            ("joint_map", JointMap.of),
            ("names", tuple),
            ("ignore", tuple),
        ):
            if given.get(name) is not None:
                given[name] = convert(given[name])
        return cls(**given)
