"""Which measurements are fit to act on: new ones, in order, and not late."""

import math
from collections.abc import Callable
from typing import Final

from quadruped_env.timestamps import NS_PER_SECOND

MAX_AGE: Final = 0.2
"""s"""
RELEARN: Final = 0.5
"""s for which all states must be late, while the robot is not moved, before their lag becomes the normal one"""
_ANOTHER_CLOCK: Final = 10.0
"""s; stamps that are further from those before a silence are of another clock, as of a simulator that was restarted"""
_CLOCK_DRIFT: Final = 1e-3
"""s/s by which the clocks of robot and controller may drift apart"""


class Gate:
    """Judges the stamps of one stream.

    The robot's clock need not be this machine's: what is late is known from how far stamps lag behind the time of their
    coming, measured against the least lag that was seen. While the robot is moved that measure only falls. While it is
    not, the measure begins again where it proves wrong: at once when states come with less lag; after `RELEARN` if all
    of them are late, as after a step of either clock, or when the first one was timed too early.

    Args:
        what: for the reasons it gives.
        relearned: is called with the change in s when the measure begins again.
    """

    def __init__(self, what: str, relearned: Callable[[float], None] = lambda change: None) -> None:
        self._what = what
        self._relearned = relearned
        self._last: int | None = None
        self._lag = math.inf
        self._seen = 0.0
        self._late_since: float | None = None
        self._late_lag = math.inf
        """Least lag since then"""

    def refusal(self, stamp: int, now: float, moving: bool = True) -> str:
        """Why not to act on a measurement; empty if it is fit.

        Args:
            stamp: ns of the robot's clock.
            now: s of this machine's, steady; when the measurement was taken.
            moving: whether the robot is being moved.
        """
        lag = now - stamp / NS_PER_SECOND
        least = self._lag + _CLOCK_DRIFT * (now - self._seen)
        if lag > least + MAX_AGE and self._always_late(lag, now) and not moving:
            self._begin(self._late_lag, now)
            self._relearned(self._lag - least)
            least = self._lag
        if self._last is None and (lag < least or abs(lag - least) > _ANOTHER_CLOCK):
            self._accept(stamp, lag, now)
            return ""
        if self._last is not None and stamp <= self._last:
            return f"{self._what}: a stamp that is not later than the one before; such messages are left out"
        if lag > least + MAX_AGE:
            return f"{self._what}: stale by more than {MAX_AGE:g} s; check the network, or the clock of what sends it"
        if lag < least - MAX_AGE:
            if not moving:
                self._begin(lag, now)
                self._relearned(lag - least)
            return (
                f"{self._what}: its clock leapt ahead by more than {MAX_AGE:g} s, or what came before was late; "
                f"begins anew {'after a silence' if moving else 'with what comes next'}"
            )
        self._accept(stamp, min(lag, least), now)
        return ""

    def reset(self) -> None:
        """Begin anew: what comes next may be of another clock, but what was late still is."""
        self._last = None

    def _always_late(self, lag: float, now: float) -> bool:
        """Whether all measurements have been late for `RELEARN`, this late one included."""
        if self._late_since is None or (now - self._late_since >= RELEARN and lag > self._late_lag + MAX_AGE):
            # The first one, or one that is late even for these.
            self._late_since, self._late_lag = now, lag
            return False
        self._late_lag = min(self._late_lag, lag)
        return now - self._late_since >= RELEARN

    def _begin(self, lag: float, now: float) -> None:
        self._last, self._lag, self._seen = None, lag, now
        self._late_since = None

    def _accept(self, stamp: int, lag: float, now: float) -> None:
        self._last, self._lag, self._seen = stamp, lag, now
        self._late_since = None
