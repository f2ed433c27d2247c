"""The options for reading a recording on the command line, the same in every program that reads one."""

import argparse
from pathlib import Path
from typing import Any

from quadruped_env.trajectory.joint_trajectory import JointTrajectory
from quadruped_env.trajectory.read_options import FLAGS
from quadruped_env.utils.progress import Progress


def add_reading_options(parser: argparse.ArgumentParser) -> None:
    """Add the options to a parser; `reading_options` takes them from the parsed arguments."""
    group = parser.add_argument_group("reading")
    for name, flags in FLAGS.items():
        target = group if len(flags) == 1 else group.add_mutually_exclusive_group()
        for flag, arguments in flags.items():
            target.add_argument(flag, dest=name, default=None, **arguments)


def reading_options(args: argparse.Namespace) -> dict[str, Any]:
    """Keyword arguments of `JointTrajectory.load`: the options that were given."""
    given = {name: getattr(args, name) for name in FLAGS}
    return {name: value for name, value in given.items() if value is not None}


def load_with(path: Path, args: argparse.Namespace, progress: Progress | None = None) -> JointTrajectory:
    """Load a recording with the options of the command line."""
    return JointTrajectory.load(path, **reading_options(args), progress=progress)
