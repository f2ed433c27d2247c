"""Several nodes by one command, as a launch file: they begin together and end together."""

import signal
import subprocess
import sys
import time
from collections.abc import Sequence

from quadruped_env.live.session import CLEAR_LINE, POLL_PERIOD

_GRACE = 5.0
"""s that a node has to end by itself"""


def launch(nodes: Sequence[Sequence[str]]) -> int:
    """Run nodes, each a process, until one of them ends or Ctrl-C ends them all.

    Args:
        nodes: arguments of `python -m quadruped_env.live`, one list a node.

    Returns:
        0 if they ended as signals, else what the first that ended by itself returned.
    """
    signals: list[int] = []
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda number, _: signals.append(number))
    processes = [subprocess.Popen([sys.executable, "-m", "quadruped_env.live", *node]) for node in nodes]  # noqa: S603
    ended: list[tuple[str, int]] = []
    while not signals and not ended:
        time.sleep(POLL_PERIOD)
        ended = [
            (node[0], process.returncode)
            for node, process in zip(nodes, processes, strict=True)
            if process.poll() is not None
        ]
    if ended:
        _say(f"{ended[0][0]} ended; so do the others")
    for process in processes:
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
    for node, process in zip(nodes, processes, strict=True):
        try:
            process.wait(_GRACE)
        except subprocess.TimeoutExpired:
            _say(f"{node[0]} does not end by itself; it is killed")
            process.kill()
            process.wait()
    return ended[0][1] if ended else 0


def _say(text: str) -> None:
    print(f"{CLEAR_LINE if sys.stderr.isatty() else ''}[launch] {text}", file=sys.stderr)


def common(domain_id: int | None, subnet: bool, seconds: float | None, quiet: bool) -> list[str]:
    """What all nodes of a launch are arguments alike: the arguments of `add_common_arguments`."""
    arguments = [] if domain_id is None else ["--domain-id", str(domain_id)]
    arguments += ["--subnet"] * subnet + ["--quiet"] * quiet
    return arguments if seconds is None else [*arguments, "--seconds", str(seconds)]
