"""The tutorial's launch file as one command: `gait`, `state` and the viewer in the browser.

mini-quadruped live display --preset walk
"""

import argparse

from quadruped_env.gait import PRESETS
from quadruped_env.live.node_launch import launch
from quadruped_env.live.node_options import COMMON, add_robot_argument, passed_on
from quadruped_env.viewer import PORT
from quadruped_env.viewer.server import add_allow_host


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the gait preset, the viewer's port and the robot."""
    add_robot_argument(parser)
    parser.add_argument("--preset", choices=PRESETS, default="article", help="gait preset (default: %(default)s)")
    parser.add_argument("--port", type=int, default=PORT, help="first port to try for the page (default: %(default)s)")
    add_allow_host(parser)


def start(arguments: argparse.Namespace) -> int:
    """Run the three nodes until one ends."""
    shared = passed_on(arguments, "task", "map", *COMMON)
    gait, view = passed_on(arguments, "preset"), passed_on(arguments, "port", "allow_host")
    return launch([["gait", *gait, *shared], ["state", *shared], ["view", *view, *shared]], status="gait")
