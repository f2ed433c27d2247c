"""Drive the robot with a policy, 50 times a second: from /joint_states, /imu/data and /cmd_vel to /joint_commands.

    mini-quadruped live controller              the shipped policy
    mini-quadruped live controller runs/latest  a run's
    mini-quadruped live controller tuned        the scripted gait that follows /cmd_vel
    mini-quadruped live controller --arrays     to a robot with ros2_control

Waits for fresh states, goes slowly from where the joints are to the stance, and then follows /cmd_vel; without one
newer than 0.5 s it stands. Holds when no state comes for 0.2 s, and lets the robot go limp after 1 s, or when it has
fallen; afterwards it waits for fresh states again. Never asks for more than the joints' range and 5 rad/s. States with
NaN, other names or counts, or stamps that are old or repeated are refused, and said; while the robot is limp, states
that are all late are taken as they come after 0.5 s. Each command bears the stamp of the state that it answers.
"""

import argparse
import functools
import time
from typing import Any, Final

from quadruped_env.control.by_name import find_controller
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.live_controller import Answer, LiveController, Measurement, Mode
from quadruped_env.control.policy import load_policy, load_terms
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.commands import CommandWriter, positions_message
from quadruped_env.live.imu import Imu, read_imu
from quadruped_env.live.joints import JointReader, Joints
from quadruped_env.live.node import Subscription, message_reader
from quadruped_env.live.session import Session, add_realtime_argument
from quadruped_env.live.topics import CMD_VEL, IMU, JOINT_COMMANDS, JOINT_POSITIONS, JOINT_STATES
from quadruped_env.robot import JOINT_NAMES
from quadruped_env.ros import SENSOR_DATA_QOS
from quadruped_env.timestamps import NS_PER_SECOND

_NEEDED: Final = ("positions", "velocities")
_POLL_PERIOD: Final = 0.01
"""s; how often silence is looked for"""
_IMU_AGE: Final = 0.02
"""s by which attitude and joints may be apart"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What decides."""
    parser.add_argument(
        "policy",
        nargs="?",
        default="flat",
        metavar="POLICY",
        help="'flat', a run's directory, or a gait: 'tuned', 'trot', 'walk', 'bound', 'pace' (%(default)s)",
    )
    parser.add_argument(
        "--arrays",
        action="store_true",
        help=f"send the targets as ros2_control takes them, on {JOINT_POSITIONS.name}: eight numbers in the order "
        f"{', '.join(JOINT_NAMES)}. There is none that says limp: it falls silent, and the driver has to let go",
    )
    parser.add_argument(
        "--task",
        metavar="FILE",
        help="the Python file of terms that the policy was trained with, if it was; it is executed",
    )
    add_realtime_argument(parser)


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Drive the robot until the session ends, then let it go limp."""
    terms = None if arguments.task is None else load_terms(arguments.task)
    load = functools.partial(load_policy, terms=terms)
    pilot = LiveController(find_controller(arguments.policy, load).make(), say=session.say)
    node = session.node
    outbox = _Outbox(session, arguments.arrays)
    # Drivers of real robots may offer best effort only.
    states = node.subscribe(JOINT_STATES, SENSOR_DATA_QOS, read=JointReader(JOINT_STATES.name, _NEEDED))
    attitudes = node.subscribe(IMU, SENSOR_DATA_QOS, read=message_reader(IMU, read_imu))
    velocities = node.subscribe(CMD_VEL)
    inbox = _Inbox(session, states, attitudes)
    while session.running:
        session.wait(_POLL_PERIOD)
        _take_command(session, pilot, velocities)
        received = inbox.measurement()
        answer = None
        if received is not None:
            try:
                answer = pilot.measured(*received)
            except QuadrupedError as error:
                session.refuse(str(error))
        now = time.monotonic()
        outbox.send(answer or pilot.silent(now))
        session.wait_for(_missing(pilot, states, attitudes))
        session.report("" if pilot.mode is not Mode.WALKING or pilot.moving(now) else "standing: no /cmd_vel")
    outbox.let_go()
    return 0


class _Inbox:
    """Makes measurements of joint states and attitudes."""

    def __init__(self, session: Session, states: Subscription[Joints], attitudes: Subscription[Imu]) -> None:
        self._session = session
        self._states = states
        self._attitudes = attitudes
        self._imu: Imu | None = None

    def measurement(self) -> tuple[Measurement, float] | None:
        """The newest one, and when it was taken (s of `time.monotonic`), if there is a new one that can be used."""
        # States first: an attitude that was sent before a state is there by then.
        states = list(self._states.messages(self._session.refuse))
        attitude = self._attitudes.newest(self._session.refuse)
        if attitude is not None:
            self._imu = attitude[1]
        if not states or self._imu is None:
            return None
        received, newest = max(states, key=lambda state: state[1].stamp)
        if abs(newest.stamp - self._imu.stamp) > _IMU_AGE * NS_PER_SECOND:
            self._session.refuse(f"{IMU.name} and {JOINT_STATES.name} are over {_IMU_AGE:g} s apart")
            return None
        assert newest.positions is not None
        assert newest.velocities is not None
        measurement = Measurement(
            newest.stamp, newest.positions, newest.velocities, self._imu.orientation, self._imu.angular_velocity
        )
        return measurement, received.taken


def _take_command(session: Session, pilot: LiveController, velocities: Subscription[Any]) -> None:
    newest = velocities.newest(session.refuse)
    if newest is None:
        return
    received, twist = newest
    try:
        pilot.command(twist.linear.x, twist.angular.z, received.taken)
    except QuadrupedError as error:
        session.refuse(str(error))


class _Outbox:
    """Sends what the pilot answers.

    Args:
        session: of the process.
        arrays: whether to send for ros2_control.
    """

    def __init__(self, session: Session, arrays: bool) -> None:
        self._arrays = arrays
        self._commands = session.node.publish(JOINT_POSITIONS if arrays else JOINT_COMMANDS)
        self._write = CommandWriter()
        self._stamp = 0

    def send(self, answer: Answer | None) -> None:
        """Send an answer, if there is one."""
        if answer is None:
            return
        self._stamp = answer.stamp
        if not self._arrays:
            self._commands.send_bytes(self._write(answer.stamp, answer.target))
        elif answer.target is not LIMP:
            self._commands.send(positions_message(answer.target))

    def let_go(self) -> None:
        """Let the robot go limp, if it was ever commanded, and see that it hears of it."""
        if self._stamp:
            self.send(Answer(self._stamp, LIMP))
            self._commands.wait_until_read(0.5)


def _missing(pilot: LiveController, states: Subscription[Joints], attitudes: Subscription[Imu]) -> str:
    if pilot.mode is not Mode.WAITING:
        return ""
    silent = [one.topic.name for one in (states, attitudes) if not one.writers]
    return f"{' and '.join(silent)}: nobody publishes" if silent else "fresh states"
