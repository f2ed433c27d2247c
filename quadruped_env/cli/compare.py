"""Compare several policies with each other and with the scripted gaits, on the same episodes.

mini-quadruped compare runs/<one> runs/<other>
mini-quadruped compare flat runs/latest --suite     rank them on the suite, after 'evaluate RUN --suite' of each
"""

import argparse
import shlex
from pathlib import Path

from quadruped_env.cli import common_options as options
from quadruped_env.cli.invocation import Invocation
from quadruped_env.utils.files import free_path
from quadruped_env.utils.program import Extras
from quadruped_env.utils.progress import ProgressLine


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
    from quadruped_env.evaluation.comparison import compare
    from quadruped_env.evaluation.learning_gain import gain_beside
    from quadruped_env.report.pages.page import METRICS_FILE
    from quadruped_env.report.pages.report import write_comparison, write_comparison_numbers
    from quadruped_env.report.pages.run_comparison import find_policies, headline
    from quadruped_env.report.pages.suite_section import ranking, ranking_in_words
    from quadruped_env.report.pages.tables import summary_table
    from quadruped_env.report.report_directory import REPORT_FILE, prepare_output, print_report

    output = arguments.output or free_path(Path("results", "comparison"))
    policies = find_policies(arguments.runs, output, arguments.task, arguments.trust_task)
    ranked = ranking(policies) if arguments.suite else None
    prepare_output(output)
    sources = shlex.join(evaluated.source for evaluated in policies.values())
    comparison = compare(
        {name: evaluated.policy for name, evaluated in policies.items()},
        arguments.seeds,
        arguments.seconds,
        progress=ProgressLine("running"),
        terrain=options.named_terrain(arguments),
        randomization=arguments.randomization or "none",
    )
    gains = {
        name: gain_beside(
            evaluated.policy,
            arguments.seeds,
            arguments.seconds,
            ProgressLine(f"measuring {name}"),
            progress_file=evaluated.progress_file,
        )
        for name, evaluated in policies.items()
    }
    command = f"{invocation.program} {sources} {options.evaluation_options(arguments)}"
    document = write_comparison_numbers(policies, comparison, output, command, ranked, gains)
    print(f"\n{summary_table(comparison)}\n\n{headline(comparison, list(policies))}\n")
    print("\n".join(f"{name}: it {gain.verdict()}" for name, gain in gains.items()))
    print(f"numbers: {output / METRICS_FILE}")
    extras = Extras()
    with extras.part(REPORT_FILE):
        print_report(write_comparison(policies, comparison, output, document, ranked, gains), [])
    if ranked is not None:
        print(f"{ranking_in_words(ranked)}\n")
    return extras.status
