"""Measure how long it takes to learn to follow commands."""

import argparse
import json
import sys
from dataclasses import asdict, fields
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.training import TrainConfig
from quadruped_env.utils.files import write_json
from quadruped_env.utils.program import run_program
from quadruped_env.utils.provenance import machine, versions


def main() -> int:
    """Parse the arguments, train each seed until it passes, and print the table."""
    parser = argparse.ArgumentParser(
        description="Train seeds until each meets 80 %% of the suite's commands (256, undisturbed, within 0.05 m/s and "
        "0.1 rad/s), and report the wall clock of learning, with the seeds that failed. Testing does not count as "
        "learning. Takes minutes for each seed on two cores; let nothing else run meanwhile.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--action-modes", nargs="+", default=["position", "residual"], help="which modes")
    parser.add_argument("--seeds", type=int, nargs="+", default=[0, 1, 2, 3, 4], help="seeds, each trained on its own")
    parser.add_argument(
        "--timesteps", type=int, default=6_000_000, help="budget that the schedules of learning rate and noise end with"
    )
    parser.add_argument(
        "--symmetric",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="make the policy left/right symmetric by construction",
    )
    parser.add_argument(
        "--training",
        type=json.loads,
        default={},
        metavar="JSON",
        help="other settings of the training, such as '{\"n_steps\": 16}'",
    )
    parser.add_argument("--limit", type=float, default=600.0, help="s of learning after which a seed has failed")
    parser.add_argument("--interval", type=float, default=30.0, help="s of learning between tests")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path("results/learning_speed.json"), help="where to write JSON"
    )
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    import quadruped_env.training.train  # noqa: F401  (it names the extra that is missing)
    from benchmarks.learning_speed import summary, time_to_learn

    def say(line: str) -> None:
        print(line, flush=True)

    unknown = sorted(set(arguments.training) - {field.name for field in fields(TrainConfig)})
    if unknown:
        raise QuadrupedError(
            f"--training: there is no setting {short(unknown[0])}; `mini-quadruped train --help` lists them, with "
            f"_ here instead of -"
        )
    results = []
    for mode in arguments.action_modes:
        for seed in arguments.seeds:
            say(f"{mode}, seed {seed}")
            training = {"timesteps": arguments.timesteps, "symmetric": arguments.symmetric, **arguments.training}
            results.append(time_to_learn(mode, seed, arguments.limit, arguments.interval, say, **training))
    say(f"\n{summary(results)}")
    document = {
        "machine": machine(),
        "versions": versions(),
        "symmetric": arguments.symmetric,
        "training": arguments.training,
        "results": [asdict(result) for result in results],
    }
    write_json(arguments.output, document)
    say(f"\nmeasured on {machine()}; written to {arguments.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
