"""The simulated robot in real time, with the topics of a real robot on ROS 2.

    publishes   /joint_states, /imu/data, /odom, /tf (base_link in odom), /clock      100 Hz
    subscribes  /joint_commands   sensor_msgs/JointState: names with positions in rad; only efforts of 0: go limp
                /forward_position_controller/commands   std_msgs/Float64MultiArray: a position per joint in rad
                /reset, /step     std_msgs/Empty: back to the start; one control step while paused
                /pause, /estop    std_msgs/Bool: stop the time; limp from true to false
                /push             geometry_msgs/Vector3: velocity in m/s, added to the base's; up to 5 m/s within 1 s

Stands until it is commanded. Without a command for 1 s its motors go limp, like the watchdog of a motor driver. It
accepts commands from one publisher at a time. Timestamps begin at this machine's time. There can be only one robot on a
domain: if another process already publishes /joint_states, it refuses to start.

    ros2 topic pub --once --qos-durability transient_local --keep-alive 5 /push geometry_msgs/msg/Vector3 "{y: 0.5}"
"""

import argparse
import gc
import time
from collections.abc import Iterator
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.joint_command import LIMP, Target
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.control_time import SimulatorCommands
from quadruped_env.live.emergency_stop import EmergencyStop
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.joint_messages import JointReader, read_positions, read_target
from quadruped_env.live.messages.sensor_messages import Sensors
from quadruped_env.live.middleware.node import Received, message_reader
from quadruped_env.live.middleware.topics import JOINT_COMMANDS, JOINT_POSITIONS, PUSH
from quadruped_env.live.node_options import add_robot_argument, add_terrain_arguments, chosen_terrain, robot_of
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import POLL_PERIOD, Session, add_realtime_argument
from quadruped_env.live.simulated import TIMESTEP, SimulatedRobot
from quadruped_env.live.single_publisher import SinglePublisherGuard
from quadruped_env.ros.timestamps import NS_PER_SECOND

