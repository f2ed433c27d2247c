"""The whole robot from one command: `sim`, `controller`, `state`, the viewer, and `teleop` in a terminal.

    mini-quadruped live walk
    mini-quadruped live walk runs/latest

Steer it with the keys of `teleop`, or with the arrow keys in the browser.
"""

import argparse
import sys

from quadruped_env.control.policy_files import LIVE_POLICY
from quadruped_env.live.node_launch import common, launch
from quadruped_env.live.robot_option import add_robot_argument, robot_arguments
from quadruped_env.live.terrain_arguments import add_terrain_arguments, chosen_terrain
from quadruped_env.viewer import PORT


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policy, the terrain, the viewer's port, and the robot."""
    add_robot_argument(parser)
    parser.add_argument(
        "policy", nargs="?", default=LIVE_POLICY, metavar="POLICY", help="as for 'controller' (default: %(default)s)"
    )
    parser.add_argument("--port", type=int, default=PORT, help="first port to try for the page (default: %(default)s)")
    add_terrain_arguments(parser, "as for 'sim'")


def start(arguments: argparse.Namespace) -> int:
    """Run all nodes until one ends."""
    chosen_terrain(arguments)  # an unknown terrain is an error before any node starts
    keys = sys.stdin.isatty()
    shared = common(arguments.domain_id, arguments.subnet, arguments.seconds, arguments.quiet)
    robot = robot_arguments(arguments)
    level = [] if arguments.level is None else ["--level", str(arguments.level)]
    ground = ["--seed", str(arguments.seed), "--terrain", arguments.terrain, *level]
    nodes = [
        ["sim", *ground, "--pick-up", "3", *robot, *shared],
        ["controller", arguments.policy, *robot, *shared],
        ["state", *robot, *shared],
        ["view", "--port", str(arguments.port), *ground, *robot, *shared],
    ]
    return launch([*nodes, ["teleop", *shared]], "teleop") if keys else launch(nodes, "controller")
