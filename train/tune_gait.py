"""Tune the scripted gaits and print their tables."""

import argparse
import math
import sys
from dataclasses import asdict
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # for a Python without the package, which then names the one to use

from quadruped_env import CommandedGait, QuadrupedError
from quadruped_env.files import write_json
from quadruped_env.training.gait_tuning import achieved_table, tune_commanded_gait, tune_presets


def main() -> None:
    """Parse the arguments and tune."""
    parser = argparse.ArgumentParser(
        description="Search for the parameters of the scripted gaits on the simulated robot: the table of the 'tuned' "
        "gait over speed, and the presets trot, walk, bound and pace. Prints the tables for quadruped_env/gait.py and "
        "the velocities that the tuned gait reaches. Takes about four minutes on two cores.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--frequency", type=float, default=2.2, help="gait cycles per second of the tuned gait")
    parser.add_argument("--generations", type=int, default=20, help="search generations for each speed")
    parser.add_argument("--output", type=Path, default=Path("results/gait.json"), help="where to write the numbers")
    parser.add_argument("--table", action="store_true", help="only measure the tuned gait and print its table")
    args = parser.parse_args()
    if args.table:
        print(achieved_table(CommandedGait.tuned()))
        return

    def say(line: str) -> None:
        print(line, flush=True)

    gait = tune_commanded_gait(
        math.tau * args.frequency,
        forward=(0.1, 0.2, 0.3, 0.4, 0.5, 0.6),
        backward=(-0.1, -0.2, -0.3, -0.4),
        generations=args.generations,
        say=say,
    )
    say(f"\n{achieved_table(gait)}\n")
    presets = tune_presets(args.generations, say)
    try:
        write_json(args.output, {"tuned": asdict(gait), "presets": presets})
    except QuadrupedError as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(2)
    say(f"written to {args.output}")


if __name__ == "__main__":
    main()