STEPS_PER_STATE: Final = 2
STEPS_PER_CONTROL: Final = 4
"""Physics steps of a control step of 20 ms, which `/step` performs."""
_PUSH_LOG_PERIOD: Final = 1.0
"""Minimum time between log lines about pushes, s."""
_SLOWEST, _FASTEST = 0.1, 5.0
"""Range of the real-time factor."""
_SENDER_TIMEOUT: Final = 0.5
"""Time after its last command for which a publisher keeps control, s."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the simulation."""
    parser.add_argument(
        "--pick-up",
        type=float,
        metavar="S",
        help="put the robot back on its feet S seconds after a fall (default: it stays where it fell)",
    )
    parser.add_argument(
        "--real-time-factor",
        type=float,
        default=1.0,
        metavar="F",
        help="speed of simulated time, 0.1 to 5, by /clock and all timestamps; for 'controller --sim-time' "
        "(default: %(default)s)",
    )
    add_terrain_arguments(parser, "seed of the initial heading and of the terrain")
    add_robot_argument(parser)
    add_realtime_argument(parser)


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Simulate until the session ends."""
    robot = SimulatedRobot(arguments.seed, chosen_terrain(arguments), robot_of(arguments))
    driver = DriverJoints.load(arguments.map, robot.robot)
    factor = arguments.real_time_factor
    if not _SLOWEST <= factor <= _FASTEST:
        raise QuadrupedError(f"--real-time-factor: expected {_SLOWEST:g} to {_FASTEST:g}; found {factor:g}")
    SinglePublisherGuard(session).check()
    sensors = Sensors(session.node, robot.robot, driver)
    commands = _Commands(session, robot, driver)
    pushes = session.node.subscribe(PUSH, read=message_reader(PUSH, _push))
    # Exclude the existing objects from garbage collection, to avoid pauses in the real-time loop.
    gc.collect()
    gc.freeze()
    steps, push_log = _Steps(TIMESTEP / factor), Pace(_PUSH_LOG_PERIOD)
    fell, fell_at = False, 0.0
    simulator, stop = SimulatorCommands(session, steps=True), EmergencyStop(session)
    for _ in session.turns(lambda: POLL_PERIOD if simulator.paused else steps.pace.remaining):
        if simulator.reset:
            robot.reset()
        commands.take(stop.stopped)
        for _, velocity in pushes.messages(session.refuse):
            _push_robot(session, robot, velocity, push_log)
        for number in steps.due(simulator):
            if robot.step():
                session.say("limp: no command for 1 s")
            if robot.diverged:
                session.say("the simulation diverged; the robot is back at its start")
                robot.reset()
            if number % STEPS_PER_STATE == 0:
                sensors.send(steps.stamp(number), robot.state)
        if robot.fallen != fell:
            fell, fell_at = robot.fallen, time.monotonic()
            session.say("fallen" if fell else "on its feet")
        if fell and arguments.pick_up is not None and time.monotonic() - fell_at > arguments.pick_up:
            robot.pick_up()
        session.details = (
            "limp" * robot.limp,
            "paused" * simulator.paused,
            f"{1e3 * steps.pace.latest:.1f} ms late at most",
            f"{steps.pace.lost} steps lost" * bool(steps.pace.lost),
        )
    return 0


class _Steps:
    """Physics steps in real time, with pauses that are not caught up and with single steps.

    Args:
        period: time between steps, s.
    """

    def __init__(self, period: float) -> None:
        self.pace = Pace(period)
        """Pace since the start or the last pause."""
        self._period = period
        self._start = time.time_ns()
        self._before = 0
        """Number of steps before this pace, and of single steps."""
        self._paused = False

    def due(self, simulator: SimulatorCommands) -> Iterator[int]:
        """Numbers of the steps that are due, from 1; those of lost steps are left out."""
        if simulator.paused:
            self._paused = True
            for _ in range(simulator.steps * STEPS_PER_CONTROL):
                self._before += 1
                yield self._before + self.pace.ticks
            return
        if self._paused:
            self._paused, self._before, self.pace = False, self._before + self.pace.ticks, Pace(self._period)
        while self.pace.tick():
            yield self._before + self.pace.ticks

    def stamp(self, number: int) -> int:
        """Timestamp of a step, ns."""
        return self._start + (number - 1) * round(TIMESTEP * NS_PER_SECOND)


class _Commands:
    """Forwards validated commands to the robot, in order and from one publisher at a time."""

    def __init__(self, session: Session, robot: SimulatedRobot, driver: DriverJoints) -> None:
        self._session = session
        self._robot = robot
        node, joints = session.node, JointReader(driver)

        def command(data: bytes) -> tuple[int, Target]:
            state = joints(data)
            return state.stamp, driver.target_to_robot(read_target(state))

        def array(message: Any) -> tuple[int, Target]:
            return 0, driver.target_to_robot(read_positions(message, driver))

        self._subscriptions = (
            node.subscribe(JOINT_COMMANDS, read=command),
            node.subscribe(JOINT_POSITIONS, read=message_reader(JOINT_POSITIONS, array)),
        )
        self._writer = 0
        self._stamp = 0
        self._accepted_at = -_SENDER_TIMEOUT

    def take(self, stopped: bool) -> None:
        """Forward the received commands, or while `stopped` by an emergency stop, let the robot go limp."""
        if stopped:
            self._robot.command(LIMP)
        for subscription in self._subscriptions:
            for received, (stamp, target) in subscription.messages(self._session.refuse):
                if stopped:
                    continue
                refusal = self._refusal(received, stamp)
                if refusal:
                    self._session.refuse(f"{subscription.topic.name}: {refusal}")
                    continue
                self._writer, self._stamp, self._accepted_at = received.writer, stamp, received.taken
                self._robot.command(target)

    def _refusal(self, received: Received, stamp: int) -> str:
        """The reason to refuse a command; empty if it is accepted."""
        if received.taken - self._accepted_at <= _SENDER_TIMEOUT:
            if received.writer != self._writer:
                return "from a second publisher; end one of the two"
            # `ros2 topic pub` sends a timestamp of 0.
            if 0 < stamp < self._stamp:
                return "older than the previous command; ignored"
        return ""


def _push_robot(session: Session, robot: SimulatedRobot, velocity: NDArray[np.float64], log: Pace) -> None:
    """Push the robot; log a refusal, and a push if the log's pace allows it."""
    try:
        robot.push(velocity)
    except QuadrupedError as error:
        session.refuse(str(error))
    else:
        if log.tick():
            session.say(f"pushed by {velocity.tolist()} m/s")


def _push(vector: Any) -> NDArray[np.float64]:
    """The velocity (3,) of a `/push` message, m/s."""
    return np.array([vector.x, vector.y, vector.z])
