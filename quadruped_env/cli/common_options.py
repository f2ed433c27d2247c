"""Options that several commands have in common: the same name and meaning in each."""

import argparse
import math
import shlex
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.comparison import NUM_SEEDS
from quadruped_env.evaluation.rollout import DEFAULT_SECONDS
from quadruped_env.policies.files import DEFAULT, SHIPPED
from quadruped_env.report.films.film import Clip
from quadruped_env.report.films.video import SUFFIXES, save_film
from quadruped_env.simulation.built_in_terrains import NAMES, TERRAINS, find_terrain
from quadruped_env.simulation.terrain import LEVELS, Terrain
from quadruped_env.task import PRESETS
from quadruped_env.trajectory.joint_trajectory import JointTrajectory
from quadruped_env.trajectory.reading import REPAIRS, UNITS, ReadOptions
from quadruped_env.utils.files import shown_argument
from quadruped_env.utils.program import Extras
from quadruped_env.utils.progress import Progress, ProgressLine

NEXT_FREE: Final = "or that name with the next free number"
SHIPPED_POLICIES: Final = f"{', '.join(SHIPPED[:-1])} or {SHIPPED[-1]}"
"""Names of the shipped policies, for a help text."""


def add_run(parser: argparse.ArgumentParser, shipped: str = DEFAULT) -> None:
    """Add the policy to read, `RUN`; the shipped one is read where there is no run."""
    text = (
        f"a run's directory, {SHIPPED_POLICIES}, which ship, or a Python file of a policy, which is executed (default: "
        f"runs/latest, or {shipped})"
    )
    parser.add_argument("run", nargs="?", metavar="RUN", help=text)


def add_output(parser: argparse.ArgumentParser, metavar: str, text: str, default: Path | None = None) -> None:
    """Add `-o`, `--output`: where results are written."""
    parser.add_argument("-o", "--output", type=Path, metavar=metavar, default=default, help=text)


def add_overwrite(parser: argparse.ArgumentParser, text: str = "replace files that exist") -> None:
    """Add `--overwrite`."""
    parser.add_argument("--overwrite", action="store_true", help=text)


def add_video(parser: argparse.ArgumentParser) -> None:
    """Add `--video`."""
    parser.add_argument(
        "--video",
        type=Path,
        metavar="FILE",
        help=f"also film the robot, as {' or '.join(SUFFIXES)}",
    )


def save_video(path: Path | None, clips: Callable[[], Sequence[Clip]], extras: Extras) -> None:
    """Write the film of `--video`, if it was given, and print where it is."""
    if path is not None:
        with extras.part(str(path)):
            save_film(path, clips(), ProgressLine("filming"))
            print(f"video:   {path}")


def add_task_file(parser: argparse.ArgumentParser) -> None:
    """Add `--task` and `--trust-task`, for commands that read policies."""
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        "--task",
        type=Path,
        metavar="FILE",
        help="Python file of the terms or the robot that a run was trained with, if it was, also another version of "
        "it; it is executed (docs/make-it-yours.md)",
    )
    add_trust_task(group, "execute the copy of that file that the run keeps instead of --task FILE")


def add_trust_task(parser: argparse._ActionsContainer, text: str) -> None:
    """Add `--trust-task`."""
    parser.add_argument("--trust-task", action="store_true", help=text)


def add_robot_file(parser: argparse.ArgumentParser, terrain: bool = False) -> None:
    """Add `--task`, for commands that need the robot alone, or the robot and its terrain."""
    other = "another robot or terrain than the built-in ones" if terrain else "another robot than the built-in one"
    parser.add_argument(
        "--task",
        type=Path,
        metavar="FILE",
        help=f"Python file that defines {other}; it is executed (docs/make-it-yours.md)",
    )


def add_terrain(parser: argparse.ArgumentParser, default: str, level: bool = True) -> None:
    """Add `--terrain` and, unless `level` is false, `--level`; `default` is the ground without them, in words."""
    parser.add_argument(
        "--terrain",
        metavar="NAME",
        help=f"the ground: {NAMES} (docs/environment.md), or one from --task's file (default: {default})",
    )
    if not level:
        parser.set_defaults(level=None)
        return
    parser.add_argument(
        "--level",
        type=int,
        metavar="N",
        help=f"level of the --terrain, from 1 to {LEVELS}, which is the hardest (default: none; docs/environment.md)",
    )


def named_terrain(arguments: argparse.Namespace) -> str | Terrain | None:
    """Return the terrain of `--terrain` and `--level`, with the file of `--task`; its name without level and file.

    Raises:
        QuadrupedError: if the file has no such terrain or cannot be loaded, or there is no such level.
    """
    name: str | None = arguments.terrain
    check_level_has_terrain(arguments)
    if name is None or (arguments.task is None and arguments.level is None):
        return name
    from quadruped_env.task import load_task_file

    terrain = find_terrain(name, TERRAINS if arguments.task is None else load_task_file(arguments.task).terrains)
    return terrain if arguments.level is None else terrain.variant(level=arguments.level)


def check_level_has_terrain(arguments: argparse.Namespace) -> None:
    """Raise a QuadrupedError for `--level` without `--terrain`."""
    if arguments.level is not None and arguments.terrain is None:
        raise QuadrupedError(f"--level: found {arguments.level} without --terrain; name the terrain, too")


def add_randomization(parser: argparse.ArgumentParser, default: str) -> None:
    """Add `--randomization`; `default` is the randomization without it, in words."""
    parser.add_argument(
        "--randomization",
        choices=tuple(PRESETS),
        metavar="PRESET",
        help=f"randomization of the episodes: {', '.join(PRESETS)} (default: {default}; docs/environment.md)",
    )


