"""Compare several policies with each other and with the scripted gaits, on the same episodes.

mini-quadruped compare runs/<one> runs/<other>
mini-quadruped compare flat runs/latest --video results/side.mp4
mini-quadruped compare flat runs/latest --suite     rank them on the suite, after 'evaluate RUN --suite' of each
"""

import argparse
import shlex
from pathlib import Path

from quadruped_env.cli.common_options import (
    NEXT_FREE,
    SHIPPED_POLICIES,
    add_evaluation_options,
    named_terrain,
    randomization_option,
    task_option,
    terrain_option,
)
from quadruped_env.cli.evaluate import print_results
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.progress_line import ProgressLine
from quadruped_env.utils.files import free_path


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policies and the options of a report."""
    parser.add_argument(
        "runs",
        nargs="+",
        metavar="RUN",
        help=f"two or more: a run's directory, {SHIPPED_POLICIES}, or a Python file that defines a policy",
    )
    add_evaluation_options(parser, f"results/comparison, {NEXT_FREE}")
    parser.add_argument(
        "--suite",
        action="store_true",
        help="also rank the policies on their results of the suite, from 'evaluate RUN --suite' (docs/suite.md)",
    )


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Compare, write the report, and print its summary."""
    from quadruped_env.evaluation.comparison import compare_policies
    from quadruped_env.reporting.films.video import prepare_video, save_film
    from quadruped_env.reporting.pages.page import summary_table
    from quadruped_env.reporting.pages.run_comparison import films, find_subjects, headline, write_comparison
    from quadruped_env.reporting.pages.suite_section import ranking, ranking_in_words
    from quadruped_env.reporting.report_directory import prepare_output

    output = arguments.output or free_path(Path("results", "comparison"))
    subjects = find_subjects(arguments.runs, output, arguments.task, arguments.trust_task)
    ranked = ranking(subjects) if arguments.suite else None
    prepare_video(arguments.video, arguments.overwrite)
    prepare_output(output)
    policies = {name: subject.policy for name, subject in subjects.items()}
    progress = ProgressLine("running")
    comparison = compare_policies(
        policies,
        arguments.seeds,
        arguments.seconds,
        progress=progress,
        terrain=named_terrain(arguments),
        randomization=arguments.randomization or "none",
    )
    sources = shlex.join(subject.source for subject in subjects.values())
    report, numbers, missing = write_comparison(
        subjects,
        comparison,
        output,
        f"{invocation.program} {sources} {task_option(arguments)}{terrain_option(arguments)}"
        f"{randomization_option(arguments.randomization)}"
        f"{'--suite ' if arguments.suite else ''}--seeds {arguments.seeds} --seconds {arguments.seconds:g}",
        with_video=not arguments.no_video,
        progress=ProgressLine("filming"),
        ranked=ranked,
    )
    if arguments.video:
        save_film(arguments.video, films(comparison, list(subjects)), ProgressLine("filming"))
    print(f"\n{summary_table(comparison)}\n\n{headline(comparison, list(subjects))}\n")
    if ranked is not None:
        print(f"{ranking_in_words(ranked)}\n")
    print_results(report, numbers, missing, arguments.video)
    return 0
