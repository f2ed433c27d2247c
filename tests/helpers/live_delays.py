"""Delays between a robot and the pilot, in lock step, without a network or a clock: what can go wrong on the way."""

import contextlib
from collections import deque
from dataclasses import dataclass

from live_loop import EPOCH

from quadruped_env import QuadrupedError

PERIOD = 0.01
"""s between states, and between turns of the controller's loop"""
KEPT = 5
"""States that wait for a process that does not take them: sensor-data quality"""
COMMAND_PERIOD = 0.1
"""s between messages of /cmd_vel"""


@dataclass(frozen=True)
class Disturbance:
    """One thing that goes wrong.

    Its kinds: the process is held up (`pause`); states are lost (`loss`); the network holds them and then delivers all
    (`burst`); from then on each comes later (`lag`); the robot's clock is set back or ahead (`clock back`,
    `clock ahead`); the process is held up between reading its clock and taking a state, or the other way round, and so
    times it wrong (`timed early`, `timed late`); the robot lies (`fall`).
    """

    kind: str
    start: float
    """s"""
    seconds: float

    @property
    def end(self):
        """When states come as they will from then on, s."""
        return self.start if self.kind.startswith("clock") else self.start + self.seconds

    def holds(self, kind, time):
        return self.kind == kind and self.start <= time < self.start + self.seconds

    def lasts(self, kind, time):
        return self.kind == kind and time >= self.start


HOLD_UP = ("pause", "timed early", "timed late")
KINDS = ("pause", "loss", "burst", "lag", "clock back", "clock ahead", "timed early", "timed late")


class Link:
    """Brings a robot's states to a pilot, as disturbances allow.

    Args:
        pilot: that is driven.
        measure: makes the measurement of a stamp in ns.
        obey: is called with every answer's target.
        velocity: of /cmd_vel.
    """

    def __init__(self, pilot, measure, obey=lambda target: None, velocity=(0.3, 0.0)):
        self.pilot = pilot
        self.turns = 0
        self.disturbances = []
        self.let_go = []
        """Times at which the robot was let go limp"""
        self._measure = measure
        self._obey = obey
        self._velocity = velocity
        self._on_the_way = deque()
        self._waiting = deque(maxlen=KEPT)
        self._early = 0.0
        """s by which the clock was read before the next state is taken"""
        self._commanded = -COMMAND_PERIOD

    @property
    def time(self):
        return self.turns * PERIOD

    def turn(self):
        """One period: a state is sent, and the controller's loop runs once, unless it is held up."""
        self.turns += 1
        now = self.time
        self._send(now)
        burst = any(one.kind == "burst" for one in self.disturbances)
        while self._on_the_way and self._on_the_way[0][0] <= now + 1e-9:
            self._waiting.append(self._on_the_way.popleft()[1])
            if burst and not self._held(now):
                # Each by itself, as they come one after the other.
                self._loop(now)
        if not self._held(now):
            self._loop(now)

    def _held(self, now):
        """Whether the process is held up; what it will do wrong then is prepared."""
        holding = [one for one in self.disturbances if one.kind in HOLD_UP and one.holds(one.kind, now)]
        for one in holding:
            if one.kind == "timed early":
                self._early = max(self._early, now - one.start)
            elif one.kind == "timed late" and len(self._waiting) > 1:
                # It has taken this one, and looks at its clock when it goes on.
                self._waiting = deque([self._waiting[0]], maxlen=KEPT)
        return bool(holding)

    def _send(self, now):
        if any(one.holds("loss", now) for one in self.disturbances):
            return
        shift = sum(one.seconds for one in self.disturbances if one.lasts("clock ahead", now))
        shift -= sum(one.seconds for one in self.disturbances if one.lasts("clock back", now))
        arrival = now + sum(one.seconds for one in self.disturbances if one.lasts("lag", now))
        for one in self.disturbances:
            if one.holds("burst", now):
                arrival = max(arrival, one.end)
        if self._on_the_way:
            arrival = max(arrival, self._on_the_way[-1][0])
        self._on_the_way.append((arrival, self._measure(EPOCH + round((now + shift) * 1e9))))

    def _loop(self, now):
        if now - self._commanded >= COMMAND_PERIOD:
            self._commanded = now
            self.pilot.command(*self._velocity, now)
        answer = None
        if self._waiting:
            newest = max(self._waiting, key=lambda measurement: measurement.stamp)
            self._waiting.clear()
            with contextlib.suppress(QuadrupedError):
                answer = self.pilot.measured(newest, now - self._early)
            self._early = 0.0
        answer = answer or self.pilot.silent(now)
        if answer is not None:
            if answer.target is None:
                self.let_go.append(now)
            self._obey(answer.target)
