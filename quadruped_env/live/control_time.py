"""Time that the controller runs on, in s from an arbitrary start."""

import time
from typing import Final

from quadruped_env.control.timestamp_filter import MAX_AGE
from quadruped_env.live.middleware.node import Node, Refused, message_reader
from quadruped_env.live.middleware.topics import CLOCK
from quadruped_env.ros import Qos
from quadruped_env.ros.timestamps import NS_PER_SECOND, read_stamp

_QOS: Final = Qos(depth=1, reliable=False)


class SystemTime:
    """`time.monotonic`."""

    simulated = False
    """True if it does not run at the speed of the system's time."""

    @property
    def now(self) -> float:
        """The time, s."""
        return time.monotonic()

    def of(self, taken: float) -> float:
        """Return the time at which a message was taken, s, given its `time.monotonic`."""
        return taken

    def set_back(self, refused: Refused) -> bool:
        """Take the simulator's messages. Returns True if time was set back."""
        return False

    def state(self, stamp: int, taken: float) -> tuple[float, bool]:
        """Return when a state with a timestamp in ns was received, s, and True if time was set back."""
        return taken, False


class SimTime:
    """The time of `/clock`, or of the states' timestamps where nothing publishes `/clock`; see `SystemTime`.

    Args:
        node: the node that subscribes to `/clock`.
    """

    simulated = True

    def __init__(self, node: Node) -> None:
        self._clock = node.subscribe(CLOCK, _QOS, read=message_reader(CLOCK, lambda message: read_stamp(message.clock)))
        self.now = 0.0
        """Simulated time, s."""

    def of(self, taken: float) -> float:
        """Return the present time, for a message that has none."""
        return self.now

    def set_back(self, refused: Refused) -> bool:
        """Take the newest message of `/clock`. Returns True if it is over `MAX_AGE` earlier than the one before."""
        newest = self._clock.newest(refused)
        return newest is not None and self._set(newest[1])

    def state(self, stamp: int, taken: float) -> tuple[float, bool]:
        """Return the time of a state, which may overtake its `/clock`, s, and True if time was set back."""
        back = not self._clock.writers and self._set(stamp)
        ahead = stamp / NS_PER_SECOND - self.now
        return self.now + (ahead if 0.0 < ahead <= MAX_AGE else 0.0), back

    def _set(self, stamp: int) -> bool:
        before, now = self.now, stamp / NS_PER_SECOND
        back = now < before - MAX_AGE
        self.now = now if back else max(before, now)
        return back


ControlTime = SystemTime | SimTime
