"""The options of the command line for reading a recording: the same in every program that reads one."""

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any

from quadruped_env.trajectory.joint_trajectory import JointTrajectory
from quadruped_env.trajectory.reading import KINDS, STAMPS


def add_reading_options(parser: argparse.ArgumentParser) -> None:
    """Add the options to a parser; `reading_options` takes them from what it parsed."""
    group = parser.add_argument_group("reading")
    group.add_argument("--topic", help="of the joint states in a bag that has several")
    group.add_argument(
        "--columns", type=Path, metavar="MAP.toml", help="says which columns of a CSV are what: table [columns]"
    )
    group.add_argument(
        "--map",
        type=Path,
        metavar="MAP.toml",
        help="takes another robot's joints to this one's: tables [joints.<joint>]",
    )
    group.add_argument(
        "--names", metavar="A,B,...", help="the joints in their order, for messages that have positions and no names"
    )
    units = group.add_mutually_exclusive_group()
    units.add_argument(
        "--degrees", action="store_true", default=None, help="convert positions and velocities from degrees"
    )
    units.add_argument(
        "--radians", dest="degrees", action="store_false", help="they are rad, however much they look like degrees"
    )
    group.add_argument(
        "--stamps",
        choices=STAMPS,
        default="header",
        help="of a message: its header's, or the time at which a bag's log has it; default: header",
    )
    group.add_argument(
        "--ignore", action="append", choices=KINDS[1:], default=[], help="do not read it; may be given twice"
    )
    group.add_argument("--sort", action="store_true", help="put rows in the order of their stamps")
    group.add_argument(
        "--drop",
        action="store_true",
        help="leave out rows that cannot be used (stamps that do not rise, NaN, other joints), and count them",
    )
    group.add_argument("--salvage", action="store_true", help="keep what can be read of a damaged file")


def reading_options(args: argparse.Namespace) -> dict[str, Any]:
    """Keyword arguments of `JointTrajectory.load`."""
    return {
        "topic": args.topic,
        "columns": args.columns,
        "joint_map": args.map,
        "names": None if args.names is None else tuple(args.names.split(",")),
        "degrees": args.degrees,
        "stamps": args.stamps,
        "ignore": tuple(args.ignore),
        "sort": args.sort,
        "drop": args.drop,
        "salvage": args.salvage,
    }


def load_with(path: Path, args: argparse.Namespace, progress: Callable[[float], None] | None = None) -> JointTrajectory:
    """Load a recording as the options say."""
    return JointTrajectory.load(path, **reading_options(args), progress=progress)
