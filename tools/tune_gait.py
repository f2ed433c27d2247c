"""Search the parameters of the scripted gaits on the simulated robot, or on one's own of two joints per leg (--task).

They are the tables of the gait `tuned`, `crouched`, `low` or `fast` over forward velocity, with what a yaw rate adds,
or a preset for one speed. Each search starts from the robot's preset of that name. Writes JSON: of the built-in robot
the numbers that belong in quadruped_env/gait (commanded_gaits.json, or gait_presets.py for one speed), of another
what it takes as `Robot.gaits`. Prints the velocities that the gait reaches. Takes half an hour on two idle cores, and
`tuned` more than an hour.
"""

import argparse
import math
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)

# isort: split
from gait_search.search import ONE_SPEED, achieved_table, tune_commanded_gait, tune_preset
from gait_search.styles import STYLES
from quadruped_env.control.task_file import load_robot
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import SINUSOID, CommandedGait
from quadruped_env.gait.gaits import check_two_joints
from quadruped_env.utils.files import write_json
from quadruped_env.utils.program import run_program


def main(argv: list[str] | None = None) -> int:
    """Parse the arguments and search."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--preset", choices=(*STYLES, *ONE_SPEED, SINUSOID), default="tuned", help="the gait (default: %(default)s)"
    )
    parser.add_argument("--task", type=Path, metavar="FILE", help="Python file with a robot of one's own")
    parser.add_argument(
        "--frequency", type=float, metavar="HZ", help="gait cycles per second (default: the preset's, for the height)"
    )
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

    name, robot = arguments.preset, load_robot(arguments.task)
    if name in ONE_SPEED:
        if arguments.task or arguments.frequency or arguments.table:
            raise QuadrupedError(
                f"--preset {name} is searched for the built-in robot, at its own frequency; for your own robot, or to "
                f"measure a gait, name one of {', '.join(STYLES)}"
            )
        fore, hind = tune_preset(name, arguments.generations, log)
        write_json(arguments.output, {name: {"fore": fore.tolist(), "hind": hind.tolist()}})
    else:
        preset = CommandedGait.preset(name, robot)
        if arguments.table:
            log(achieved_table(preset))
            return 0
        if name == SINUSOID:
            raise QuadrupedError(f"--preset {name} has nothing to search for; measure it with --table")
        check_two_joints(robot, "a search of a gait is")
        frequency = preset.angular_frequency
        if arguments.frequency is not None:
            frequency = math.tau * arguments.frequency
        gait = tune_commanded_gait(robot, name, frequency, arguments.generations, log)
        log(f"\n{achieved_table(gait)}\n")
        write_json(arguments.output, {name: gait.parameters()})
    log(f"written to {arguments.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
