"""Search the parameters of the scripted gaits on the simulated robot.

They are the tables of the `tuned` gait over forward velocity, with what a yaw rate adds, and the presets trot, walk,
bound and pace. Prints the numbers that belong in quadruped_env/gait/presets.py, and the velocities that the tuned gait
reaches. Takes about 20 minutes on two idle cores.
"""

import argparse
import math
from pathlib import Path

from quadruped_env.cli.commands import Invocation
from quadruped_env.cli.options import add_output


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the search and the output."""
    parser.add_argument(
        "--frequency",
        type=float,
        default=2.6,
        metavar="HZ",
        help="gait cycles per second of the tuned gait (default: %(default)g)",
    )
    parser.add_argument(
        "--generations", type=int, default=12, metavar="N", help="search generations per speed (default: %(default)s)"
    )
    add_output(parser, "FILE", "JSON file of the numbers (default: %(default)s)", Path("results/gait.json"))
    parser.add_argument("--table", action="store_true", help="only measure the tuned gait and print its table")


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Search, and print and write what was found."""
    from quadruped_env.files import write_json
    from quadruped_env.gait import CommandedGait
    from quadruped_env.training.gait_trial import ROBOT
    from quadruped_env.training.gait_tuning import achieved_table, tune_commanded_gait, tune_presets

    if arguments.table:
        print(achieved_table(CommandedGait.tuned(ROBOT)))
        return 0

    def log(line: str) -> None:
        print(line, flush=True)

    gait = tune_commanded_gait(
        math.tau * arguments.frequency,
        speeds=(0.3, 0.2, 0.1, 0.0, 0.0, -0.1, -0.2, -0.3, -0.4, 0.4, 0.5, 0.58, 0.65, 0.65),
        # A speed that is there again is searched again from its own result.
        turning_speeds=(0.0, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, -0.1, -0.2),
        yaw_rates=(0.25, 0.5, 0.8),
        generations=arguments.generations,
        say=log,
    )
    log(f"\n{achieved_table(gait)}\n")
    # They start from a small step, the tables from a gait.
    presets = tune_presets(3 * arguments.generations, log)
    write_json(arguments.output, {"tuned": gait.parameters(), "presets": presets})
    log(f"written to {arguments.output}")
    return 0
