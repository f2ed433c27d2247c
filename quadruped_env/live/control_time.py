"""The time that the controller runs on, in s from an arbitrary start, and commands that change it."""

import time
from typing import Any, Final

from quadruped_env.control.timestamp_filter import MAX_AGE
from quadruped_env.live.middleware.node import Node, Refused, Subscription, message_reader
from quadruped_env.live.middleware.topics import CLOCK, PAUSE, RESET, STEP
from quadruped_env.live.session import Session
from quadruped_env.ros import Qos
from quadruped_env.ros.timestamps import NS_PER_SECOND, read_stamp

_QOS: Final = Qos(depth=1, reliable=False)


class SystemTime:
    """`time.monotonic` without the pauses."""

    simulated = False
    """True if it does not run at the speed of the system's time."""

    def __init__(self) -> None:
        self._paused_for = 0.0
        """Total duration of the pauses, s."""
        self._paused_at: float | None = None
        self._stamp = 0

    @property
    def now(self) -> float:
        """The time, s."""
        return time.monotonic() - self._paused_for if self._paused_at is None else self._paused_at

    def of(self, taken: float) -> float:
        """Time at which a message was taken, s, given its `time.monotonic`."""
        return min(taken - self._paused_for, self.now)

    def set_back(self, refused: Refused) -> bool:
        """Take the simulator's messages. Returns True if time was set back."""
        return False

    def state(self, stamp: int, taken: float) -> tuple[float, bool]:
        """Time of receipt of a state with a timestamp in ns, s, and True if time was set back."""
        if self._paused_at is not None and self._stamp:
            self._paused_at += max(0.0, (stamp - self._stamp) / NS_PER_SECOND)
        self._stamp = stamp
        return self.of(taken), False

    def pause(self, paused: bool) -> None:
        """Stop the time, except for states that arrive, or let it run again."""
        if paused and self._paused_at is None:
            self._paused_at = self.now
        elif not paused and self._paused_at is not None:
            self._paused_for, self._paused_at = time.monotonic() - self._paused_at, None


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
        """Present time, for a message that has none."""
        return self.now

    def set_back(self, refused: Refused) -> bool:
        """Take the newest message of `/clock`. Returns True if it is over `MAX_AGE` earlier than the one before."""
        newest = self._clock.newest(refused)
        return newest is not None and self._set(newest[1])

    def state(self, stamp: int, taken: float) -> tuple[float, bool]:
        """Time of a state, which may overtake the message of `/clock`, and True if time was set back."""
        back = not self._clock.writers and self._set(stamp)
        ahead = stamp / NS_PER_SECOND - self.now
        return self.now + (ahead if 0.0 < ahead <= MAX_AGE else 0.0), back

    def pause(self, paused: bool) -> None:
        """Do nothing: the simulator's clock stops."""

    def _set(self, stamp: int) -> bool:
        before, now = self.now, stamp / NS_PER_SECOND
        back = now < before - MAX_AGE
        self.now = now if back else max(before, now)
        return back


ControlTime = SystemTime | SimTime


class SimulatorCommands:
    """`/reset`, `/pause` and `/step`: commands to simulator and controller, taken at every turn of the session's loop.

    Args:
        steps: True for a simulator, which performs single steps.
    """

    def __init__(self, session: Session, steps: bool = False) -> None:
        self._session = session
        topics = (RESET, PAUSE, *[STEP] * steps)
        self._subscriptions: dict[str, Subscription[Any]] = {one.name: session.node.subscribe(one) for one in topics}
        self.paused = False
        self.reset = False
        """True if a reset has come since the last turn."""
        self.steps = 0
        """Number of single steps that have come since the last turn."""
        session.every_turn.append(self._take)

    def _take(self) -> None:
        messages = {
            name: [message for _, message in subscription.messages(self._session.refuse)]
            for name, subscription in self._subscriptions.items()
        }
        self.reset, self.steps = bool(messages[RESET.name]), len(messages.get(STEP.name, ()))
        if self.reset:
            self._session.say(f"{RESET.name}: starts again")
        paused = self.paused
        for message in messages[PAUSE.name]:
            self.paused = message.data
        if self.paused != paused:
            self._session.say("paused" if self.paused else "continues after the pause")
