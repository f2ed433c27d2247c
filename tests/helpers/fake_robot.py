"""A robot whose joints follow their targets at once, as the driver of a live controller."""

import threading
import time

import numpy as np
import pytest
from built_in import STANCE
from live_nodes import joint_state

from quadruped_env import JOINT_NAMES
from quadruped_env.control.joint_command import LIMP
from quadruped_env.live import Node
from quadruped_env.live.messages.joint_messages import JointReader, read_target
from quadruped_env.live.middleware.topics import CMD_VEL, DIAGNOSTICS, IMU, JOINT_COMMANDS, JOINT_STATES
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import cdr


class FakeRobot:
    """A robot whose joints follow their targets at once, at 100 Hz, with noise; faults are switched on by name."""

    def __init__(self):
        self.node = Node("driver")
        self.states, self.attitudes = self.node.publish(JOINT_STATES), self.node.publish(IMU)
        self.velocities = self.node.publish(CMD_VEL)
        self.commands = self.node.subscribe(JOINT_COMMANDS, read=JointReader(MINI_QUADRUPED))
        self.diagnostics = self.node.subscribe(DIAGNOSTICS)
        self.positions, self.limp, self.targets, self.fault = STANCE.copy(), False, 0, ""
        self.problems = ""
        self.running, self.thread = True, threading.Thread(target=self.run)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.running = False
        self.thread.join()
        self.node.close()

    def run(self):
        rng = np.random.default_rng(0)
        while self.running:
            for _, joints in self.commands.messages(pytest.fail):
                target = read_target(joints)
                self.limp = target is LIMP
                if not self.limp:
                    self.targets += 1
                    self.positions = np.asarray(target)
            for _, message in self.diagnostics.messages(pytest.fail):
                self.problems = {one.key: one.value for one in message.status[0].values}["problems"]
            now = time.time_ns()
            turn = dict(zip("xyz", np.zeros(3) if self.fault == "imu" else rng.normal(0.0, 0.01, 3), strict=True))
            header = cdr.header(now)
            imu = cdr.message(IMU.type_name, header=header, orientation={"w": 1.0}, angular_velocity=turn)
            self.attitudes.send(imu)
            measured = self.positions + rng.normal(0.0, 1e-4, 8)
            if self.fault == "zero":
                measured[4] = 0.0
            self.states.send(joint_state(now, JOINT_NAMES, measured))
            self.velocities.send(cdr.message(CMD_VEL.type_name, linear={"x": 0.3}))
            time.sleep(0.01)
