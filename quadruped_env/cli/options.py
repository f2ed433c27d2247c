"""Arguments and last words that several programs have in common."""

import argparse
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from quadruped_env.errors import QuadrupedWarning
from quadruped_env.evaluation.comparison import NUM_SEEDS
from quadruped_env.evaluation.rollout import DEFAULT_SECONDS
from quadruped_env.reporting.films.video import STILLS, SUFFIXES


@contextmanager
def plain_warnings(program: str) -> Iterator[None]:
    """Say this package's warnings as errors are said: in a line, with the program's name."""

    def say(message: Warning | str, category: type[Warning], *rest: Any) -> None:
        if issubclass(category, QuadrupedWarning):
            print(f"{program}: {message}", file=sys.stderr)
        else:
            usual(message, category, *rest)

    with warnings.catch_warnings():
        usual = warnings.showwarning
        warnings.showwarning = say  # type: ignore[assignment]
        yield


def add_video_option(parser: argparse.ArgumentParser) -> None:
    """The option of every program that runs the robot."""
    parser.add_argument(
        "--video",
        type=Path,
        metavar="FILE",
        help=f"also film it: {', '.join(SUFFIXES[:-1])}, or {SUFFIXES[-1]} for {STILLS} stills side by side",
    )


def add_evaluation_options(parser: argparse.ArgumentParser, default_output: str) -> None:
    """The options of programs that write a report, which goes to `default_output` where nothing else is said."""
    parser.add_argument("--seeds", type=int, default=NUM_SEEDS, metavar="N", help="episodes a command (%(default)s)")
    parser.add_argument(
        "--seconds", type=float, default=DEFAULT_SECONDS, metavar="S", help="length of an episode (%(default)g)"
    )
    parser.add_argument("--no-video", action="store_true", help="write the report without a video")
    add_video_option(parser)
    parser.add_argument("--overwrite", action="store_true", help="replace the file of --video if it exists")
    parser.add_argument("--output", type=Path, metavar="DIR", help=f"where to write ({default_output})")


def tell_results(report: Path, numbers: Path, missing: Sequence[str], video: Path | None) -> None:
    """Say what could not be made, and where the rest lies."""
    for message in missing:
        print(message, file=sys.stderr)
    if video is not None:
        print(f"video:   {video}")
    print(f"numbers: {numbers}\nreport:  {report}")
