"""Which measurements are fit to act on: new ones, in order, and not late."""

import math
from typing import Final

from quadruped_env.live.stamps import NANOSECONDS

MAX_AGE: Final = 0.2
"""s"""
_ANOTHER_CLOCK: Final = 10.0
"""s; stamps that are further from those before a silence are of another clock, as of a simulator that was restarted"""
_CLOCK_DRIFT: Final = 1e-3
"""s/s by which the clocks of robot and controller may drift apart"""


class Gate:
    """Judges the stamps of one stream.

    The robot's clock need not be this machine's: what is late is known from how far stamps lag behind the time of their
    coming, measured against the least lag that was seen.

    Args:
        what: for the reasons it gives.
    """

    def __init__(self, what: str) -> None:
        self._what = what
        self._last: int | None = None
        self._lag = math.inf
        self._seen = 0.0

    def refusal(self, stamp: int, now: float) -> str:
        """Why not to act on a measurement; empty if it is fit.

        Args:
            stamp: ns of the robot's clock.
            now: s of this machine's, steady.
        """
        lag = now - stamp / NANOSECONDS
        least = self._lag + _CLOCK_DRIFT * (now - self._seen)
        if self._last is None and (lag < least or abs(lag - least) > _ANOTHER_CLOCK):
            self._last, self._lag, self._seen = stamp, lag, now
            return ""
        if self._last is not None and stamp <= self._last:
            return f"{self._what}: a stamp that is not later than the one before; such messages are left out"
        if lag > least + MAX_AGE:
            return f"{self._what}: stale by more than {MAX_AGE:g} s; check the network, or the clock of what sends it"
        if lag < least - MAX_AGE:
            return (
                f"{self._what}: its clock leapt ahead by more than {MAX_AGE:g} s, or what came before was late; "
                f"begins anew after a silence"
            )
        self._last, self._lag, self._seen = stamp, min(lag, least), now
        return ""

    def reset(self) -> None:
        """Begin anew: what comes next may be of another clock, but what was late still is."""
        self._last = None