def task_option(arguments: argparse.Namespace) -> str:
    """Return the option `--task` or `--trust-task` as a user types it again, and a space; nothing without a file."""
    if arguments.trust_task:
        return "--trust-task "
    return "" if arguments.task is None else f"--task {shlex.quote(shown_argument(str(arguments.task)))} "


def evaluation_options(arguments: argparse.Namespace) -> str:
    """Return the options of an evaluation that change its numbers, as a user types them again."""
    terrain = "" if arguments.terrain is None else f"--terrain {shlex.quote(arguments.terrain)} "
    level = "" if arguments.level is None else f"--level {arguments.level} "
    preset = "" if arguments.randomization is None else f"--randomization {arguments.randomization} "
    seed = "" if arguments.seed is None else f"--seed {arguments.seed} "
    suite = f"--suite {'--quick ' if arguments.quick else ''}{seed}" if arguments.suite else ""
    episodes = f"--seeds {arguments.seeds} --seconds {arguments.seconds:g}"
    return f"{task_option(arguments)}{terrain}{level}{preset}{suite}{episodes}"


def add_suite(parser: argparse.ArgumentParser, does: str) -> None:
    """Add `--suite`, which `does` something in words, and its options."""
    parser.add_argument("--suite", action="store_true", help=f"{does} (docs/suite.md)")
    parser.add_argument(
        "--quick",
        action="store_true",
        help="with --suite: few episodes, to see whether it works; never comparable with the full suite",
    )
    parser.add_argument(
        "--seed",
        type=int,
        metavar="N",
        help="with --suite: the seed of its episodes, which suite.json notes, to repeat or pair them (default: drawn)",
    )


def check_suite(arguments: argparse.Namespace) -> None:
    """Raise a QuadrupedError for options of the suite without it, or a seed that it does not have."""
    for option, given in (("--quick", arguments.quick), ("--seed", arguments.seed is not None)):
        if given and not arguments.suite:
            raise QuadrupedError(f"{option}: found without --suite, whose episodes it changes; give both")
    if arguments.seed is not None:
        from quadruped_env.evaluation.suite.suite_definition import full_suite

        full_suite().seeded(arguments.seed)


def add_evaluation_options(parser: argparse.ArgumentParser, default_output: str) -> None:
    """Add the options of commands that write a report; without `--output` it goes to `default_output`, in words."""
    parser.add_argument(
        "--seeds", type=int, default=NUM_SEEDS, metavar="N", help="episodes per command (default: %(default)s)"
    )
    parser.add_argument(
        "--seconds",
        type=float,
        default=DEFAULT_SECONDS,
        metavar="S",
        help="length of an episode, s (default: %(default)g)",
    )
    add_task_file(parser)
    add_terrain(parser, "the policy's own")
    add_randomization(parser, "none")
    add_output(parser, "DIR", f"directory of the report (default: {default_output})")


_READING: Final[Mapping[str, Mapping[str, Any]]] = {
    "--topic": {"metavar": "A[,B,...]", "help": "topic of the joint states, for a bag that has several"},
    "--columns": {"metavar": "MAP.toml", "help": "map of the columns of a CSV: table [columns]"},
    "--map": {
        "dest": "joint_map",
        "metavar": "MAP.toml",
        "help": "map of another robot's joints to this one's: tables [joints.<joint>]",
    },
    "--names": {
        "metavar": "A,B,...",
        "type": lambda text: text.split(","),
        "help": "names of the joints in their order, for messages without names; of a CSV, the names of its columns of "
        "positions",
    },
    "--unit": {
        "choices": UNITS,
        "help": "of positions and velocities: deg converts them, rad takes them as they are, even if they look like "
        "degrees",
    },
    "--stamps": {
        "metavar": "header|log|S",
        "help": "timestamps: from the headers, from the times at which a bag recorded the messages, or neither but "
        "this time in s from row to row; default: header",
    },
    "--ignore": {
        "metavar": "KIND[,KIND]",
        "type": lambda text: text.split(","),
        "help": "do not read these values: velocity, effort",
    },
    "--unwrap": {
        "type": float,
        "nargs": "?",
        "const": 2.0 * math.pi,
        "metavar": "RAD",
        "help": "undo the jumps of encoders that begin again after this angle (default of the angle: a turn)",
    },
    "--repair": {
        "metavar": "WHAT[,WHAT...]",
        "type": lambda text: text.split(","),
        "help": "; ".join(f"{name}: {text}" for name, text in REPAIRS.items()),
    },
}
"""Flag -> arguments of argparse's `add_argument`; the destination is a field of `ReadOptions`."""


def add_reading_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `ReadOptions` to a parser; `reading_options` takes them from the parsed arguments."""
    group = parser.add_argument_group("reading")
    for flag, arguments in _READING.items():
        group.add_argument(flag, **arguments)


def reading_options(args: argparse.Namespace) -> dict[str, Any]:
    """Keyword arguments of `JointTrajectory.load`: the options that were given."""
    given = {field.name: getattr(args, field.name) for field in fields(ReadOptions)}
    return {name: value for name, value in given.items() if value is not None}


def load_with(path: Path, args: argparse.Namespace, progress: Progress | None = None) -> JointTrajectory:
    """Load a recording with the options of the command line."""
    return JointTrajectory.load(path, **reading_options(args), progress=progress)
