"""Compare several policies with each other and with the scripted gaits, on the same episodes.

mini-quadruped compare runs/<one> runs/<other>
mini-quadruped compare flat runs/latest --video results/side.mp4
mini-quadruped compare flat runs/latest --suite     rank them on the suite, after 'evaluate RUN --suite' of each
"""

import argparse
import shlex
from pathlib import Path

from quadruped_env.cli import common_options as options
from quadruped_env.cli.evaluate import print_report
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.progress_line import ProgressLine
from quadruped_env.utils.files import free_path
from quadruped_env.utils.program import Extras


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
    from quadruped_env.reporting.pages.page import METRICS_FILE, summary_table
    from quadruped_env.reporting.pages.run_comparison import films, find_policies, headline, write_numbers, write_page
    from quadruped_env.reporting.pages.suite_section import ranking, ranking_in_words
    from quadruped_env.reporting.report_directory import REPORT_FILE, prepare_output

    output = arguments.output or free_path(Path("results", "comparison"))
    policies = find_policies(arguments.runs, output, arguments.task, arguments.trust_task)
    ranked = ranking(policies) if arguments.suite else None
    prepare_video(arguments.video, arguments.overwrite)
    prepare_output(output)
    comparison = options.compared({name: evaluated.policy for name, evaluated in policies.items()}, arguments)
    gains = {name: options.gain_of(evaluated.policy, arguments) for name, evaluated in policies.items()}
    sources = shlex.join(evaluated.source for evaluated in policies.values())
    document = write_numbers(
        policies,
        comparison,
        output,
        f"{invocation.program} {sources} {options.evaluation_options(arguments)}",
        ranked,
        gains,
    )
    print(f"\n{summary_table(comparison)}\n\n{headline(comparison, list(policies))}\n")
    print("\n".join(f"{name}: {gain.verdict()}" for name, gain in gains.items()))
    if ranked is not None:
        print(f"{ranking_in_words(ranked)}\n")
    print(f"numbers: {output / METRICS_FILE}")
    extras = Extras()
    with extras.part(REPORT_FILE):
        with_video = not arguments.no_video
        print_report(
            *write_page(policies, comparison, output, document, with_video, ProgressLine("filming"), ranked, gains)
        )
    options.save_video(arguments.video, lambda: films(comparison, list(policies)), extras)
    return extras.status
