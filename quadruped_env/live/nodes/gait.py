"""The tutorial's publisher: a scripted gait on /joint_states at 20 Hz. `controller trot` makes a robot walk with one.

    mini-quadruped live gait                    the tutorial's gait
    mini-quadruped live gait --preset trot

Amplitude, frequency and phases can be changed at run time, with the sliders of `view` or with a message: amplitude as a
multiple of the preset's, frequency in Hz, and the phase of each leg in cycles (LF, RF, LH, RH):

    ros2 topic pub -t 20 -r 10 /gait std_msgs/msg/Float64MultiArray "{data: [1.5, 0.5, 0, 0.5, 0.5, 0]}"

Positions and velocities follow from the gait's formula at the time since the start, which the timestamps represent.
"""

import argparse
import functools
import time
from typing import Final

import numpy as np

from quadruped_env.gait import PRESETS, SinusoidalGait
from quadruped_env.gait.gait_settings import GaitSettings, edited
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.steering_messages import read_settings, settings_message
from quadruped_env.live.middleware.node import message_reader
from quadruped_env.live.middleware.topics import GAIT, GAIT_SETTINGS, JOINT_STATES
from quadruped_env.live.node_options import add_robot_argument, robot_of
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session
from quadruped_env.live.single_publisher import SinglePublisherGuard
from quadruped_env.robot.robot import Robot
from quadruped_env.ros.robot_messages import joint_state
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.utils.arrays import Floats

PERIOD: Final = 0.05
"""Time between joint states, as in the tutorial, s."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the gait preset and the robot."""
    parser.add_argument("--preset", choices=PRESETS, default="article", help="gait preset (default: %(default)s)")
    add_robot_argument(parser)


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Publish until the session ends."""
    robot, node = robot_of(arguments), session.node
    driver = DriverJoints.load(arguments.map, robot, commands=False)
    gait = AdjustableGait(arguments.preset, robot)
    read = message_reader(GAIT, functools.partial(read_settings, robot=robot))
    wanted, settings = node.subscribe(GAIT, read=read), node.publish(GAIT_SETTINGS)
    settings.send(settings_message(gait.settings))
    for complaint in gait.current.violations():
        session.say(f"beyond the robot's limits: {complaint}")
    SinglePublisherGuard(session)
    states, efforts = node.publish(JOINT_STATES), np.zeros(robot.num_joints)
    start, pace = time.time_ns(), Pace(PERIOD)
    for _ in session.turns(lambda: pace.remaining):
        t = pace.ticks * PERIOD
        if newest := wanted.newest(session.refuse):
            gait.change(newest[1], t)
            settings.send(settings_message(gait.settings))
        if pace.tick():
            stamp = start + round(t * NS_PER_SECOND)
            values = driver.to_driver(gait.positions(t), gait.velocities(t), efforts)
            states.send_bytes(joint_state(stamp, driver.joint_names, *values))
    return 0


class AdjustableGait:
    """A gait preset with settings that may change at any time; the phase stays continuous when the frequency changes.

    Args:
        preset: name of the preset.
        robot: robot that walks.
    """

    def __init__(self, preset: str, robot: Robot) -> None:
        self._preset = self.current = SinusoidalGait.preset(preset, robot)
        """The gait with its settings, without the time offset."""
        self.settings = GaitSettings.of(self._preset)
        """The current settings."""
        self._time_offset = 0.0
        """Time offset that keeps the phase continuous over frequency changes, s."""

    def change(self, settings: GaitSettings, t: float) -> None:
        """Apply new settings from time `t` (s) on."""
        self._time_offset = (t + self._time_offset) * self.settings.frequency / settings.frequency - t
        self.settings = settings
        self.current = edited(self._preset, settings)

    def positions(self, t: float) -> Floats:
        """Joint positions at time `t` (s), rad (J,)."""
        return self.current.positions(t + self._time_offset)

    def velocities(self, t: float) -> Floats:
        """Joint velocities at time `t` (s), rad/s (J,)."""
        return self.current.velocities(t + self._time_offset)
