"""Evaluate a trained policy against the scripted gaits, and write its report.

mini-quadruped evaluate                    the latest run in runs/, or the shipped policy
mini-quadruped evaluate runs/<name>        a run; if it was interrupted, its last checkpoint
mini-quadruped evaluate flat               the shipped policy
"""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from quadruped_env.cli.commands import Invocation
from quadruped_env.cli.options import (
    add_evaluation_options,
    named_terrain,
    randomization_option,
    task_option,
    terrain_option,
)
from quadruped_env.cli.progress import ProgressLine


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policy and the options of a report."""
    parser.add_argument("run", nargs="?", metavar="RUN", help="a run's directory, or 'flat'")
    add_evaluation_options(parser, "RUN/evaluation, or results/flat")


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Evaluate, write the report, and print its summary."""
    from quadruped_env.evaluation.comparison import compare
    from quadruped_env.evaluation.subject import find_subject
    from quadruped_env.evaluation.verdict import verdict
    from quadruped_env.reporting.films.video import prepare_video, save_film
    from quadruped_env.reporting.pages.evaluation_report import write_report
    from quadruped_env.reporting.pages.page import summary_table
    from quadruped_env.reporting.pages.pictures import filmed
    from quadruped_env.reporting.results import prepare_output

    subject = find_subject(arguments.run, arguments.output, arguments.task)
    prepare_output(subject.output)
    prepare_video(arguments.video, arguments.overwrite)
    print(f"evaluating {subject.name}")
    progress = ProgressLine("running")
    comparison = compare(
        subject.policy,
        arguments.seeds,
        arguments.seconds,
        progress=progress,
        terrain=named_terrain(arguments),
        randomization=arguments.randomization or "none",
    )
    report, numbers, missing = write_report(
        subject,
        comparison,
        f"{invocation.program} {subject.source} {task_option(arguments.task)}{terrain_option(arguments)}"
        f"{randomization_option(arguments.randomization)}"
        f"--seeds {arguments.seeds} --seconds {arguments.seconds:g}",
        with_video=not arguments.no_video,
        progress=ProgressLine("filming"),
    )
    if arguments.video:
        save_film(arguments.video, filmed(comparison), ProgressLine("filming"))
    print(f"\n{summary_table(comparison)}\n\n{verdict(comparison).text()}\n")
    print_results(report, numbers, missing, arguments.video)
    return 0


def print_results(report: Path, numbers: Path, missing: Sequence[str], video: Path | None) -> None:
    """Print what could not be made, and where the rest is."""
    for message in missing:
        print(message, file=sys.stderr)
    if video is not None:
        print(f"video:   {video}")
    print(f"numbers: {numbers}\nreport:  {report}")
