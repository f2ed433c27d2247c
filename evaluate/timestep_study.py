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

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.benchmarks.timestep_study import GAITS, run_study
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.files import check_free, free_path
from quadruped_env.gait import PRESETS


def main() -> None:
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
        help=f"gaits to compare, of {', '.join(PRESETS)}; default: {' '.join(GAITS)}",
    )
    parser.add_argument("--starts", type=int, default=24, help="starts of each gait; default: 24")
    parser.add_argument("--seconds", type=float, default=8.0, help="length of each walk, 2 s of warm-up; default: 8")
    parser.add_argument("--seed", type=int, default=0, help="of the starts; default: 0")
    parser.add_argument(
        "--threads", type=int, default=0, help="threads that measure the errors; default: one for every core"
    )
    parser.add_argument(
        "--out",
        type=Path,
        metavar="FILE.json",
        help="where to write; default: results/timestep-study.json, with the next free number if that exists",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace the file of --out if it exists")
    args = parser.parse_args()

    out = args.out or free_path(Path("results") / "timestep-study.json")
    try:
        check_free([out], args.overwrite)
        study = run_study(args.gaits, args.starts, args.seconds, args.seed, args.threads, ProgressLine)
        study.save(out)
    except QuadrupedError as error:
        sys.exit(f"timestep_study.py: {error}")
    print(study.table())
    print(f"\n{study.verdict()}\n\nevery number: {out}")


if __name__ == "__main__":
    main()
