"""Compare several policies with each other and with the scripted gaits, on the same episodes.

mini-quadruped compare runs/<one> runs/<other>
mini-quadruped compare flat runs/latest --suite     also rank them on the episodes of the suite
"""

import argparse
import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from quadruped_env.cli import common_options as options
from quadruped_env.cli.invocation import Invocation
from quadruped_env.utils.files import free_path
from quadruped_env.utils.program import Extras
from quadruped_env.utils.progress import ProgressLine

if TYPE_CHECKING:
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
    options.add_suite(
        parser,
        "also rank the policies on the same episodes of the suite; results of 'evaluate RUN --suite' with its seed are "
        "taken, and the others measured",
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

    options.check_suite(arguments)
    output = arguments.output or free_path(Path("results", "comparison"))
    policies = find_policies(arguments.runs, output, arguments.task, arguments.trust_task)
    prepare_output(output)
    ranked = ranking(policies, _suite_results(policies, arguments)) if arguments.suite else None
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


def _suite_results(policies: "Mapping[str, EvaluatedPolicy]", arguments: argparse.Namespace) -> dict[str, Any]:
    """Return each policy's results of the suite with one seed: the stored ones, and new ones where there are none.

    The seed is the option's, or else the one of the first policy with results, or else drawn.
    """
    from quadruped_env.evaluation.suite.candidate import Candidate
    from quadruped_env.evaluation.suite.suite import run_suite
    from quadruped_env.evaluation.suite.suite_definition import draw_seed, full_suite, quick_suite, with_velocities
    from quadruped_env.report.pages.suite_section import stored_results

    suite = quick_suite() if arguments.quick else full_suite()
    results = {
        name: stored_results(evaluated, with_velocities(suite, evaluated.policy.config.robot).identity)
        for name, evaluated in policies.items()
    }
    if arguments.seed is None:
        arguments.seed = next((result["seed"] for result in results.values() if result), draw_seed())
    suite = suite.seeded(arguments.seed)
    for name, evaluated in policies.items():
        stored = results[name]
        if stored is None or stored["seed"] != suite.seed:
            line = ProgressLine(f"{name}: {suite.label}, seed {suite.seed}")
            results[name] = run_suite(Candidate.of_policy(evaluated.policy, name), suite, line)
    return results
