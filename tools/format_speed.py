"""Measure how fast long recordings are read and written on one core, and in how much memory."""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from benchmarks.format_speed import measure_formats
from benchmarks.measures import write
from quadruped_env.utils.program import run_program
from quadruped_env.utils.provenance import machine, versions


def main() -> int:
    """Parse the arguments and measure; fails where a goal is not reached."""
    parser = argparse.ArgumentParser(
        description="Messages a second and resident memory of writing, reading and converting a long recording of "
        "joint states with 8 positions, velocities and efforts, on one core. Prints a Markdown table and writes JSON. "
        "A million messages take three minutes and 1.5 GB of disk; let nothing else run meanwhile.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--messages", type=int, default=1_000_000, help="length of the recording")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path("results/format_speed.json"), help="where to write the JSON"
    )
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    measures = measure_formats(arguments.messages, lambda line: print(line, flush=True))
    write(measures, machine(), versions(), arguments.output)
    print(f"\nmeasured on one core of {machine()}; written to {arguments.output}")
    return 0 if all(measure.reached for measure in measures) else 1


if __name__ == "__main__":
    sys.exit(main())
