"""The tutorial's publisher: a scripted gait on /joint_states at 20 Hz, or as commands to `sim`.

    mini-quadruped live gait                    the tutorial's gait
    mini-quadruped live gait --preset trot --commands      trot, together with `sim`

Amplitude, frequency and phases can be changed at run time, with the sliders of `view` or with a message: amplitude as a
multiple of the preset's, frequency in Hz, and the phase of each leg in cycles (LF, RF, LH, RH):

    ros2 topic pub -t 20 -r 10 /gait std_msgs/msg/Float64MultiArray "{data: [1.5, 0.5, 0, 0.5, 0.5, 0]}"

Positions and velocities follow from the gait's formula at the time since the start, which the timestamps represent. As
commands, the gait is faded in over 2 s from the measured joint positions, without any supervision of the robot;
`controller trot` adds it. /estop ends it, and the robot goes limp.
"""

import argparse
import functools
import time
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.joint_command import TargetGate, limited
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import PRESETS, SinusoidalGait
from quadruped_env.gait.gait_settings import GaitSettings, edited
from quadruped_env.live.command_publisher import CommandPublisher
from quadruped_env.live.emergency_stop import EmergencyStop
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.gait_messages import read_settings, settings_message
from quadruped_env.live.messages.joint_messages import JointMerger, JointReader
from quadruped_env.live.middleware.node import message_reader
from quadruped_env.live.middleware.topics import GAIT, GAIT_SETTINGS, JOINT_COMMANDS, JOINT_STATES
from quadruped_env.live.node_options import add_robot_argument, robot_of
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session
from quadruped_env.live.single_publisher import SinglePublisherGuard
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import SENSOR_DATA_QOS
from quadruped_env.ros.robot_messages import joint_state
from quadruped_env.ros.timestamps import NS_PER_SECOND

RATE: Final = 20.0
"""Publishing rate of joint states, as in the tutorial, Hz."""
COMMAND_RATE: Final = 50.0
"""Publishing rate of commands, Hz."""
FADE: Final = 2.0
"""Fade-in time of commands, s."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the gait preset, the rate, and the output topic."""
    parser.add_argument("--preset", choices=PRESETS, default="article", help="gait preset (default: %(default)s)")
    parser.add_argument(
        "--rate", type=float, metavar="HZ", help=f"publishing rate ({RATE:g}; with --commands {COMMAND_RATE:g})"
    )
    parser.add_argument(
        "--commands", action="store_true", help=f"send to {JOINT_COMMANDS.name} instead of {JOINT_STATES.name}"
    )
    add_robot_argument(parser)


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Publish until the session ends."""
    robot = robot_of(arguments)
    driver = DriverJoints.load(arguments.map, robot)
    gait = _RemoteGait(session, arguments.preset, robot)
    rate = arguments.rate or (COMMAND_RATE if arguments.commands else RATE)
    if not 0.1 <= rate <= 1000.0:
        raise QuadrupedError(f"--rate: expected 0.1 to 1000 Hz; found {rate:g}")
    for complaint in gait.violations():
        session.say(f"beyond the robot's limits: {complaint}")
    if arguments.commands:
        _send_commands(session, gait, driver, 1.0 / rate)
    else:
        _send_states(session, gait, driver, 1.0 / rate)
    return 0


class AdjustableGait:
    """A gait preset with settings that may change at any time; the phase stays continuous when the frequency changes.

    Args:
        preset: name of the preset.
        robot: robot that walks.
    """

    def __init__(self, preset: str, robot: Robot) -> None:
        self._preset = self._gait = SinusoidalGait.preset(preset, robot)
        self.settings = GaitSettings.of(self._preset)
        """The current settings."""
        self._time_offset = 0.0
        """Time offset that keeps the phase continuous over frequency changes, s."""

    def change(self, settings: GaitSettings, t: float) -> None:
        """Apply new settings from time `t` (s) on."""
        self._time_offset = (t + self._time_offset) * self.settings.frequency / settings.frequency - t
        self.settings = settings
        self._gait = edited(self._preset, settings)

    def positions(self, t: float) -> NDArray[np.float64]:
        """Joint positions at time `t` (s), rad (J,)."""
        return self._gait.positions(t + self._time_offset)

    def velocities(self, t: float) -> NDArray[np.float64]:
        """Joint velocities at time `t` (s), rad/s (J,)."""
        return self._gait.velocities(t + self._time_offset)

    def violations(self) -> list[str]:
        """Descriptions of the joint limits that the gait exceeds."""
        return self._gait.violations()


class _RemoteGait(AdjustableGait):
    """A gait that takes settings from /gait and publishes the current ones on /gait/settings."""

    def __init__(self, session: Session, preset: str, robot: Robot) -> None:
        super().__init__(preset, robot)
        self.robot = robot
        self._session = session
        read = functools.partial(read_settings, robot=robot)
        self._wanted = session.node.subscribe(GAIT, read=message_reader(GAIT, read))
        self._actual = session.node.publish(GAIT_SETTINGS)
        self._actual.send(settings_message(self.settings))

    def take(self, t: float) -> None:
        """Apply received settings from time `t` (s) on."""
        newest = self._wanted.newest(self._session.refuse)
        if newest is not None:
            self.change(newest[1], t)
            self._actual.send(settings_message(self.settings))

    def report(self) -> None:
        """Update the session's status line."""
        complaints = self.violations()
        self._session.report(f"beyond the robot's limits: {complaints[0]}" if complaints else "")


