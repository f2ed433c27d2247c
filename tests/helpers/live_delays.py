"""Delays between a robot and the live controller, in lock step, without a network or a real clock."""

import contextlib
from collections import deque
from dataclasses import dataclass

from live_loop import EPOCH

from quadruped_env import QuadrupedError

PERIOD = 0.01
"""Period of the states and of the controller's loop, s."""
KEPT = 5
"""Number of states that are kept for a process that does not take them, as with sensor-data quality of service."""
COMMAND_PERIOD = 0.1
"""Period of the messages of /cmd_vel, s."""


@dataclass(frozen=True)
class Disturbance:
    """One disturbance of the link.

    Its kinds: the process is suspended (`pause`); states are lost (`loss`); the network holds states back and then
    delivers all of them (`burst`); every state arrives later from then on (`lag`); the robot's clock is set back or
    ahead (`clock back`, `clock ahead`); the process is suspended between reading its clock and taking a state, or
    between taking a state and reading its clock, and so assigns it a wrong time (`timed early`, `timed late`); the
    robot lies on its side (`fall`).
    """

    kind: str
    start: float
    """s"""
    seconds: float

    @property
    def end(self):
        """Time after which the arrival of states no longer changes, s."""
        return self.start if self.kind.startswith("clock") else self.start + self.seconds

    def holds(self, kind, time):
        return self.kind == kind and self.start <= time < self.start + self.seconds

    def lasts(self, kind, time):
        return self.kind == kind and time >= self.start


SUSPENSIONS = ("pause", "timed early", "timed late")
KINDS = ("pause", "loss", "burst", "lag", "clock back", "clock ahead", "timed early", "timed late")


class Link:
    """Carries a robot's states to a live controller, subject to disturbances.

    Args:
        live_controller: receives the states.
        measure: returns the measurement of a timestamp in ns.
        apply_target: called with the joint target of every answer.
        velocity: velocity command on /cmd_vel, m/s and rad/s.
    """

    def __init__(self, live_controller, measure, apply_target=lambda target: None, velocity=(0.3, 0.0)):
        self.live_controller = live_controller
        self.steps = 0
        self.disturbances = []
        self.limp_times = []
        """Times at which the robot was commanded to go limp, s."""
        self._measure = measure
        self._apply_target = apply_target
        self._velocity = velocity
        self._in_transit = deque()
        self._waiting = deque(maxlen=KEPT)
        self._early = 0.0
        """Time by which the clock was read before the next state is taken, s."""
        self._commanded = -COMMAND_PERIOD

    @property
    def time(self):
        return self.steps * PERIOD

    def step(self):
        """One period: a state is sent, and the controller's loop runs once, unless its process is suspended."""
        self.steps += 1
        now = self.time
        self._send(now)
        burst = any(one.kind == "burst" for one in self.disturbances)
        while self._in_transit and self._in_transit[0][0] <= now + 1e-9:
            self._waiting.append(self._in_transit.popleft()[1])
            if burst and not self._suspended(now):
                # One loop per state, as they arrive one after the other.
                self._loop(now)
        if not self._suspended(now):
            self._loop(now)

    def _suspended(self, now):
        """True if the process is suspended; also prepares the wrong timing that follows from it."""
        holding = [one for one in self.disturbances if one.kind in SUSPENSIONS and one.holds(one.kind, now)]
        for one in holding:
            if one.kind == "timed early":
                self._early = max(self._early, now - one.start)
            elif one.kind == "timed late" and len(self._waiting) > 1:
                # It has taken this state, and reads its clock when it resumes.
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
        if self._in_transit:
            arrival = max(arrival, self._in_transit[-1][0])
        self._in_transit.append((arrival, self._measure(EPOCH + round((now + shift) * 1e9))))

    def _loop(self, now):
        if now - self._commanded >= COMMAND_PERIOD:
            self._commanded = now
            self.live_controller.command(*self._velocity, now)
        answer = None
        if self._waiting:
            newest = max(self._waiting, key=lambda measurement: measurement.stamp)
            self._waiting.clear()
            with contextlib.suppress(QuadrupedError):
                answer = self.live_controller.measured(newest, now - self._early)
            self._early = 0.0
        answer = answer or self.live_controller.silent(now)
        if answer is not None:
            if answer.target is None:
                self.limp_times.append(now)
            self._apply_target(answer.target)
