"""Evaluate a trained policy against the scripted gaits, and write its report.

mini-quadruped evaluate                    the latest run in runs/, or the shipped policy flat
mini-quadruped evaluate runs/<name>        a run; if it was interrupted, its last checkpoint
mini-quadruped evaluate flat               a shipped policy
mini-quadruped evaluate my_policy.py       a policy that is code (docs/your-own-algorithm.md); the file is executed
mini-quadruped evaluate flat --suite       also run the suite mq-eval, whose results can be compared with others'
"""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from quadruped_env.cli.common_options import (
    add_evaluation_options,
    add_run,
    named_terrain,
    randomization_option,
    task_option,
    terrain_option,
)
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.progress_line import ProgressLine
from quadruped_env.errors import QuadrupedError

if TYPE_CHECKING:
    from quadruped_env.evaluation.subject import Subject


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policy and the options of a report."""
    add_run(parser)
    add_evaluation_options(parser, "RUN/evaluation, or results/flat")
    parser.add_argument(
        "--suite",
        action="store_true",
        help="also run the suite mq-eval, and write suite.json: fixed commands, seeds and disturbances, on its own "
        "terrains, whatever --seeds, --seconds, --terrain and --randomization say (docs/suite.md)",
    )
    parser.add_argument(
        "--quick",
        action="store_true",
        help="with --suite: few episodes, to see whether it works; never comparable with the full suite",
    )


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Evaluate, write the report, and print its summary."""
    from quadruped_env.evaluation.comparison import compare
    from quadruped_env.evaluation.subject import find_subject
    from quadruped_env.evaluation.verdict import verdict
    from quadruped_env.reporting.films.video import prepare_video, save_film
    from quadruped_env.reporting.pages.evaluation_report import write_report
    from quadruped_env.reporting.pages.page import summary_table
    from quadruped_env.reporting.pages.pictures import filmed
    from quadruped_env.reporting.report_directory import prepare_output

    if arguments.quick and not arguments.suite:
        raise QuadrupedError("--quick: found without --suite; it makes the suite shorter, so give both")
    subject = find_subject(arguments.run, arguments.output, arguments.task, arguments.trust_task)
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
    suite = _suite(subject, arguments.quick) if arguments.suite else None
    report, numbers, missing = write_report(
        subject,
        comparison,
        f"{invocation.program} {subject.source} {task_option(arguments)}{terrain_option(arguments)}"
        f"{randomization_option(arguments.randomization)}"
        f"{'--suite ' if arguments.suite else ''}{'--quick ' if arguments.quick else ''}"
        f"--seeds {arguments.seeds} --seconds {arguments.seconds:g}",
        with_video=not arguments.no_video,
        progress=ProgressLine("filming"),
        suite=suite,
    )
    if arguments.video:
        save_film(arguments.video, filmed(comparison), ProgressLine("filming"))
    print(f"\n{summary_table(comparison)}\n\n{verdict(comparison, suite).text()}\n")
    if suite is not None:
        _print_scores(suite)
    print_results(report, numbers, missing, arguments.video)
    return 0


def _suite(subject: "Subject", quick: bool) -> dict[str, Any]:
    """Run the suite."""
    from quadruped_env.evaluation.suite.measured_controller import Contender
    from quadruped_env.evaluation.suite.suite import episode_seconds, run_suite
    from quadruped_env.evaluation.suite.suite_definition import full_suite, quick_suite

    suite = quick_suite() if quick else full_suite()
    print(f"{suite.label}: up to {sum(episode_seconds(suite).values()) / 3600.0:.1f} hours of simulated time")
    return run_suite(Contender.of_policy(subject.policy, subject.name), suite, ProgressLine(suite.label))


def _print_scores(result: dict[str, Any]) -> None:
    """Print the scores of the policy and of the reference rows, the best first."""
    from quadruped_env.evaluation.suite.references import read_references, references_for, score_table
    from quadruped_env.evaluation.suite.suite import ranked

    rows = ranked((row["name"], row) for row in (result, *references_for(result, read_references())))
    print(f"{score_table([row for _, row in rows])}\n")


def print_results(report: Path, numbers: Path, missing: Sequence[str], video: Path | None) -> None:
    """Print what could not be made, and where the rest is."""
    for message in missing:
        print(message, file=sys.stderr)
    if video is not None:
        print(f"video:   {video}")
    print(f"numbers: {numbers}\nreport:  {report}")
