"""Compare an exported policy with its golden trace, and name the first step and field that differ.

Without --trace, every runtime on this machine runs the graph: ONNX Runtime, OpenVINO. With it, the file is compared
that your own program wrote when it ran on the readings of golden_trace.csv; in a folder of --c-int8, with the results
of float32 and those of 8 bits, of which it has to equal one. Exit status 1 if anything differs by more than its
tolerance.

    mini-quadruped check-export runs/latest/export
    mini-quadruped check-export results/flat-export --trace my_loop.csv
"""

import argparse
from pathlib import Path

from quadruped_env.cli.invocation import Invocation


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the folder and the trace."""
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="folder that 'export' wrote")
    parser.add_argument(
        "--trace",
        type=Path,
        metavar="FILE",
        help="CSV file with the columns of golden_trace.csv, or those of some fields, by your own program",
    )


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Compare, and print one line for each runtime or file."""
    from quadruped_env.export.trace_check import ExportedTrace, check_export

    if arguments.trace is None:
        results = check_export(arguments.folder)
    else:
        results = ExportedTrace.load(arguments.folder).of_file(arguments.trace)
    for result in results:
        print(f"{result.name}: {result.text}")
    # A file is that of one form of the policy, and a folder with weights of 8 bits has two.
    passed = all if arguments.trace is None else any
    return 0 if passed(result.passed for result in results) else 1
