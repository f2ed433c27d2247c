"""Real time: periodic deadlines and priority."""

import os
import time
from collections.abc import Callable
from typing import Final

_PRIORITY: Final = 10
"""SCHED_FIFO priority, 1 to 99; kernel threads have higher priorities."""
_MAX_LAG: Final = 0.1
"""Delay beyond which deadlines are skipped instead of caught up, s."""

Clock = Callable[[], float]
"""A monotonic clock, s from an arbitrary start."""


def request_realtime_priority() -> str:
    """Give this thread, and the threads that it starts, real-time priority (SCHED_FIFO).

    Returns:
        The reason if the system refuses it, otherwise an empty string.
    """
    if not hasattr(os, "sched_setscheduler"):
        return "this system does not support SCHED_FIFO"
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(_PRIORITY))
    except PermissionError:
        return "no permission for SCHED_FIFO; raise 'ulimit -r' to at least 10, or run as root"
    return ""


class Pace:
    """Periodic deadlines on a fixed grid, so that delays do not accumulate.

    Args:
        period: time between deadlines, s.
        clock: a monotonic clock such as `time.monotonic`.
    """

    def __init__(self, period: float, clock: Clock = time.monotonic) -> None:
        self.period = period
        self.ticks = 0
        """Number of deadlines met or skipped."""
        self.lost = 0
        """Number of deadlines skipped."""
        self._clock = clock
        self._start = clock()

    @property
    def due(self) -> float:
        """The next deadline, by the clock, s."""
        return self._start + self.ticks * self.period

    @property
    def remaining(self) -> float:
        """Time to the next deadline, s; negative once it has passed."""
        return self.due - self._clock()

    def tick(self) -> bool:
        """Returns True if a deadline has come, and counts it as met."""
        late = -self.remaining
        if late < 0.0:
            return False
        if late > _MAX_LAG:
            missed = int(late / self.period)
            self.ticks += missed
            self.lost += missed
        self.ticks += 1
        return True
