"""Export a policy for deployment: a folder that needs nothing of this package.

It holds the policy as ONNX, from readings in SI units to joint targets; a golden trace for 'check-export'; a manifest
of joints, gains, limits, command and entry pose; a page with results; the policy's own files; and the robot's URDF and
MJCF. The graph is compared with the policy on ONNX Runtime first. Nothing is uploaded.

    mini-quadruped export                      the latest run in runs/, or the shipped policy flat
    mini-quadruped export runs/<name>          a run; if it was interrupted, its last checkpoint
    mini-quadruped export flat --film          a shipped policy, with a film
    mini-quadruped export flat --hub           for a model hub: also a film and the page that walks
    mini-quadruped export flat --c             also as C99 for a microcontroller, with a sketch for an ESP32
"""

import argparse
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from quadruped_env.cli.common_options import add_output, add_overwrite, add_run, add_task_file
from quadruped_env.cli.invocation import Invocation
from quadruped_env.utils.progress import ProgressLine

if TYPE_CHECKING:
    from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policy and the folder."""
    add_run(parser)
    parser.add_argument("--film", action="store_true", help="also film the robot: film.webp in the folder")
    parser.add_argument(
        "--hub",
        action="store_true",
        help="the folder for a model hub: also the film and the page that walks",
    )
    parser.add_argument("--c", action="store_true", help="also write the policy as C99, and a sketch for an ESP32")
    add_task_file(parser)
    add_overwrite(parser, "replace an earlier export")
    add_output(parser, "DIR", "the folder (default: RUN/export, or results/flat-export)")


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Export, and print what was written."""
    from quadruped_env.evaluation.evaluated_policy import find_policy
    from quadruped_env.export import export_policy
    from quadruped_env.export.folder import check_output

    evaluated = find_policy(arguments.run, None, arguments.task, arguments.trust_task)
    own = not evaluated.is_shipped and not evaluated.address
    default = evaluated.output.with_name("export") if own else Path("results", f"{evaluated.name}-export")
    output = arguments.output or default
    check_output(output, arguments.overwrite)
    export = export_policy(
        evaluated,
        output,
        arguments.film or arguments.hub,
        arguments.overwrite,
        ProgressLine("filming"),
        arguments.c,
        _page_writer(evaluated) if arguments.hub else None,
    )
    graph = export.manifest["graph"]
    print(
        f"{evaluated.name}: {len(graph['inputs'])} inputs, opset {graph['onnx_opset']}; ONNX Runtime differs from the "
        f"policy by {graph['largest_difference_from_the_policy']:.1g} at most"
    )
    if export.manifest["evaluation"] is None:
        print("no results are included: evaluate the policy first to export them, too")
    print(f"folder: {export.folder} ({', '.join(export.files)})")
    if arguments.hub:
        print(f"to upload it: {shlex.join(['hf', 'upload', f'OWNER/{evaluated.name}', str(export.folder)])}")
    return 0


def _page_writer(evaluated: "EvaluatedPolicy") -> Callable[[Path], object]:
    from quadruped_env.walking_page import write_page

    return lambda path: write_page(evaluated.policy, path, evaluated.name)
