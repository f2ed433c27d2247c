"""The simulated robot in real time, with the topics of a real robot on ROS 2.

    publishes   /joint_states, /imu/data, /odom, /tf (base_link in odom), /clock      100 Hz
    subscribes  /joint_commands   sensor_msgs/JointState: names with positions in rad; only efforts of 0: go limp
                /reset            std_msgs/Empty: back to the start
                /estop            std_msgs/Bool: limp from true to false
                /push             geometry_msgs/Vector3: velocity in m/s, added to the base's; up to 5 m/s within 1 s

Stands until it is commanded. Without a command for 1 s its motors go limp, like the watchdog of a motor driver. It
accepts commands from one publisher at a time. Timestamps begin at this machine's time. There can be only one robot on a
domain: if another process already publishes /joint_states, it refuses to start.

    ros2 topic pub --once --qos-durability transient_local --keep-alive 5 /push geometry_msgs/msg/Vector3 "{y: 0.5}"
"""

import argparse
import gc
import time
from typing import Any, Final

import numpy as np

from quadruped_env.control.joint_command import LIMP, Target
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.emergency_stop import EmergencyStop
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.joint_messages import JointReader, read_target
from quadruped_env.live.messages.sensor_messages import Sensors
from quadruped_env.live.middleware.node import message_reader
from quadruped_env.live.middleware.topics import JOINT_COMMANDS, PUSH, RESET
from quadruped_env.live.node_options import add_robot_argument, add_terrain_arguments, chosen_terrain, robot_of
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session, add_realtime_argument
from quadruped_env.live.simulated import TIMESTEP, SimulatedRobot
from quadruped_env.live.single_publisher import SinglePublisherGuard
from quadruped_env.live.state_checks import Sources
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.utils.arrays import Floats

STEPS_PER_STATE: Final = 2
_PUSH_LOG_PERIOD: Final = 1.0
"""Minimum time between log lines about pushes, s."""
_SLOWEST, _FASTEST = 0.1, 5.0
"""Range of the real-time factor."""
_REORDERED: Final = 0.5
"""Time after a command within which an older one may overtake it, s."""


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
    SinglePublisherGuard(session)
    sensors = Sensors(session.node, robot.robot, driver)
    commands = Commands(session, robot, driver)
    pushes = session.node.subscribe(PUSH, read=message_reader(PUSH, _push))
    # Exclude the existing objects from garbage collection, to avoid pauses in the real-time loop.
    gc.collect()
    gc.freeze()
    start, pace, push_log = time.time_ns(), Pace(TIMESTEP / factor), Pace(_PUSH_LOG_PERIOD)
    fell, fell_at, lost = False, 0.0, 0
    stop, resets = EmergencyStop(session), session.node.subscribe(RESET)
    for _ in session.turns(lambda: pace.remaining):
        if resets.newest(session.refuse):
            session.say("reset: the robot is back at its start")
            robot.reset()
        commands.take(stop.stopped)
        for _, velocity in pushes.messages(session.refuse):
            _push_robot(session, robot, velocity, push_log)
        while pace.tick():
            if robot.step():
                session.say("limp: no command for 1 s")
            if robot.diverged:
                session.say("the simulation diverged; the robot is back at its start")
                robot.reset()
            if pace.ticks % STEPS_PER_STATE == 0:
                sensors.send(start + (pace.ticks - 1) * round(TIMESTEP * NS_PER_SECOND), robot.state)
        if robot.fallen != fell:
            fell, fell_at = robot.fallen, time.monotonic()
            session.say("fallen" if fell else "on its feet")
        if fell and arguments.pick_up is not None and time.monotonic() - fell_at > arguments.pick_up:
            robot.pick_up()
        if pace.lost != lost:
            lost = pace.lost
            session.say_once("steps are left out, since this machine is too slow for real time; see --realtime")
    return 0


class Commands:
    """Forwards validated commands to the robot, in order and from one publisher at a time."""

    def __init__(self, session: Session, robot: SimulatedRobot, driver: DriverJoints) -> None:
        self._session = session
        self._robot = robot
        joints = JointReader(driver)

        def command(data: bytes) -> tuple[int, Target]:
            state = joints(data)
            return state.stamp, driver.target_to_robot(read_target(state))

        self._subscription = session.node.subscribe(JOINT_COMMANDS, read=command)
        self._sources = Sources(session.node.graph, self._subscription.topic, ["joint targets"])
        self._stamp, self._accepted_at = 0, 0.0

    def take(self, stopped: bool) -> None:
        """Forward the received commands, or while `stopped` by an emergency stop, let the robot go limp."""
        if stopped:
            self._robot.command(LIMP)
        for received, (stamp, target) in self._subscription.messages(self._session.refuse):
            if stopped:
                continue
            if refusal := self._sources.refusal(received, [0]):
                self._session.refuse(refusal)
            # `ros2 topic pub` sends a timestamp of 0.
            elif 0 < stamp < self._stamp and received.taken - self._accepted_at <= _REORDERED:
                self._session.refuse(f"{self._subscription.topic.name}: older than the previous command; ignored")
            else:
                self._stamp, self._accepted_at = stamp, received.taken
                self._robot.command(target)


def _push_robot(session: Session, robot: SimulatedRobot, velocity: Floats, log: Pace) -> None:
    """Push the robot; log a refusal, and a push if the log's pace allows it."""
    try:
        robot.push(velocity)
    except QuadrupedError as error:
        session.refuse(str(error))
    else:
        if log.tick():
            session.say(f"pushed by {velocity.tolist()} m/s")


def _push(vector: Any) -> Floats:
    """Return the velocity (3,) of a `/push` message, m/s."""
    return np.array([vector.x, vector.y, vector.z])
