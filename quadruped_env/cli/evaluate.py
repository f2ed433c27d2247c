"""Evaluate a trained policy against the scripted gaits, and write its report.

mini-quadruped evaluate                    the latest run in runs/, or the shipped policy flat
mini-quadruped evaluate runs/<name>        a run; if it was interrupted, its last checkpoint
mini-quadruped evaluate flat               a shipped policy
mini-quadruped evaluate my_policy.py       a policy that is code (docs/training.md); the file is executed
mini-quadruped evaluate flat --suite       also run the suite mq-eval, whose results can be compared with others'
"""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from quadruped_env.cli.common_options import (
    add_evaluation_options,
    add_overwrite,
    add_run,
    add_suite,
    add_video,
    check_suite,
    evaluation_options,
    named_terrain,
    save_video,
)
from quadruped_env.cli.invocation import Invocation
from quadruped_env.errors import short
from quadruped_env.utils.program import Extras
from quadruped_env.utils.progress import ProgressLine

if TYPE_CHECKING:
    from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policy and the options of a report."""
    add_run(parser)
    add_evaluation_options(parser, "RUN/evaluation, or results/flat")
    parser.add_argument("--no-video", action="store_true", help="write the report without a video")
    add_video(parser)
    add_overwrite(parser, "replace files that exist, such as the video")
    add_suite(
        parser,
        "also run the suite mq-eval, and write suite.json: its own commands, disturbances and terrains, whatever "
        "--seeds, --seconds, --terrain and --randomization say",
    )
    parser.add_argument(
        "--joints",
        type=Path,
        metavar="FILE",
        help="also record the policy's joints in the episode that the report plots over time: position, velocity and "
        "torque, as NAME.csv, or NAME for a rosbag2 bag ('replay', 'view' and 'convert' read both)",
    )


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Evaluate, write the report, and print its summary."""
    from quadruped_env.api import Evaluation
    from quadruped_env.evaluation.evaluated_policy import find_policy
    from quadruped_env.evaluation.results import ranked, read_references, references_for, score_table, with_zero_action
    from quadruped_env.evaluation.suite.suite_definition import draw_seed
    from quadruped_env.report.films.video import prepare_video
    from quadruped_env.report.pages.clips import filmed, recorded
    from quadruped_env.report.report_directory import prepare_output
    from quadruped_env.trajectory import saving

    check_suite(arguments)
    if arguments.suite and arguments.seed is None:
        arguments.seed = draw_seed()
    evaluated = find_policy(arguments.run, arguments.output, arguments.task, arguments.trust_task)
    prepare_output(evaluated.output)
    if arguments.joints:
        saving.check(arguments.joints, arguments.overwrite)
    prepare_video(arguments.video, arguments.overwrite)
    interrupted = evaluated.policy.card.get("interrupted")
    print(f"evaluating {evaluated.name}{f', whose training ended early: {short(interrupted)}' if interrupted else ''}")
    found = Evaluation.measure(
        evaluated,
        f"{invocation.program} {evaluated.source} {evaluation_options(arguments)}",
        arguments.seeds,
        arguments.seconds,
        named_terrain(arguments),
        arguments.randomization or "none",
        (lambda: _suite(evaluated, arguments.quick, arguments.seed)) if arguments.suite else None,
        ProgressLine,
    )
    print(f"\n{found}\n")
    suite = found.suite
    if suite is not None:
        ranking = ranked(
            (row["name"], row) for row in (*with_zero_action(suite), *references_for(suite, read_references()))
        )
        print(f"{score_table([row for _, row in ranking])}\nsuite seed: {suite['seed']}\n")
    print(f"numbers: {found.numbers}")
    extras = Extras()
    if arguments.joints:
        with extras.part(str(arguments.joints)):
            recorded(found.comparison).save(arguments.joints, arguments.overwrite)
            print(f"joints:  {arguments.joints}")
    found.write(extras, not arguments.no_video, ProgressLine("filming"))
    save_video(arguments.video, lambda: filmed(found.comparison), extras)
    return extras.status


def _suite(evaluated: "EvaluatedPolicy", quick: bool, seed: int) -> dict[str, Any]:
    """Run the suite; what `tools/sim2sim.py` measured of the same policy stays."""
    from quadruped_env.evaluation.results import SECOND_ENGINE
    from quadruped_env.evaluation.suite.candidate import Candidate
    from quadruped_env.evaluation.suite.suite import run_suite
    from quadruped_env.evaluation.suite.suite_definition import full_suite, quick_suite
    from quadruped_env.report.pages.suite_section import stored_results

    suite = quick_suite(seed) if quick else full_suite(seed)
    candidate = Candidate.of_policy(evaluated.policy, evaluated.name)
    result = run_suite(candidate, suite, ProgressLine(suite.label), zero_action=True)
    before = stored_results(evaluated, result["suite"])
    return result if before is None else {**result, SECOND_ENGINE: before[SECOND_ENGINE]}
