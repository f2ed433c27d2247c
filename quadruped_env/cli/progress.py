"""Progress of a program in a terminal or a log."""

import sys
import time
from typing import Final

QUIET: Final = 1.0
"""s in which a program need not say that it is at work"""
TERMINAL_INTERVAL: Final = 0.2
"""s between updates of the one line in a terminal"""
LOG_INTERVAL: Final = 10.0
"""s between lines where every update is a new one"""


class ProgressLine:
    """Says on stderr how far something is, once it has taken a second.

    The time that is left is estimated from the first call on: what comes before it (another part of the program, or
    the set-up of the first picture) says nothing about the pace of the rest.

    Args:
        label: what is being done.
    """

    def __init__(self, label: str) -> None:
        self._label = label
        self._start: tuple[float, float] | None = None
        """Time in s and share of the first call."""
        self._next = 0.0
        self._shown = False

    def __call__(self, share: float) -> None:
        """Take note that a share in [0, 1] of the work is done."""
        now = time.monotonic()
        if self._start is None or share < self._start[1]:
            self._start = now, share
            self._next = now + QUIET
        done = share >= 1.0
        if now < self._next and not (done and self._shown):
            return
        terminal = sys.stderr.isatty()
        elapsed, progress = now - self._start[0], share - self._start[1]
        left = f", {elapsed * (1.0 - share) / progress:.0f} s left" if progress > 0.0 else ""
        text = f"{self._label}: {share:4.0%}{left}"
        print(f"\r{text}" if terminal else text, end="\n" if done or not terminal else "", file=sys.stderr, flush=True)
        self._next = now + (TERMINAL_INTERVAL if terminal else LOG_INTERVAL)
        self._shown = not done
