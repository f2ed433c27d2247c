"""Progress of a program in a terminal or a log."""

import sys
import time
from typing import Final

QUIET: Final = 2.0
"""Time before the first message, s."""
TERMINAL_INTERVAL: Final = 0.2
"""Time between updates of the line in a terminal, s."""
LOG_INTERVAL: Final = 10.0
"""Time between lines where the output is not a terminal, s."""
CALLS: Final = 3
"""Number of calls from which the remaining time is estimated, at least"""
RECENT: Final = 0.25
"""Last part of the time so far from which it is estimated"""


class ProgressLine:
    """Prints the progress of a task on stderr, once the task has taken two seconds, and in the end its time.

    The beginning of a task (the set-up of the first image, compilation) does not indicate the speed of the rest, so the
    remaining time is estimated from the last quarter of the time so far.

    Args:
        label: name of the task.
    """

    def __init__(self, label: str) -> None:
        self._label = label
        self._calls: list[tuple[float, float]] = []
        """Time in s and progress at recent calls."""
        self._first = 0.0
        """Time of the first call, s."""
        self._next = 0.0
        self._shown = False

    def __call__(self, share: float) -> None:
        """Report the fraction of the work that is done, in [0, 1]."""
        now = time.monotonic()
        if not self._calls or share < self._calls[-1][1]:
            self._calls, self._first, self._next = [], now, now + QUIET
        self._calls.append((now, share))
        done = share >= 1.0
        if now < self._next and not (done and self._shown):
            return
        terminal = sys.stderr.isatty()
        rest = f" in {now - self._first:.1f} s" if done else self._left(now)
        text = f"{self._label}: {share:4.0%}{rest}"
        # Blanks, because the text before may have been longer.
        line = f"\r{text:<40}" if terminal else text
        print(line, end="\n" if done or not terminal else "", file=sys.stderr, flush=True)
        self._next = now + (TERMINAL_INTERVAL if terminal else LOG_INTERVAL)
        self._shown = not done

    def _left(self, now: float) -> str:
        """The remaining time; nothing as long as it cannot be estimated."""
        recent = now - RECENT * (now - self._first)
        while len(self._calls) > CALLS and self._calls[1][0] <= recent:
            self._calls.pop(0)
        (since, before), (_, share) = self._calls[0], self._calls[-1]
        if len(self._calls) < CALLS or share <= before:
            return ""
        return f", {(now - since) * (1.0 - share) / (share - before):.0f} s left"
