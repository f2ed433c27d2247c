"""Compare several policies with each other and with the scripted gaits, on the same episodes.

mini-quadruped compare runs/<one> runs/<other>
mini-quadruped compare flat runs/latest --video results/side.mp4
mini-quadruped compare runs/<short> runs/<long> --trust-task     two robots, each in its own env and units
mini-quadruped compare flat runs/latest --suite     rank them on the suite, after 'evaluate RUN --suite' of each
"""

import argparse
import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from quadruped_env.cli import common_options as options
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.progress_line import ProgressLine
from quadruped_env.utils.files import free_path
from quadruped_env.utils.program import Extras

if TYPE_CHECKING:
    from quadruped_env.evaluation.comparison import Comparison
    from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policies and the options of a report."""
    parser.add_argument(
        "runs",
        nargs="+",
        metavar="RUN",
        help=f"two or more: a run's directory, {options.SHIPPED_POLICIES}, or a Python file that defines a policy",
    )
    options.add_evaluation_options(parser, f"results/comparison, {options.NEXT_FREE}")
    parser.add_argument(
        "--suite",
        action="store_true",
        help="also rank the policies on their results of the suite, from 'evaluate RUN --suite' (docs/suite.md)",
    )


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Compare, write the report, and print its summary."""
    from quadruped_env.reporting.films.video import prepare_video
    from quadruped_env.reporting.pages.robot_comparison import by_robot, robot_tables, write_index, write_index_numbers
    from quadruped_env.reporting.pages.run_comparison import films, find_policies
    from quadruped_env.reporting.pages.suite_section import ranking, ranking_in_words
    from quadruped_env.reporting.report_directory import REPORT_FILE, prepare_output, print_report

    output = arguments.output or free_path(Path("results", "comparison"))
    policies = find_policies(arguments.runs, output, arguments.task, arguments.trust_task)
    ranked = ranking(policies) if arguments.suite else None
    prepare_video(arguments.video, arguments.overwrite)
    prepare_output(output)
    sources = shlex.join(evaluated.source for evaluated in policies.values())
    command = f"{invocation.program} {sources} {options.evaluation_options(arguments)}"
    groups, extras = by_robot(policies), Extras()
    places = [output] if len(groups) == 1 else [output / next(iter(group)) for group in groups]
    found = [
        _one_robot(group, place, command, ranked, arguments, extras)
        for group, place in zip(groups, places, strict=True)
    ]
    if ranked is not None:
        print(f"{ranking_in_words(ranked)}\n")
    if len(groups) > 1:
        of_each = zip(groups, found, places, strict=True)
        comparisons = {name: (comparison, place) for group, comparison, place in of_each for name in group}
        index = {name: comparison for name, (comparison, _) in comparisons.items()}
        print("\n\n".join(table.text() for table in robot_tables(index)))
        document = write_index_numbers(output, index, command)
        with extras.part(REPORT_FILE):
            reports = {name: place / REPORT_FILE for name, (_, place) in comparisons.items()}
            print_report(write_index(output, index, reports, document), [])
    options.save_video(
        arguments.video,
        lambda: [clip for group, one in zip(groups, found, strict=True) for clip in films(one, list(group))],
        extras,
    )
    return extras.status


def _one_robot(
    policies: "Mapping[str, EvaluatedPolicy]",
    output: Path,
    command: str,
    ranked: "Mapping[str, Any] | None",
    arguments: argparse.Namespace,
    extras: Extras,
) -> "Comparison":
    """Compare policies for one robot, write numbers and report, and print the summary."""
    from quadruped_env.reporting.pages.page import METRICS_FILE, summary_table
    from quadruped_env.reporting.pages.run_comparison import headline, write_numbers, write_page
    from quadruped_env.reporting.report_directory import REPORT_FILE, print_report

    comparison = options.compared({name: evaluated.policy for name, evaluated in policies.items()}, arguments)
    gains = {name: options.gain_of(evaluated.policy, arguments) for name, evaluated in policies.items()}
    document = write_numbers(policies, comparison, output, command, ranked, gains)
    print(f"\n{summary_table(comparison)}\n\n{headline(comparison, list(policies))}\n")
    print("\n".join(f"{name}: it {gain.verdict()}" for name, gain in gains.items()))
    print(f"numbers: {output / METRICS_FILE}")
    with extras.part(REPORT_FILE):
        filming = ProgressLine("filming")
        with_video = not arguments.no_video
        print_report(*write_page(policies, comparison, output, document, with_video, filming, ranked, gains))
    return comparison
