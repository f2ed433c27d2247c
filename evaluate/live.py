"""Measure how sim and controller walk together as two processes on live ROS 2 topics."""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env.live import benchmark
from quadruped_env.provenance import machine, versions


def main() -> int:
    """Parse the arguments and measure."""
    parser = argparse.ArgumentParser(
        description="Starts sim and controller as two processes, asks for a velocity, and listens: speed against the "
        "environment's, commands on time, latency, memory, drift of the clock. Prints a Markdown table and writes "
        "JSON. Let nothing else run meanwhile. One hour: --seconds 3600.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--seconds", type=float, default=60.0, help="duration of the measurement")
    parser.add_argument("--policy", default="flat", help="'flat' or a run's directory")
    parser.add_argument("--velocity", type=float, default=0.5, metavar="M/S", help="velocity command")
    parser.add_argument("--realtime", action="store_true", help="run both with real-time priority, as on a robot")
    parser.add_argument("--output", type=Path, default=Path("results/live.json"), help="where to write the JSON")
    args = parser.parse_args()
    try:
        walk = benchmark.measure(
            args.seconds,
            args.policy,
            args.velocity,
            args.realtime,
            lambda line: print(line, file=sys.stderr, flush=True),
        )
        print(walk)
        benchmark.write(walk, machine(), versions(), args.output)
    except (QuadrupedError, MissingExtraError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print(f"\nmeasured on {machine()}; written to {args.output}")
    return 0 if walk.reached else 1


if __name__ == "__main__":
    sys.exit(main())
