"""The whole robot from one command: `sim`, `controller`, `state`, the viewer, and `teleop` in a terminal.

    mini-quadruped live walk
    mini-quadruped live walk runs/latest

Steer it with the keys of `teleop`, or with the arrow keys in the browser.
"""

import argparse
import sys

from quadruped_env.live.node_launch import launch
from quadruped_env.live.node_options import (
    COMMON,
    GROUND,
    add_robot_argument,
    add_terrain_arguments,
    chosen_terrain,
    passed_on,
)
from quadruped_env.policies.files import DEFAULT
from quadruped_env.viewer import PORT
from quadruped_env.viewer.server import add_allow_host


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policy, the terrain, the viewer's port, and the robot."""
    add_robot_argument(parser)
    parser.add_argument(
        "policy", nargs="?", default=DEFAULT, metavar="POLICY", help="as for 'controller' (default: %(default)s)"
    )
    parser.add_argument("--port", type=int, default=PORT, help="first port to try for the page (default: %(default)s)")
    add_allow_host(parser)
    add_terrain_arguments(parser, "as for 'sim'")


def start(arguments: argparse.Namespace) -> int:
    """Run all nodes until one ends."""
    chosen_terrain(arguments)  # an unknown terrain is an error before any node starts
    common, robot = passed_on(arguments, *COMMON), passed_on(arguments, "task", "map", *COMMON)
    ground, port = passed_on(arguments, *GROUND), passed_on(arguments, "port", "allow_host")
    nodes = [
        ["sim", *ground, "--pick-up", "3", *robot],
        ["controller", arguments.policy, *robot],
        ["state", *robot],
        ["view", *port, *ground, *robot],
    ]
    return launch([*nodes, ["teleop", *common]], "teleop") if sys.stdin.isatty() else launch(nodes, "controller")
