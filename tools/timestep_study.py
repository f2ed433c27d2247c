"""Measure what the physics' time step and solver cost, and how far they are from a finer step.

Every setting is compared with itself at a fifth of its time step and a solver run to convergence: the height at which
the robot stands, the speed at which it walks with scripted gaits (mean over several starts, with its standard error),
and the speed at which it meets the ground after a drop of 10 cm. Settings are the one in the model file, and those that
differ from it in one thing. Speed is relative to the model file's setting, on one thread, with all settings in turns.

The result is a Markdown table on the terminal and a JSON file with every number. assets/mini_quadruped/README.md holds
the table that the choice rests on. Takes a minute or two.
"""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # so that a Python without the package finds it, and prints a fix

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from benchmarks.timestep_study import GAITS, run_study
from quadruped_env.cli.common_options import add_output, add_overwrite
from quadruped_env.cli.progress_line import ProgressLine
from quadruped_env.gait import PRESETS
from quadruped_env.utils.files import check_free, free_path
from quadruped_env.utils.interpreter import pasteable
from quadruped_env.utils.program import run_program


def main() -> int:
    """Run the program."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--gaits",
        nargs="+",
        choices=PRESETS,
        default=GAITS,
        metavar="PRESET",
        help=f"gaits whose speed to compare, of {', '.join(PRESETS)}; default: {' '.join(GAITS)}",
    )
    parser.add_argument("--starts", type=int, default=24, help="starts of each gait; default: 24")
    parser.add_argument("--seconds", type=float, default=8.0, help="length of each walk, 2 s of warm-up; default: 8")
    parser.add_argument("--seed", type=int, default=0, help="of the starts; default: 0")
    parser.add_argument(
        "--threads", type=int, default=0, help="threads that measure the errors; default: one for every core"
    )
    add_output(
        parser, "FILE", "JSON file of every number (default: results/timestep-study.json, or the next free number)"
    )
    add_overwrite(parser)
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    output = arguments.output or free_path(Path("results") / "timestep-study.json")
    check_free([output], arguments.overwrite)
    study = run_study(
        arguments.gaits, arguments.starts, arguments.seconds, arguments.seed, arguments.threads, ProgressLine
    )
    study.save(output)
    print(study.table())
    print(f"\n{study.verdict()}\n\nevery number: {output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
