"""Measure speed and memory."""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from benchmarks import measures, throughput
from quadruped_env.utils.program import run_program
from quadruped_env.utils.provenance import machine, versions


def main() -> int:
    """Parse the arguments and measure."""
    parser = argparse.ArgumentParser(
        description="Speed and memory of the environments and of training, each as a ratio to a bare simulation or to "
        "another environment within this run. Prints a Markdown table and writes JSON. Takes about six minutes on two "
        "cores, most of it for the memory of a long training. Let nothing else run meanwhile.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--memory-steps", type=int, default=5_000_000, help="length of the training watched for leaks")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path("results/throughput.json"), help="where to write the JSON"
    )
    parser.add_argument(
        "--only",
        nargs="+",
        action="extend",
        choices=[*throughput.WORKS, throughput.MEMORY],
        default=[],
        metavar="NAME",
        help=f"measure only these: {', '.join([*throughput.WORKS, throughput.MEMORY])}",
    )
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    print(measures.HEADER, flush=True)
    found = throughput.run_all(arguments.memory_steps, lambda line: print(line, flush=True), arguments.only)
    measures.write(found, machine(), versions(), arguments.output)
    print(f"\nmeasured on {machine()}; written to {arguments.output}")
    return 0 if all(measure.reached for measure in found) else 1


if __name__ == "__main__":
    sys.exit(main())
