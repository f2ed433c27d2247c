"""Run a policy in a second physics engine, Drake, and measure what it loses there: docs/notes/second-engine.md.

The robot in Drake is built from its URDF alone. The policy and the searched gait run on the same commands and random
starts in MuJoCo and in Drake, and the stance where standing is commanded.

    pip install -c constraints.txt -r tools/second_engine/requirements.txt
    python tools/sim2sim.py                      the latest run in runs/, or the shipped policy flat
    python tools/sim2sim.py flat --command 0.3 0.5 --command 0 0.5
    python tools/sim2sim.py flat --suite         also put the results into suite.json of 'evaluate flat --suite'
"""

import argparse
import sys
from pathlib import Path
from typing import get_args

sys.path.append(str(Path(__file__).parents[1]))  # so that a Python without the package finds it, and prints a fix

import quadruped_env  # noqa: F401  (first, since it checks this Python)

# isort: split
from quadruped_env.cli.common_options import add_task_file
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.results import RESULTS_FILE, SECOND_ENGINE
from quadruped_env.report.pages.suite_section import stored_results
from quadruped_env.utils.files import write_json
from quadruped_env.utils.program import run_program
from quadruped_env.utils.progress import ProgressLine
from second_engine.engines import Approximation, Drake, check_drake
from second_engine.transfer import NUM_SEEDS, SECONDS, run_transfer


def main(argv: list[str] | None = None) -> int:
    """Parse the arguments and run both engines."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", nargs="?", metavar="RUN", help="run directory or shipped policy")
    parser.add_argument(
        "--command",
        nargs="+",
        type=float,
        action="append",
        metavar="VELOCITY",
        help="velocities of episodes: forward (m/s), yaw rate (rad/s) and, for robots that move sideways, lateral "
        "(m/s), 0 where left out; may be repeated (default: eight commands, or nine with sideways)",
    )
    add_task_file(parser)
    parser.add_argument(
        "--seeds", type=int, default=NUM_SEEDS, metavar="N", help="episodes per command (default: %(default)s)"
    )
    parser.add_argument(
        "--seconds", type=float, default=SECONDS, metavar="S", help="length of an episode, s (default: %(default)g)"
    )
    parser.add_argument(
        "--contact",
        choices=get_args(Approximation),
        default=Drake().approximation,
        help="Drake's discrete contact approximation (default: %(default)s)",
    )
    parser.add_argument(
        "--friction",
        type=float,
        metavar="MU",
        help="coefficient of friction in Drake (default: the feet's in MuJoCo)",
    )
    parser.add_argument(
        "--suite",
        action="store_true",
        help="put the results into suite.json of 'mini-quadruped evaluate RUN --suite', which keeps them and shows "
        "them on its page when it runs again; they are not part of the score",
    )
    arguments = parser.parse_args(argv)
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Run both engines, and print the results."""
    evaluated = find_policy(arguments.run, None, arguments.task, arguments.trust_task)
    evaluated.policy.check_is_data("sim2sim")
    check_drake()
    path = evaluated.evaluation / RESULTS_FILE
    if arguments.suite and (suite := stored_results(evaluated)) is None:
        raise QuadrupedError(
            f"{path}: has no results of the suite for {evaluated.name}; run mini-quadruped evaluate "
            f"{evaluated.source} --suite"
        )
    there = Drake(arguments.contact, friction=arguments.friction)
    transfer = run_transfer(
        evaluated.policy,
        arguments.command,
        arguments.seeds,
        arguments.seconds,
        there=there,
        progress=ProgressLine("running"),
    )
    print("\n\n".join(transfer.tables()))
    print("\n" + "\n".join([*transfer.conditions(), "", *transfer.verdict()]))
    if arguments.suite:
        write_json(path, {**suite, SECOND_ENGINE: transfer.to_dict()})
        print(f"written: {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
