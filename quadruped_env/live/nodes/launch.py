"""Several nodes from one command, like a launch file: they start together and end together."""

import argparse
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from typing import Final

from quadruped_env.gait import PRESETS
from quadruped_env.live.node_options import (
    add_robot_argument,
    add_terrain_arguments,
    chosen_terrain,
)
from quadruped_env.live.session import POLL_PERIOD
from quadruped_env.policies.files import DEFAULT
from quadruped_env.utils.program import on_stop
from quadruped_env.viewer import PORT
from quadruped_env.viewer.server import add_allow_host

_GRACE: Final = 5.0
"""Time for a node to end before it is killed, s."""
_SHARED: Final = ("subnet", "namespace", "remap")
"""Options of all nodes."""
_ROBOT: Final = ("task", "map", *_SHARED)
_GROUND: Final = ("terrain", "level", "seed")
_PAGE: Final = ("port", "allow_host")


class Display:
    """The tutorial's launch file as one command: `gait`, `state` and the viewer in the browser.

    mini-quadruped live display --preset walk
    """

    @staticmethod
    def add_arguments(parser: argparse.ArgumentParser) -> None:
        """Add the gait preset, the viewer's port and the robot."""
        add_robot_argument(parser)
        parser.add_argument("--preset", choices=PRESETS, default="article", help="gait preset (default: %(default)s)")
        add_view_arguments(parser)

    @staticmethod
    def start(arguments: argparse.Namespace) -> int:
        """Run the three nodes until one ends."""
        nodes = {"gait": ("preset", *_ROBOT), "state": _ROBOT, "view": (*_PAGE, *_ROBOT)}
        return _launch([[node, *passed_on(arguments, *names)] for node, names in nodes.items()])


class Walk:
    """The whole robot from one command: `sim`, `controller`, `state`, the viewer, and `teleop` in a terminal.

        mini-quadruped live walk
        mini-quadruped live walk runs/latest

    Steer it with the keys of `teleop`, or with the arrow keys in the browser.
    """

    @staticmethod
    def add_arguments(parser: argparse.ArgumentParser) -> None:
        """Add the policy, the terrain, the viewer's port, and the robot."""
        add_robot_argument(parser)
        parser.add_argument(
            "policy", nargs="?", default=DEFAULT, metavar="POLICY", help="as for 'controller' (default: %(default)s)"
        )
        add_view_arguments(parser)
        add_terrain_arguments(parser, "as for 'sim'")

    @staticmethod
    def start(arguments: argparse.Namespace) -> int:
        """Run all nodes until one ends."""
        chosen_terrain(arguments)  # an unknown terrain is an error before any node starts
        nodes = [
            ["sim", "--pick-up", "3", *passed_on(arguments, *_GROUND, *_ROBOT)],
            ["controller", arguments.policy, *passed_on(arguments, *_ROBOT)],
            ["state", *passed_on(arguments, *_ROBOT)],
            ["view", *passed_on(arguments, *_PAGE, *_GROUND, *_ROBOT)],
        ]
        return _launch([*nodes, *[["teleop", *passed_on(arguments, *_SHARED)]] * sys.stdin.isatty()])


def add_view_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of the viewer's page."""
    parser.add_argument("--port", type=int, default=PORT, help="first port to try for the page (default: %(default)s)")
    add_allow_host(parser)


def passed_on(arguments: argparse.Namespace, *names: str) -> list[str]:
    """Return options as they were given, for another node."""
    found = []
    for name in names:
        value = getattr(arguments, name)
        for one in value if isinstance(value, list) else [value]:
            if one is not None and one is not False:
                found += [f"--{name.replace('_', '-')}", *([] if one is True else [str(one)])]
    return found


def _launch(nodes: Sequence[Sequence[str]]) -> int:
    """Run each node in its own process until one of them ends or Ctrl-C ends all.

    Args:
        nodes: arguments of `python -m quadruped_env.live`, one list per node.

    Returns:
        0 after Ctrl-C, otherwise the exit status of the node that ended first.
    """
    signals: list[int] = []
    with on_stop(signals.append):
        processes = [subprocess.Popen([sys.executable, "-m", "quadruped_env.live", *node]) for node in nodes]  # noqa: S603
        ended: list[tuple[str, int]] = []
        while not signals and not ended:
            time.sleep(POLL_PERIOD)
            found = [(node[0], process.poll()) for node, process in zip(nodes, processes, strict=True)]
            ended = [(name, status) for name, status in found if status is not None]
        if ended:
            _say(f"{ended[0][0]} ended; ending the other nodes")
        for process in processes:
            if process.poll() is None:
                process.send_signal(signal.SIGINT)
        for node, process in zip(nodes, processes, strict=True):
            try:
                process.wait(_GRACE)
            except subprocess.TimeoutExpired:
                _say(f"{node[0]} has not ended within {_GRACE:g} s; killing it")
                process.kill()
                process.wait()
    return ended[0][1] if ended else 0


def _say(line: str) -> None:
    print(f"[launch] {line}", file=sys.stderr, flush=True)
