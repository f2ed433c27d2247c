"""Run a policy in a second physics engine, Drake, and measure what it loses there.

The robot in Drake is built from its URDF alone. The policy and the searched gait run on the same commands and random
starts in MuJoCo and in Drake, and the stance where standing is commanded. The results go into sim2sim.json; the
next report of 'evaluate' shows them, too.

    mini-quadruped sim2sim                      the latest run in runs/, or the shipped policy flat
    mini-quadruped sim2sim flat --seeds 1       a shipped policy, one episode per command
    mini-quadruped sim2sim flat --command 0.3 0.5 --command 0 0.5
"""

import argparse
from typing import get_args

from quadruped_env.cli.common_options import add_output, add_run, add_task_file, task_option
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.progress_line import ProgressLine
from quadruped_env.sim2sim.contact import Approximation
from quadruped_env.sim2sim.engines import Drake
from quadruped_env.sim2sim.transfer import NUM_SEEDS, SECONDS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policy, the episodes and Drake's contact model."""
    add_run(parser)
    parser.add_argument(
        "--command",
        nargs=2,
        type=float,
        action="append",
        metavar=("M/S", "RAD/S"),
        dest="velocities",
        help="forward velocity and yaw rate of episodes; may be repeated (default: eight commands, docs/evaluation.md)",
    )
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
        help="coefficient of friction in Drake (default: that of the feet in MuJoCo)",
    )
    add_task_file(parser)
    add_output(parser, "DIR", "directory of sim2sim.json (default: RUN/evaluation, or results/flat)")


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Run both engines, write the results, and print them."""
    from quadruped_env.evaluation.evaluated_policy import find_policy
    from quadruped_env.sim2sim import transfer_results
    from quadruped_env.sim2sim.engines import check_drake
    from quadruped_env.sim2sim.transfer import run_transfer

    evaluated = find_policy(arguments.run, arguments.output, arguments.task, arguments.trust_task)
    evaluated.policy.check_is_data("sim2sim")
    check_drake()
    commands = None if arguments.velocities is None else [(v, w) for v, w in arguments.velocities]
    transfer = run_transfer(
        evaluated.policy,
        commands,
        arguments.seeds,
        arguments.seconds,
        there=Drake(arguments.contact, friction=arguments.friction),
        progress=ProgressLine("running"),
    )
    path = transfer_results.save(transfer, evaluated, f"{invocation.program} {evaluated.source} {_options(arguments)}")
    print("\n\n".join(table.text() for table in transfer_results.tables(transfer)))
    print("\n" + "\n".join([*transfer_results.conditions(transfer), "", *transfer_results.verdict(transfer)]))
    print(f"\nnumbers: {path}")
    return 0


def _options(arguments: argparse.Namespace) -> str:
    """The options as a user types them again."""
    commands = "".join(f"--command {v:g} {w:g} " for v, w in arguments.velocities or ())
    friction = "" if arguments.friction is None else f"--friction {arguments.friction:g} "
    return (
        f"{task_option(arguments)}{commands}--seeds {arguments.seeds} --seconds {arguments.seconds:g} "
        f"{friction}--contact {arguments.contact}"
    )
