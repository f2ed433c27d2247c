"""Several nodes from one command, like a launch file: they start together and end together."""

import signal
import subprocess
import sys
import time
from collections.abc import Sequence

from quadruped_env.live.session import POLL_PERIOD
from quadruped_env.utils.program import CLEAR_LINE, on_stop

_GRACE = 5.0
"""Time for a node to end before it is killed, s."""


def launch(nodes: Sequence[Sequence[str]], status: str) -> int:
    """Run each node in its own process until one of them ends or Ctrl-C ends all.

    Args:
        nodes: arguments of `python -m quadruped_env.live`, one list per node.
        status: the node that has a status line if they share a terminal; several would overwrite each other.

    Returns:
        0 after Ctrl-C, otherwise the exit status of the node that ended first.
    """
    signals: list[int] = []
    with on_stop(signals.append):
        return _launch(nodes, status, signals)


def _launch(nodes: Sequence[Sequence[str]], status: str, signals: Sequence[int]) -> int:
    shared = sys.stderr.isatty()
    commands = [[*node, *["--quiet"] * (shared and node[0] != status)] for node in nodes]
    processes = [subprocess.Popen([sys.executable, "-m", "quadruped_env.live", *node]) for node in commands]  # noqa: S603
    ended: list[tuple[str, int]] = []
    while not signals and not ended:
        time.sleep(POLL_PERIOD)
        ended = [
            (node[0], process.returncode)
            for node, process in zip(nodes, processes, strict=True)
            if process.poll() is not None
        ]
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


def _say(text: str) -> None:
    print(f"{CLEAR_LINE if sys.stderr.isatty() else ''}[launch] {text}", file=sys.stderr)
