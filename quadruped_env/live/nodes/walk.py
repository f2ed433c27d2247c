"""The whole robot by one command: `sim`, `controller`, `state`, the viewer in the browser, and `teleop` in a terminal.

    mini-quadruped live walk
    mini-quadruped live walk runs/latest

Steer it with the keys that `teleop` shows, or with the arrow keys in the browser.
"""

import argparse
import sys

from quadruped_env.live.launch import common, launch
from quadruped_env.live.terrain import TERRAINS
from quadruped_env.viewer import PORT


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What drives the robot, and where the page is."""
    parser.add_argument("policy", nargs="?", default="flat", metavar="POLICY", help="as of 'controller' (%(default)s)")
    parser.add_argument("--port", type=int, default=PORT, help="of the page; the next free one is taken (%(default)s)")
    parser.add_argument("--terrain", choices=TERRAINS, default="flat", help="as of 'sim' (%(default)s)")
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="as of 'sim' (%(default)s)")


def start(arguments: argparse.Namespace) -> int:
    """Run them all until one ends."""
    keys = sys.stdin.isatty()
    # The terminal is for the keys then.
    shared = common(arguments.domain_id, arguments.subnet, arguments.seconds, arguments.quiet or keys)
    nodes = [
        ["sim", "--seed", str(arguments.seed), "--terrain", arguments.terrain, "--pick-up", "3", *shared],
        ["controller", arguments.policy, *shared],
        ["state", *shared],
        ["view", "--port", str(arguments.port), *shared],
    ]
    return launch([*nodes, ["teleop", *shared]] if keys else nodes)
