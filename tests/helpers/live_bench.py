"""What tests of the pilot share: a pilot that is told the time and what the robot measures by hand."""

import numpy as np

from quadruped_env.control.live_controller import LiveController, Measurement, Mode, Safety
from quadruped_env.robot import STANCE

LEVEL = np.array([1.0, 0.0, 0.0, 0.0])
LYING = np.array([0.6, -0.3] * 4)
PERIOD = 0.01
EPOCH = 1_700_000_000_000_000_000


class Recording:
    """A controller that keeps the commands of its task, and asks for the stance, or for what a test says."""

    action_mode = "position"
    name = "recording"

    def __init__(self, target=STANCE):
        self.target = np.array(target)
        self.commands = []

    def act(self, observation, control):
        self.commands.append(control.command[0].tolist())
        return self.target[None].copy()


class Bench:
    """A pilot, its clock, and a robot that stays where it is put."""

    def __init__(self, controller=None, **safety):
        self.controller = controller or Recording()
        self.said = []
        self.pilot = LiveController(self.controller, safety=Safety(**safety), say=self.said.append)
        self.now = 50.0
        self.positions = LYING.copy()
        self.orientation = LEVEL
        self.answers = []

    @property
    def mode(self):
        return self.pilot.mode

    def feed(self, stamp=None, now=None):
        """One measurement, of this time unless another one is said."""
        stamp = EPOCH + round(self.now * 1e9) if stamp is None else stamp
        measurement = Measurement(stamp, self.positions.copy(), np.zeros(8), self.orientation, np.zeros(3))
        answer = self.pilot.measured(measurement, self.now)
        if answer is not None:
            self.answers.append(answer)
        return answer

    def pass_time(self, seconds, states=True, command=None):
        """Time goes by, with or without measurements; returns what was answered."""
        before = len(self.answers)
        for _ in range(round(seconds / PERIOD)):
            self.now += PERIOD
            if command is not None:
                self.pilot.command(*command, self.now)
            if states:
                self.feed()
            answer = self.pilot.silent(self.now)
            if answer is not None:
                self.answers.append(answer)
        return self.answers[before:]

    def walk(self, command=(0.3, 0.1)):
        """On to walking."""
        self.pass_time(3.0, command=command)
        assert self.mode is Mode.WALKING
        return self
