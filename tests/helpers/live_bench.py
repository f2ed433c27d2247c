"""Test bench for the live controller: a manual clock, and measurements that the test sets."""

import numpy as np
from built_in import STANCE

from quadruped_env.control.live_controller import LiveController, Measurement, Mode, Safety

LEVEL = np.array([1.0, 0.0, 0.0, 0.0])
LYING = np.array([0.6, -0.3] * 4)
PERIOD = 0.01
EPOCH = 1_700_000_000_000_000_000


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
                self.live_controller.command(*command, self.now)
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
