"""The live controller in lock step, without a network or a real clock: on a bench, with physics, with delays."""

import contextlib
from collections import deque
from dataclasses import dataclass

import numpy as np
from built_in import STANCE

from quadruped_env import QuadrupedError
from quadruped_env.control.live_controller import LiveController, Measurement, Mode, Safety
from quadruped_env.live.simulated import TIMESTEP, SimulatedRobot
from quadruped_env.policies.by_name import find_controller
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import find_terrain

LEVEL = np.array([1.0, 0.0, 0.0, 0.0])
LYING = np.array([0.6, -0.3] * 4)
PERIOD = 0.01
"""Period of states and of the controller's loop, s."""
EPOCH = 1_700_000_000_000_000_000
"""Start of their time, ns."""
KEPT = 5
"""Number of states that are kept for a process that does not take them, as with sensor-data quality of service."""
COMMAND_PERIOD = 0.1
"""Period of the messages of /cmd_vel, s."""


class Recording:
    """A controller that records its velocity commands and returns a constant joint target, by default the stance."""

    action_mode = "position"
    name = "recording"

    def __init__(self, target=STANCE):
        self.target = np.array(target)
        self.commands = []

    def act(self, observation, control):
        self.commands.append(control.command[0].tolist())
        return self.target[None].copy()


class Bench:
    """A live controller, its clock, and a robot that keeps the pose that the test gives it."""

    def __init__(self, controller=None, **safety):
        self.controller = controller or Recording()
        self.said = []
        self.live_controller = LiveController(self.controller, safety=Safety(**safety), say=self.said.append)
        self.now = 50.0
        self.positions = LYING.copy()
        self.orientation = LEVEL
        self.answers = []

    @property
    def mode(self):
        return self.live_controller.mode

    def feed(self, stamp=None, now=None):
        """One measurement, with the current time as its timestamp unless another one is given."""
        stamp = EPOCH + round(self.now * 1e9) if stamp is None else stamp
        measurement = Measurement(stamp, self.positions.copy(), np.zeros(8), self.orientation, np.zeros(3))
        answer = self.live_controller.measured(measurement, self.now)
        if answer is not None:
            self.answers.append(answer)
        return answer

    def pass_time(self, seconds, states=True, command=None):
        """Advance the clock, with or without measurements; returns the answers."""
        before = len(self.answers)
        for _ in range(round(seconds / PERIOD)):
            self.now += PERIOD
            if command is not None:
                self.live_controller.command(command, self.now)
            if states:
                self.feed()
            answer = self.live_controller.silent(self.now)
            if answer is not None:
                self.answers.append(answer)
        return self.answers[before:]

    def walk(self, command=(0.3, 0.1)):
        """Advance until the robot walks."""
        self.pass_time(3.0, command=command)
        assert self.mode is Mode.WALKING
        return self


def measured(robot, stamp):
    """Measurement of a simulated robot."""
    state = robot.state
    return Measurement(
        stamp,
        state.joint_position[0].copy(),
        state.joint_velocity[0].copy(),
        state.orientation[0].copy(),
        state.angular_velocity_b[0].copy(),
    )


class Loop:
    """Robot and live controller in lock step, commands applied from the next physics step on.

    States come at a rate in Hz; the controller's loop runs with each of them, and at least every 10 ms.
    """

    def __init__(self, controller="flat", seed=0, terrain="flat", robot=MINI_QUADRUPED, rate=100.0):
        self.rate = rate
        self.robot = SimulatedRobot(seed, find_terrain(terrain).variant(seed), robot)
        self.steps = 0
        self._make = controller if callable(controller) else find_controller(controller, robot=robot).make
        self.restart_live_controller()

    def restart_live_controller(self):
        """Replace the live controller by a new one, as if its process had been restarted."""
        self.live_controller = LiveController(self._make(), robot=self.robot.robot)

    @property
    def time(self):
        return self.steps * TIMESTEP

    def run(self, seconds, velocity=(0.0, 0.0), states=True, commands=True):
        """Advance the time; returns forward velocities (T,) in m/s and the cosine of the tilt (T,)."""
        speeds, upright = [], []
        for _ in range(round(seconds / TIMESTEP)):
            self.robot.step()
            self.steps += 1
            self.live_controller.command(velocity, self.time)
            due = int(self.time * self.rate + 1e-9) > int((self.time - TIMESTEP) * self.rate + 1e-9)
            answers = [self.live_controller.measured(self.measurement(), self.time)] if due and states else []
            if due or self.steps % 2 == 0:
                answers.append(self.live_controller.silent(self.time))
            for answer in answers:
                if answer is not None and commands:
                    self.robot.command(answer.target)
            speeds.append(self.robot.state.linear_velocity_b[0, 0])
            upright.append(self.robot.state.up_b[0, 2])
        return np.array(speeds), np.array(upright)

    def measurement(self):
        return measured(self.robot, EPOCH + round(self.time * 1e9))


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
            self.live_controller.command(self._velocity, now)
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
