"""Measure what a training has learned after some time: commands met and errors."""

import argparse
import json
import sys
from dataclasses import asdict
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.files import write_json
from quadruped_env.utils.program import run_program
from quadruped_env.utils.provenance import machine, versions


def main() -> int:
    """Parse the arguments, train each seed, and print the table."""
    parser = argparse.ArgumentParser(
        description="Train each seed once, as `mini-quadruped train` does, and test its checkpoints at the "
        "256 commands of the suite, undisturbed, within 0.05 m/s and 0.1 rad/s. Takes the last of the times for each "
        "seed; let nothing else run meanwhile.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--seeds", type=int, nargs="+", default=[0, 1, 2, 3, 4], help="seeds, each trained on its own")
    parser.add_argument(
        "--seconds",
        type=float,
        nargs="+",
        default=[60.0, 105.0, 300.0],
        metavar="S",
        help="s of learning after which a policy is tested; the training, with its schedules, ends with the last",
    )
    parser.add_argument(
        "--training",
        type=json.loads,
        default={},
        metavar="JSON",
        help='other settings of the training, such as \'{"action_mode": "position"}\'',
    )
    parser.add_argument(
        "-o", "--output", type=Path, default=Path("results/learning_speed.json"), help="where to write JSON"
    )
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    import quadruped_env.training.train  # noqa: F401  (it names the extra that is missing)
    from benchmarks.learning_speed import learning_curve, summary
    from quadruped_env.evaluation.confidence import number

    def say(line: str) -> None:
        print(line, flush=True)

    times = arguments.seconds
    if not times[0] > 0.0 or sorted(set(times)) != times:
        raise QuadrupedError(f"--seconds: expected increasing times over 0 s; found {times}")
    curves = [learning_curve(times, {**arguments.training, "seed": seed}, say) for seed in arguments.seeds]
    say(f"\n{summary(curves)}")
    document = {
        "machine": machine(),
        "versions": versions(),
        "training": arguments.training,
        "points": [
            {name: number(value) for name, value in asdict(point).items()} for curve in curves for point in curve
        ],
    }
    write_json(arguments.output, document)
    say(f"\nmeasured on {machine()}; written to {arguments.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
