"""The options for reading a recording: one table for Python and for the command line.

To add an option, add a field to `ReadOptions`, and a keyword to `JointTrajectory.load`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any, Final, Self

from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory.maps import ColumnMap, JointMap
from quadruped_env.trajectory.rows import KINDS

STAMPS: Final = ("header", "log")
"""Sources of a message's timestamp: its header, or the time at which it was recorded."""


def _flag(name: str, **arguments: Any) -> dict[str, dict[str, Any]]:
    """A flag of the command line, with arguments of argparse's `add_argument`."""
    return {name: arguments}


def _option(flags: Mapping[str, Mapping[str, Any]], convert: Callable[[Any], Any] | None = None) -> dict[str, Any]:
    """Metadata of an option: its flags, which exclude each other, and a conversion of the value that a user gives."""
    return {"flags": flags, "convert": convert}


@dataclass(frozen=True)
class ReadOptions:
    """Options of `JointTrajectory.load`, which describes them.

    Raises:
        QuadrupedError: if a value is unknown, or two options contradict each other.
    """

    topic: str | None = field(
        default=None,
        metadata=_option(_flag("--topic", help="topic of the joint states, for a bag that has several")),
    )
    columns: ColumnMap | None = field(
        default=None,
        metadata=_option(
            _flag("--columns", type=Path, metavar="MAP.toml", help="map of the columns of a CSV: table [columns]"),
            ColumnMap.of,
        ),
    )
    joint_map: JointMap | None = field(
        default=None,
        metadata=_option(
            _flag(
                "--map",
                type=Path,
                metavar="MAP.toml",
                help="map of another robot's joints to this one's: tables [joints.<joint>]",
            ),
            JointMap.of,
        ),
    )
    names: tuple[str, ...] | None = field(
        default=None,
        metadata=_option(
            _flag(
                "--names",
                type=lambda text: text.split(","),
                metavar="A,B,...",
                help="names of the joints in their order, for messages with positions and without names",
            ),
            tuple,
        ),
    )
    degrees: bool | None = field(
        default=None,
        metadata=_option(
            _flag(
                "--degrees",
                action="store_const",
                const=True,
                help="positions and velocities are in degrees: convert them",
            )
            | _flag(
                "--radians",
                action="store_const",
                const=False,
                help="positions and velocities are in rad, even if they look like degrees",
            )
        ),
    )
    stamps: str = field(
        default="header",
        metadata=_option(
            _flag(
                "--stamps",
                choices=STAMPS,
                help="timestamp of a message: its header's, or the time at which a bag recorded it; default: header",
            )
        ),
    )
    ignore: tuple[str, ...] = field(
        default=(),
        metadata=_option(
            _flag("--ignore", action="append", choices=KINDS[1:], help="do not read these values; may be given twice"),
            tuple,
        ),
    )
    sort: bool = field(
        default=False, metadata=_option(_flag("--sort", action="store_true", help="sort the rows by timestamp"))
    )
    drop: bool = field(
        default=False,
        metadata=_option(
            _flag(
                "--drop",
                action="store_true",
                help="leave out rows that cannot be used (timestamps that do not increase, NaN, other joints), and "
                "count them",
            )
        ),
    )
    salvage: bool = field(
        default=False,
        metadata=_option(_flag("--salvage", action="store_true", help="keep the readable part of a damaged file")),
    )

    def __post_init__(self) -> None:
        if self.stamps not in STAMPS:
            raise QuadrupedError(f"stamps: expected one of {', '.join(STAMPS)}; found {self.stamps!r}")
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

    @classmethod
    def of(cls, **given: Any) -> Self:
        """Options as `JointTrajectory.load` takes them: a map may be the path of its TOML file.

        Raises:
            QuadrupedError: if a map or an option is wrong.
        """
        for option in fields(cls):
            convert, value = option.metadata["convert"], given.get(option.name)
            if convert is not None and value is not None:
                given[option.name] = convert(value)
        return cls(**given)
