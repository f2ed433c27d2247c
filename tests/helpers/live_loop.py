"""The simulated robot and the live controller in lock step, without a network."""

import numpy as np

from quadruped_env.control.live_controller import LiveController, Measurement
from quadruped_env.live.simulated import TIMESTEP, SimulatedRobot
from quadruped_env.policies.by_name import find_controller
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import find_terrain

EPOCH = 10**18
"""Start of their time, ns."""


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
            self.live_controller.command(*velocity, self.time)
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
        state = self.robot.state
        return Measurement(
            EPOCH + round(self.time * 1e9),
            state.joint_position[0].copy(),
            state.joint_velocity[0].copy(),
            state.orientation[0].copy(),
            state.angular_velocity_b[0].copy(),
        )
