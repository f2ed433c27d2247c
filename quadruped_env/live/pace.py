"""Real time: loops that keep to a grid of deadlines, and meters of rate."""

import os
import time
from collections.abc import Callable
from typing import Final

_PRIORITY: Final = 10
"""of 1 to 99; those of the system's own threads lie above"""

Clock = Callable[[], float]
"""s from any start, which never goes back"""


def request_realtime_priority() -> str:
    """Let this thread, and those that it starts, run before every program of ordinary priority.

    Returns:
        Why not, where the system does not allow it; else empty.
    """
    if not hasattr(os, "sched_setscheduler"):
        return "this system knows no SCHED_FIFO"
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(_PRIORITY))
    except PermissionError:
        return "no right to SCHED_FIFO; 'ulimit -r' must be at least 10, or the program be root's"
    return ""


class Pace:
    """Deadlines at equal distances from a start, so that lateness never adds up.

    Args:
        period: s between deadlines.
        clock: of `time.monotonic`'s kind.
        max_lag: s; what a loop is later than that is lost, so that it does not race to catch up.
    """

    def __init__(self, period: float, clock: Clock = time.monotonic, max_lag: float = 0.1) -> None:
        self.period = period
        self.ticks = 0
        """Deadlines that were met or passed over"""
        self.lost = 0
        """Deadlines that were passed over"""
        self.latest = 0.0
        """s by which the latest one was missed"""
        self._clock = clock
        self._start = clock()
        self._max_lag = max_lag

    @property
    def due(self) -> float:
        """The next deadline, on the clock."""
        return self._start + self.ticks * self.period

    @property
    def remaining(self) -> float:
        """Seconds to the next deadline; negative once it has passed."""
        return self.due - self._clock()

    def tick(self) -> bool:
        """Whether a deadline has come, which then counts as met."""
        late = -self.remaining
        if late < 0.0:
            return False
        self.latest = max(self.latest, late)
        if late > self._max_lag:
            missed = int(late / self.period)
            self.ticks += missed
            self.lost += missed
        self.ticks += 1
        return True


class Rate:
    """How fast a count grows, from look to look.

    Args:
        clock: of `time.monotonic`'s kind.
        since: when the count was 0, on the clock; None is now.
    """

    def __init__(self, clock: Clock = time.monotonic, since: float | None = None) -> None:
        self._clock = clock
        self._then = clock() if since is None else since
        self._count = 0

    def per_second(self, count: int) -> float:
        """Growth per second since the last call."""
        now = self._clock()
        elapsed, self._then = now - self._then, now
        grown, self._count = count - self._count, count
        return grown / elapsed if elapsed > 0.0 else 0.0
