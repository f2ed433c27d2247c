"""Filter for measurements by timestamp: it accepts those that are new, in order and not late."""

import math
from collections.abc import Callable
from typing import Final

from quadruped_env.ros.timestamps import NS_PER_SECOND

MAX_AGE: Final = 0.2
"""Maximum lag above the minimum lag, s."""
RELEARN_AFTER: Final = 0.5
"""Time that all states must be late, while the robot is not moved, before their lag becomes the new minimum, s."""
_NEW_CLOCK_STEP: Final = 10.0
"""Change of the lag over a silence above which the clock is a different one, as of a restarted simulator, s."""
_CLOCK_DRIFT: Final = 1e-3
"""Maximum drift between the clocks of robot and controller, s/s."""


class TimestampFilter:
    """Checks the timestamps of one stream.

    The robot's clock may differ from this machine's. A measurement is late if its lag, the time of receipt minus the
    timestamp, exceeds the minimum lag seen so far by more than `MAX_AGE`. While the robot is moved, the minimum can
    only decrease. While it is not moved, the minimum is learned again when it proves wrong: immediately if states
    arrive with less lag; after `RELEARN_AFTER` if all of them are late, as after a step of either clock, or if the time
    of the first one was taken too early. Then `on_lag_changed` is called with the change in s.
    """

    def __init__(self, name: str, on_lag_changed: Callable[[float], None] = lambda change: None) -> None:
        self._name = name
        self._on_lag_changed = on_lag_changed
        self._last: int | None = None
        self._lag = math.inf
        self._seen = 0.0
        self._late_since: float | None = None
        self._late_lag = math.inf
        """Minimum lag since then, s."""

    def refusal(self, stamp: int, now: float, moving: bool = True) -> str:
        """Reason to reject a measurement, while the robot is being moved or not; empty if it is accepted.

        The timestamp in ns is by the robot's clock, the time of receipt in s by this machine's monotonic clock.
        """
        lag = now - stamp / NS_PER_SECOND
        least = self._lag + _CLOCK_DRIFT * (now - self._seen)
        if lag > least + MAX_AGE and self._always_late(lag, now) and not moving:
            self._begin(self._late_lag, now)
            self._on_lag_changed(self._lag - least)
            least = self._lag
        if self._last is None and (lag < least or abs(lag - least) > _NEW_CLOCK_STEP):
            self._accept(stamp, lag, now)
            return ""
        if self._last is not None and stamp <= self._last:
            return f"{self._name}: the timestamp is not later than the one before; such messages are dropped"
        if lag > least + MAX_AGE:
            return f"{self._name}: late by more than {MAX_AGE:g} s; check the network and the clock of the publisher"
        if lag < least - MAX_AGE:
            if not moving:
                self._begin(lag, now)
                self._on_lag_changed(lag - least)
            return (
                f"{self._name}: its clock jumped ahead by more than {MAX_AGE:g} s, or earlier messages were late; "
                f"restarts {'after a silence' if moving else 'with the next message'}"
            )
        self._accept(stamp, min(lag, least), now)
        return ""

    def stamp_at(self, now: float) -> int:
        """Timestamp in ns that a measurement would have that was taken at a time in s, after the first measurement."""
        return round((now - self._lag) * NS_PER_SECOND)

    def reset(self) -> None:
        """Accept another clock from the next measurement on; a measurement that is late for this clock stays late."""
        self._last = None

    def _always_late(self, lag: float, now: float) -> bool:
        """True if all measurements have been late for `RELEARN_AFTER`, this late one included."""
        if self._late_since is None or (now - self._late_since >= RELEARN_AFTER and lag > self._late_lag + MAX_AGE):
            # The first late one, or one that is late even compared with the other late ones.
            self._late_since, self._late_lag = now, lag
            return False
        self._late_lag = min(self._late_lag, lag)
        return now - self._late_since >= RELEARN_AFTER

    def _begin(self, lag: float, now: float) -> None:
        self._last, self._lag, self._seen = None, lag, now
        self._late_since = None

    def _accept(self, stamp: int, lag: float, now: float) -> None:
        self._last, self._lag, self._seen = stamp, lag, now
        self._late_since = None
