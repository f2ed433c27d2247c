"""Write one HTML file in which a policy's robot walks, in any browser: to open, to send, or to put on a web site.

It opens from the disk without a server, and makes no request: it holds MuJoCo, the robot and the policy. Keys, touch
and a gamepad steer; a click on the robot pushes it; sliders change its world. No extra is needed to write it.

    mini-quadruped page                        the latest run in runs/, or the shipped policy rough: walk.html
    mini-quadruped page runs/<name>            a run; if it was interrupted, its last checkpoint
    mini-quadruped page flat -o flat.html      a shipped policy
"""

import argparse
from pathlib import Path

from quadruped_env.cli.common_options import add_output, add_overwrite, add_run, add_task_file
from quadruped_env.cli.invocation import Invocation
from quadruped_env.policies.files import SHOWN


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policy and the file."""
    add_run(parser, SHOWN)
    add_task_file(parser)
    add_overwrite(parser, "replace an earlier file")
    add_output(parser, "FILE", "the file (default: %(default)s)", Path("walk.html"))


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Write the page, and print where it is."""
    from quadruped_env.evaluation.evaluated_policy import find_policy
    from quadruped_env.utils.files import check_free
    from quadruped_env.walking_page import write_page

    check_free([arguments.output], arguments.overwrite)
    evaluated = find_policy(arguments.run, None, arguments.task, arguments.trust_task, SHOWN)
    write_page(evaluated.policy, arguments.output, evaluated.name)
    size = arguments.output.stat().st_size / 1e6
    print(f"{evaluated.name}: {arguments.output} ({size:.1f} MB); open it in a browser")
    return 0
