"""Progress of a task: its callback, and the line that a program prints about it."""

import shutil
import sys
import time
from collections.abc import Callable
from typing import Final

Progress = Callable[[float], None]
"""Progress callback: called with the fraction done, in [0, 1]."""

QUIET: Final = 2.0
"""Time before the first message, s."""
TERMINAL_INTERVAL: Final = 0.2
"""Time between updates of the line in a terminal, s."""
LOG_INTERVAL: Final = 10.0
"""Time between lines where the output is not a terminal, s."""


def part_of(progress: Progress | None, begin: float, end: float) -> Progress | None:
    """Return the progress callback for a part of the work, from `begin` to `end` of the whole; None without one."""
    return None if progress is None else lambda share: progress(begin + share * (end - begin))


class ProgressLine:
    """Prints the progress of a task on stderr, once the task has taken two seconds, and at the end its time.

    Args:
        label: name of the task.
    """

    def __init__(self, label: str) -> None:
        self._label = label
        self._first = self._next = 0.0
        """Times of the first call and of the next message, s."""
        self._begun, self._before = 1.0, float("inf")
        """Fractions at the first call and at the call before."""
        self._shown = False

    def __call__(self, share: float, note: str = "") -> None:
        """Report the fraction of the work that is done, in [0, 1], and what else there is to say."""
        now, done = time.monotonic(), share >= 1.0
        if share < self._before:  # a new task
            self._first, self._next, self._begun = now, now + QUIET, share
        self._before = share
        if now < self._next and not (done and self._shown):
            return
        spent, gained = now - self._first, share - self._begun
        left = f", {spent * (1.0 - share) / gained:.0f} s left" if gained > 0.0 else ""
        text = f"{self._label}: {share:4.0%}{f' in {spent:.1f} s' if done else left}{note}"
        if terminal := sys.stderr.isatty():
            text = "\r\x1b[K" + text[: shutil.get_terminal_size().columns - 1]
        print(text, end="\n" if done or not terminal else "", file=sys.stderr, flush=True)
        self._next = now + (TERMINAL_INTERVAL if terminal else LOG_INTERVAL)
        self._shown = not done

    def close(self) -> None:
        """Leave the line as it is, before the task is done."""
        if self._shown and sys.stderr.isatty():
            print(file=sys.stderr)
