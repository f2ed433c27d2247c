"""Measure how sim and controller walk together as two processes on live ROS 2 topics."""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from benchmarks import live as benchmark
from quadruped_env.utils.program import run_program
from quadruped_env.utils.provenance import machine, versions


def main() -> int:
    """Parse the arguments and measure."""
    parser = argparse.ArgumentParser(
        description="Starts sim and controller as two processes, asks for a velocity, and listens: speed against the "
        "environment's, commands on time, latency, memory, drift of the clock. Prints a Markdown table and writes "
        "JSON. Let nothing else run meanwhile. One hour: --seconds 3600.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--seconds", type=float, default=60.0, help="how long to count")
    parser.add_argument("--policy", default="flat", help="'flat' or a run's directory")
    parser.add_argument("--velocity", type=float, default=0.5, metavar="M/S", help="to ask for")
    parser.add_argument("--realtime", action="store_true", help="let the two run before all else, as on a robot")
    parser.add_argument("-o", "--output", type=Path, default=Path("results/live.json"), help="where to write the JSON")
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    walk = benchmark.measure(
        arguments.seconds,
        arguments.policy,
        arguments.velocity,
        arguments.realtime,
        lambda line: print(line, file=sys.stderr, flush=True),
    )
    print(walk)
    benchmark.write(walk, machine(), versions(), arguments.output)
    print(f"\nmeasured on {machine()}; written to {arguments.output}")
    return 0 if walk.reached else 1


if __name__ == "__main__":
    sys.exit(main())
