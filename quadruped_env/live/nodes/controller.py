"""Control the robot with a policy at 50 Hz: /joint_states, /imu/data and /cmd_vel in, /joint_commands out.

    mini-quadruped live controller              the shipped policy flat
    mini-quadruped live controller runs/latest  the policy of a training run
    mini-quadruped live controller tuned        the scripted gait that follows /cmd_vel
    mini-quadruped live controller --arrays     for a robot with ros2_control

Waits for fresh states, moves slowly from the measured joint positions to the stance, then follows /cmd_vel; without
a command newer than 0.5 s it stands. Holds its position when no state arrives for 0.2 s, and lets the robot go limp
after 1 s or after a fall; then it waits for fresh states again. Joint targets keep to the joints' range and speed.
States with NaN, wrong names or counts, or old or repeated timestamps are refused and logged; while the robot is limp,
states that are all late are accepted after 0.5 s. Each command has the timestamp of the state it answers.
"""

import argparse
import functools
import time
from typing import Any, Final

from quadruped_env.control.by_name import find_controller
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.kept_task_file import kept_file
from quadruped_env.control.live_controller import JointCommand, LiveController, Measurement, Mode
from quadruped_env.control.policy_files import DEFAULT, SHIPPED, Terms, load_terms, policy_directory, read_policy
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import PRESETS
from quadruped_env.live.messages.imu_messages import Imu, read_imu
from quadruped_env.live.messages.joint_messages import JointReader, Joints, command_message, positions_message
from quadruped_env.live.middleware.node import Subscription, message_reader
from quadruped_env.live.middleware.topics import CMD_VEL, IMU, JOINT_COMMANDS, JOINT_POSITIONS, JOINT_STATES
from quadruped_env.live.session import Session, add_realtime_argument
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import SENSOR_DATA_QOS
from quadruped_env.ros.timestamps import NS_PER_SECOND

