"""Progress of a program in a terminal or a log."""

import sys
import time
from typing import Final

QUIET: Final = 1.0
"""Time before the first message, s."""
TERMINAL_INTERVAL: Final = 0.2
"""Time between updates of the line in a terminal, s."""
LOG_INTERVAL: Final = 10.0
"""Time between lines where the output is not a terminal, s."""


class ProgressLine:
    """Prints the progress of a task on stderr, once the task has taken a second.

    The remaining time is estimated from the time since the first call, because the time before it (other parts of the
    program, or the set-up of the first image) does not indicate the speed of the task.

    Args:
        label: name of the task.
    """

    def __init__(self, label: str) -> None:
        self._label = label
        self._start: tuple[float, float] | None = None
        """Time in s and progress at the first call."""
        self._next = 0.0
        self._shown = False

    def __call__(self, share: float) -> None:
        """Report the fraction of the work that is done, in [0, 1]."""
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
