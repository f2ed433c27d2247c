"""Search the parameters of the scripted gaits on the simulated robot.

They are the tables of the gait `tuned`, `crouched`, `low` or `fast` over forward velocity, with what a yaw rate adds.
Each search starts from the shipped tables. Writes the numbers that belong in quadruped_env/gait/commanded_gaits.json,
and prints the velocities that the gait reaches. Takes half an hour on two idle cores, and `tuned` more than an hour.
"""

import argparse
import math
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)

# isort: split
from gait_search.search import achieved_table, tune_commanded_gait
from gait_search.styles import STYLES
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import SINUSOID, CommandedGait
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.utils.files import write_json
from quadruped_env.utils.program import run_program


def main(argv: list[str] | None = None) -> int:
    """Parse the arguments and search."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--preset", choices=(*STYLES, SINUSOID), default="tuned", help="the gait (default: %(default)s)"
    )
    parser.add_argument("--frequency", type=float, metavar="HZ", help="gait cycles per second (default: the preset's)")
    parser.add_argument("--generations", type=int, default=40, metavar="N", help="per speed (default: %(default)s)")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path("results/gait.json"), help="JSON file (default: %(default)s)"
    )
    parser.add_argument("--table", action="store_true", help="only measure the preset and print its table")
    arguments = parser.parse_args(argv)
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Search, and print and write what was found."""

    def log(line: str) -> None:
        print(line, flush=True)

    name = arguments.preset
    preset = CommandedGait.preset(name)
    if arguments.table:
        log(achieved_table(preset))
        return 0
    if name == SINUSOID:
        raise QuadrupedError(f"--preset {name} has nothing to search for; measure it with --table")
    frequency = preset.angular_frequency if arguments.frequency is None else math.tau * arguments.frequency
    gait = tune_commanded_gait(MINI_QUADRUPED, name, frequency, arguments.generations, log)
    log(f"\n{achieved_table(gait)}\n")
    write_json(arguments.output, {name: gait.parameters()})
    log(f"written to {arguments.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
