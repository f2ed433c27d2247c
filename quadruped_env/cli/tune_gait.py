"""Search the parameters of the scripted gaits on the simulated robot.

They are the tables of the `tuned`, `crouched`, `low` or `fast` gait over forward velocity, with what a yaw rate adds,
and with `tuned` the presets trot, walk, bound and pace. Writes the numbers that belong in
quadruped_env/gait/gait_presets.py, and prints the velocities that the gait reaches. Takes half an hour on two idle
cores, `tuned` more than an hour.
"""

import argparse
import math
from pathlib import Path
from typing import Any

from quadruped_env.cli.common_options import add_output
from quadruped_env.cli.invocation import Invocation
from quadruped_env.gait import COMMANDED


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the search and the output."""
    parser.add_argument("--preset", choices=tuple(COMMANDED), default="tuned", help="the gait (default: %(default)s)")
    parser.add_argument(
        "--frequency",
        type=float,
        default=None,
        metavar="HZ",
        help="gait cycles per second (default: 3.4 for tuned, 3.6 for crouched, 5 for low, 3.2 for fast)",
    )
    parser.add_argument(
        "--generations", type=int, default=40, metavar="N", help="search generations per speed (default: %(default)s)"
    )
    parser.add_argument(
        "--refine", action="store_true", help="begin with the numbers in presets.py instead of from a single gait"
    )
    add_output(parser, "FILE", "JSON file of the numbers (default: %(default)s)", Path("results/gait.json"))
    measured = parser.add_mutually_exclusive_group()
    measured.add_argument("--table", action="store_true", help="only measure the preset and print its table")
    measured.add_argument(
        "--sensitivity",
        action="store_true",
        help="only measure how many of the gaits near the preset some start leads astray, at each of its speeds",
    )


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Search, and print and write what was found."""
    from quadruped_env.gait import CommandedGait
    from quadruped_env.training.gait_sensitivity import sensitivity_table
    from quadruped_env.training.gait_styles import STYLES
    from quadruped_env.training.gait_trial import ROBOT
    from quadruped_env.training.gait_tuning import achieved_table, tune_commanded_gait, tune_presets
    from quadruped_env.utils.files import write_json

    def log(line: str) -> None:
        print(line, flush=True)

    style = STYLES[arguments.preset]
    preset = CommandedGait.preset(arguments.preset, ROBOT)
    if arguments.table:
        log(achieved_table(preset))
        return 0
    if arguments.sensitivity:
        for line in sensitivity_table(preset):
            log(line)
        return 0

    gait = tune_commanded_gait(
        preset.angular_frequency if arguments.frequency is None else math.tau * arguments.frequency,
        yaw_rates=style.yaw_rates,
        generations=arguments.generations,
        say=log,
        style=style,
        refined=preset if arguments.refine else None,
    )
    log(f"\n{achieved_table(gait)}\n")
    found: dict[str, Any] = {arguments.preset: gait.parameters()}
    if arguments.preset == "tuned" and not arguments.refine:
        found["presets"] = tune_presets(arguments.generations, log)
    write_json(arguments.output, found)
    log(f"written to {arguments.output}")
    return 0
