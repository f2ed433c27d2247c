"""The tutorial's launch file by one command: `gait`, `state` and the viewer in the browser.

mini-quadruped live display --preset walk
"""

import argparse

from quadruped_env.gait import PRESETS
from quadruped_env.live.launch import common, launch
from quadruped_env.viewer import PORT


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Which gait, and where the page is."""
    parser.add_argument("--preset", choices=PRESETS, default="article", help="which gait (%(default)s)")
    parser.add_argument("--port", type=int, default=PORT, help="of the page; the next free one is taken (%(default)s)")


def start(arguments: argparse.Namespace) -> int:
    """Run the three until one ends."""
    shared = common(arguments.domain_id, arguments.subnet, arguments.seconds, arguments.quiet)
    return launch(
        [
            ["gait", "--preset", arguments.preset, *shared],
            ["state", *shared],
            ["view", "--port", str(arguments.port), *shared],
        ]
    )