_NEEDED: Final = ("positions", "velocities")
_POLL_PERIOD: Final = 0.01
"""Time between checks for missing states, s."""
_IMU_AGE: Final = 0.02
"""Maximum difference between the timestamps of orientation and joint states, s."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the policy, its task file, and the command format."""
    parser.add_argument(
        "policy",
        nargs="?",
        default=DEFAULT,
        metavar="POLICY",
        help=f"{', '.join(SHIPPED)}, a run directory, or a scripted gait: {', '.join(PRESETS)} (default: %(default)s)",
    )
    parser.add_argument(
        "--arrays",
        action="store_true",
        help=f"send the targets in the format of ros2_control on {JOINT_POSITIONS.name}: one number per joint, in the "
        f"order {', '.join(MINI_QUADRUPED.joint_names)}, or in that of the robot of --task. This format has no limp "
        "command: "
        "the node stops sending, and the driver has to disable the motors",
    )
    parser.add_argument(
        "--task",
        metavar="FILE",
        help="Python file of your robot, or of the custom terms that the policy was trained with; it is executed. A "
        "policy needs it if it defines its robot or observations",
    )
    parser.add_argument(
        "--trust-task", action="store_true", help="execute the copy of that file that the run keeps, in place of --task"
    )
    add_realtime_argument(parser)


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Control the robot until the session ends, then let it go limp."""
    terms = _terms(arguments)
    load = functools.partial(read_policy, terms=terms)
    robot = terms.robot
    live_controller = LiveController(
        find_controller(arguments.policy, load, robot).make(), say=session.say, robot=robot
    )
    node = session.node
    outbox = _Outbox(session, arguments.arrays, robot)
    # Drivers of real robots may offer only best-effort delivery.
    states = node.subscribe(JOINT_STATES, SENSOR_DATA_QOS, read=JointReader(JOINT_STATES.name, robot, _NEEDED))
    attitudes = node.subscribe(IMU, SENSOR_DATA_QOS, read=message_reader(IMU, read_imu))
    velocities = node.subscribe(CMD_VEL)
    inbox = _Inbox(session, states, attitudes)
    while session.running:
        session.wait(_POLL_PERIOD)
        _take_command(session, live_controller, velocities)
        received = inbox.measurement()
        answer = None
        if received is not None:
            try:
                answer = live_controller.measured(*received)
            except QuadrupedError as error:
                session.refuse(str(error))
        now = time.monotonic()
        outbox.send(answer or live_controller.silent(now))
        session.wait_for(_missing(live_controller, states, attitudes))
        session.report(
            "" if live_controller.mode is not Mode.WALKING or live_controller.moving(now) else "standing: no /cmd_vel"
        )
    outbox.let_go()
    return 0


def _terms(arguments: argparse.Namespace) -> Terms:
    """Robot and terms of `--task`, or of the copy that the run of the policy keeps."""
    if not arguments.trust_task:
        return Terms() if arguments.task is None else load_terms(arguments.task)
    if arguments.task is not None:
        raise QuadrupedError(f"--trust-task: found next to --task {arguments.task}; give one of them")
    kept = kept_file(policy_directory(arguments.policy))
    return Terms() if kept is None else load_terms(*kept)


class _Inbox:
    """Combines joint states and orientations into measurements."""

    def __init__(self, session: Session, states: Subscription[Joints], attitudes: Subscription[Imu]) -> None:
        self._session = session
        self._states = states
        self._attitudes = attitudes
        self._imu: Imu | None = None

    def measurement(self) -> tuple[Measurement, float] | None:
        """The newest valid measurement and the `time.monotonic` (s) at which it was taken, or None."""
        # Joint states first: an orientation sent before a joint state has then arrived as well.
        states = list(self._states.messages(self._session.refuse))
        attitude = self._attitudes.newest(self._session.refuse)
        if attitude is not None:
            self._imu = attitude[1]
        if not states or self._imu is None:
            return None
        received, newest = max(states, key=lambda state: state[1].stamp)
        if abs(newest.stamp - self._imu.stamp) > _IMU_AGE * NS_PER_SECOND:
            self._session.refuse(f"{IMU.name} and {JOINT_STATES.name} have timestamps more than {_IMU_AGE:g} s apart")
            return None
        assert newest.positions is not None
        assert newest.velocities is not None
        measurement = Measurement(
            newest.stamp, newest.positions, newest.velocities, self._imu.orientation, self._imu.angular_velocity
        )
        return measurement, received.taken


def _take_command(session: Session, live_controller: LiveController, velocities: Subscription[Any]) -> None:
    newest = velocities.newest(session.refuse)
    if newest is None:
        return
    received, twist = newest
    try:
        live_controller.command(twist.linear.x, twist.angular.z, received.taken)
    except QuadrupedError as error:
        session.refuse(str(error))


class _Outbox:
    """Sends the controller's commands.

    Args:
        session: the session of this process.
        arrays: True for the format of ros2_control.
        robot: robot that is commanded.
    """

    def __init__(self, session: Session, arrays: bool, robot: Robot) -> None:
        self._arrays = arrays
        self._commands = session.node.publish(JOINT_POSITIONS if arrays else JOINT_COMMANDS)
        self._robot = robot
        self._stamp = 0

    def send(self, answer: JointCommand | None) -> None:
        """Send a command, if there is one."""
        if answer is None:
            return
        self._stamp = answer.stamp
        if not self._arrays:
            self._commands.send_bytes(command_message(self._robot, answer.stamp, answer.target))
        elif answer.target is not LIMP:
            self._commands.send(positions_message(answer.target))

    def let_go(self) -> None:
        """Let the robot go limp if it was ever commanded, and wait for the acknowledgement."""
        if self._stamp:
            self.send(JointCommand(self._stamp, LIMP))
            self._commands.wait_until_read(0.5)


def _missing(live_controller: LiveController, states: Subscription[Joints], attitudes: Subscription[Imu]) -> str:
    if live_controller.mode is not Mode.WAITING:
        return ""
    silent = [one.topic.name for one in (states, attitudes) if not one.writers]
    return f"a publisher of {' and of '.join(silent)}" if silent else "fresh states"
