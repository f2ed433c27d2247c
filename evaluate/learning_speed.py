"""Measure how long it takes to learn to walk."""

import argparse
import sys
from dataclasses import asdict
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env.files import write_json
from quadruped_env.provenance import machine, versions


def main() -> int:
    """Parse the arguments, train each seed until it walks, and print the table."""
    parser = argparse.ArgumentParser(
        description="Train seeds until each walks at a commanded 0.5 m/s (64 episodes of 10 s, at most 2 falls, "
        "speed within 0.05 m/s, yaw rate at most 0.1 rad/s) and report the wall clock of learning, with the seeds that "
        "failed. Testing does not count as learning. Takes minutes on two cores; let nothing else run meanwhile.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--action-modes", nargs="+", default=["position", "residual"], help="which modes")
    parser.add_argument("--seeds", type=int, nargs="+", default=[0, 1, 2, 3, 4], help="seeds, each trained on its own")
    parser.add_argument(
        "--timesteps", type=int, default=2_000_000, help="budget at which the schedules of learning rate and noise end"
    )
    parser.add_argument(
        "--symmetric",
        action=argparse.BooleanOptionalAction,
        default=True,
        help="make the policy left/right symmetric by construction",
    )
    parser.add_argument("--limit", type=float, default=60.0, help="s of learning after which a seed has failed")
    parser.add_argument("--interval", type=float, default=1.0, help="s of learning between tests")
    parser.add_argument("--output", type=Path, default=Path("results/learning_speed.json"), help="where to write JSON")
    args = parser.parse_args()
    try:
        import quadruped_env.training.ppo  # noqa: F401  (it names the extra that is missing)
    except MissingExtraError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    from quadruped_env.benchmarks.learning_speed import summary, time_to_walk

    def say(line: str) -> None:
        print(line, flush=True)

    results = []
    try:
        for mode in args.action_modes:
            for seed in args.seeds:
                say(f"{mode}, seed {seed}")
                training = {"timesteps": args.timesteps, "symmetric": args.symmetric}
                results.append(time_to_walk(mode, seed, args.limit, args.interval, say, **training))
        say(f"\n{summary(results)}")
        document = {
            "machine": machine(),
            "versions": versions(),
            "symmetric": args.symmetric,
            "results": [asdict(result) for result in results],
        }
        write_json(args.output, document)
    except (QuadrupedError, MissingExtraError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    say(f"\nmeasured on {machine()}; written to {args.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
