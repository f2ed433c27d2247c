"""Compare an exported policy with its golden trace, and name the first step and field that differ.

Without --trace, ONNX Runtime runs the graph here. With it, the file is compared that your own program wrote when it ran
on the readings of golden_trace.csv. Exit status 1 if anything differs by more than its tolerance.

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
        help="CSV file with the columns of golden_trace.csv, or of some fields, by your own program",
    )


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Compare, and print the result."""
    from quadruped_env.export.trace_check import ExportedTrace, check_export

    folder, trace = arguments.folder, arguments.trace
    result = check_export(folder) if trace is None else ExportedTrace.load(folder).of_file(trace)
    print(f"{result.name}: {result.text}")
    return 0 if result.passed else 1