def _send_states(session: Session, gait: _RemoteGait, driver: DriverJoints, period: float) -> None:
    guard = SinglePublisherGuard(session)
    guard.check()
    states = session.node.publish(JOINT_STATES)
    efforts = np.zeros(gait.robot.num_joints)
    start, pace = time.time_ns(), Pace(period)
    while session.running:
        session.wait(pace.remaining)
        guard.watch()
        t = pace.ticks * period
        gait.take(t)
        if pace.tick():
            stamp = start + round(t * NS_PER_SECOND)
            values = driver.to_driver(gait.positions(t), gait.velocities(t), efforts)
            states.send_bytes(joint_state(stamp, driver.joint_names, *values))
        gait.report()


def _send_commands(session: Session, gait: _RemoteGait, driver: DriverJoints, period: float) -> None:
    guard, stop = SinglePublisherGuard(session, JOINT_COMMANDS), EmergencyStop(session)
    guard.check()
    publisher = CommandPublisher(session.node, driver, False, session.say)
    gate = TargetGate(gait.robot.joint_names, session.say)
    reader, merger = JointReader(JOINT_STATES.name, driver, states=True), JointMerger(driver, velocities=False)
    states = session.node.subscribe(JOINT_STATES, SENSOR_DATA_QOS, read=reader)
    first: NDArray[np.float64] | None = None
    while session.running and (first is None or stop.stopped):
        missing = merger.missing if states.count else JOINT_STATES.name
        session.wait_for(stop.awaited if stop.stopped else missing)
        session.wait()
        stop.take()
        for _, joints in states.messages(session.refuse):
            if whole := merger.add(joints):
                first = driver.to_robot(whole).positions
        gait.take(0.0)
        session.report()
    if first is None:
        return
    session.wait_for("")
    last, start, pace = first, time.time_ns(), Pace(period)
    try:
        while session.running:
            session.wait(pace.remaining)
            states.take()
            guard.watch()
            stop.take()
            if stop.stopped:
                break
            t = pace.ticks * period
            gait.take(t)
            if pace.tick():
                share = min(t / FADE, 1.0)
                target = first + share * (gait.positions(t) - first)
                if gate.passes(target, time.monotonic()):
                    last = limited(gait.robot, target, last, period)
                publisher.send(start + round(t * NS_PER_SECOND), driver.target_to_driver(last))
            gait.report()
    finally:
        publisher.let_go()
