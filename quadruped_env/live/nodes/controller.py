"""Control the robot with a policy at 50 Hz: /joint_states, /imu/data and /cmd_vel in, /joint_commands out.

    mini-quadruped live controller              the shipped policy flat
    mini-quadruped live controller runs/latest  the policy of a training run
    mini-quadruped live controller tuned        the scripted gait that follows /cmd_vel
    mini-quadruped live controller --arrays     for a robot with ros2_control

Waits for fresh states, moves slowly from the measured joint positions to the stance, then follows /cmd_vel; without
a command newer than 0.5 s it stands. Holds its position when no state arrives for 0.2 s, and lets the robot go limp
after 1 s or after a fall; then it waits for fresh states again. Joint targets keep to the joints' range and speed.
States may come in several messages and with other joints; velocities that they lack are computed from the positions if
the policy needs them. States with NaN or wrong counts, and with old, repeated or empty timestamps, are refused and
logged; while the robot is limp, states that are all late are accepted after 0.5 s. Each command has the timestamp of
the state that it answers.
"""

import argparse
import functools
import time
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.by_name import find_controller
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.kept_task_file import kept_file
from quadruped_env.control.live_controller import JointCommand, LiveController, Measurement, Mode
from quadruped_env.control.policy_files import DEFAULT, SHIPPED, Terms, load_terms, policy_directory, read_policy
from quadruped_env.control.steering import Velocity
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import PRESETS
from quadruped_env.live.control_time import ControlTime, SimTime, SystemTime
from quadruped_env.live.messages.imu_messages import Imu, ImuMount, read_imu
from quadruped_env.live.messages.joint_messages import (
    JointMerger,
    JointReader,
    Joints,
    Period,
    command_message,
    positions_message,
)
from quadruped_env.live.messages.velocity_messages import VelocitySubscription
from quadruped_env.live.middleware.node import message_reader
from quadruped_env.live.middleware.topics import CLOCK, IMU, JOINT_COMMANDS, JOINT_POSITIONS, JOINT_STATES, TF_STATIC
from quadruped_env.live.session import Session, add_realtime_argument
from quadruped_env.live.simulator_commands import SimulatorCommands
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import SENSOR_DATA_QOS, Qos
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.utils.rotations import from_roll_pitch_yaw

_POLL_PERIOD: Final = 0.01
"""Time between checks for missing states, s."""
_STATES_QOS: Final = Qos(depth=50, reliable=False)
"""As for sensor data, but deep enough for states that come as one message per joint."""
_FRAMES_QOS: Final = Qos(depth=100, transient_local=True)
"""`tf2_ros::StaticListenerQoS`: the last messages of several publishers."""
_SET_BACK: Final = "the clock was set back"
_COMMAND_TIMEOUT: Final = 0.5
"""System time after which a velocity command expires, where the controller's own timeout is in simulated time, s."""
_SILENCE: Final = 0.5
"""Time without a message after which a waiting node says so, s."""


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
    parser.add_argument(
        "--imu-mount",
        nargs=3,
        type=float,
        metavar=("ROLL", "PITCH", "YAW"),
        help=f"orientation of the IMU in the base frame, rad, as rpy in a URDF (default: looked up on {TF_STATIC.name} "
        f"by the frame_id of {IMU.name})",
    )
    parser.add_argument(
        "--sim-time",
        action="store_true",
        help=f"the time is that of {CLOCK.name}, or of the states' timestamps where nothing publishes it: for a "
        "simulator that does not run at real time, pauses or starts again (ROS's use_sim_time)",
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
    commands = _VelocityCommands(session, live_controller)
    clock: ControlTime = SimTime(node) if arguments.sim_time else SystemTime()
    simulator = SimulatorCommands(session)
    inbox = _Inbox(session, robot, live_controller.needs_velocities, _mount(arguments))
    while session.running:
        session.wait(_POLL_PERIOD)
        simulator.take()
        clock.pause(simulator.paused)
        if simulator.reset:
            live_controller.restart("reset")
        if clock.set_back(session.refuse):
            live_controller.restart(_SET_BACK)
        outbox.send(live_controller.emergency_stop(simulator.stopped))
        commands.take(clock)
        answer = None
        try:
            if received := inbox.measurement():
                measurement, taken = received
                at, back = clock.state(measurement.stamp, taken)
                if back:
                    live_controller.restart(_SET_BACK)
                answer = live_controller.measured(measurement, at)
        except QuadrupedError as error:
            session.refuse(str(error))
        now = clock.now
        outbox.send(answer or live_controller.silent(now))
        waiting = live_controller.waiting_for
        session.wait_for((waiting and not simulator.stopped and inbox.missing()) or waiting)
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


def _mount(arguments: argparse.Namespace) -> NDArray[np.float64] | None:
    """The quaternion of `--imu-mount`."""
    angles = arguments.imu_mount
    if angles is None:
        return None
    if not np.isfinite(angles).all():
        raise QuadrupedError(f"--imu-mount: expected three finite angles in rad; found {angles}")
    return from_roll_pitch_yaw(angles)


class _Inbox:
    """Combines joint states and orientations into measurements.

    Args:
        session: the session of this process.
        robot: the robot.
        velocities: True if measurements need joint velocities.
        mount: orientation of the IMU in the base frame, unit quaternion wxyz (4,); None: look it up.
    """

    def __init__(self, session: Session, robot: Robot, velocities: bool, mount: NDArray[np.float64] | None) -> None:
        node = session.node
        self._session = session
        # Drivers of real robots may offer only best-effort delivery.
        reader = JointReader(JOINT_STATES.name, robot, states=True)
        self._states = node.subscribe(JOINT_STATES, _STATES_QOS, read=reader)
        self._attitudes = node.subscribe(IMU, SENSOR_DATA_QOS, read=message_reader(IMU, read_imu))
        self._frames = node.subscribe(TF_STATIC, _FRAMES_QOS)
        self._merger = JointMerger(robot, velocities, session.say)
        self._mount = ImuMount(robot.base_name, mount)
        self._imu: Imu | None = None
        self._imu_period = Period()
        self._heard = dict.fromkeys((JOINT_STATES.name, IMU.name), time.monotonic())
        """Time at which the last message that can be read was taken, s, by topic."""
        self._refusal = ""
        """Why the last messages gave no measurement; empty if they gave one."""

    def measurement(self) -> tuple[Measurement, float] | None:
        """The newest valid measurement and the `time.monotonic` (s) at which it was taken, or None.

        Raises:
            QuadrupedError: if the times of joint states and IMU differ, or the IMU's mounting is unknown.
        """
        # Joint states first: an orientation sent before a joint state has then arrived as well.
        states = []
        for received, joints in self._states.messages(self._session.refuse):
            self._heard[JOINT_STATES.name] = received.taken
            if state := self._merger.add(joints):
                states.append((received, state))
        for _, transforms in self._frames.messages(self._session.refuse):
            self._mount.add(transforms)
        for received, imu in self._attitudes.messages(self._session.refuse):
            self._heard[IMU.name] = received.taken
            self._imu_period.add(imu.stamp)
            self._imu = imu
        if not states or self._imu is None:
            return None
        received, newest = max(states, key=lambda state: state[1].stamp)
        try:
            measurement = self._paired(newest, self._imu)
        except QuadrupedError as error:
            self._refusal = str(error)
            raise
        self._refusal = ""
        return measurement, received.taken

    def _paired(self, joints: Joints, imu: Imu) -> Measurement:
        age = (joints.stamp - imu.stamp) / NS_PER_SECOND
        tolerance = max(self._merger.period.tolerance, self._imu_period.tolerance)
        if abs(age) > tolerance:
            raise QuadrupedError(
                f"{IMU.name}: {abs(age):.3g} s {'older' if age > 0.0 else 'newer'} than {JOINT_STATES.name}, over "
                f"{tolerance:.3g} s (1.5 periods); check the clocks of both publishers"
            )
        imu = self._mount.in_base(imu)
        assert joints.positions is not None
        assert joints.velocities is not None
        return Measurement(joints.stamp, joints.positions, joints.velocities, imu.orientation, imu.angular_velocity)

    def missing(self) -> str:
        """Why there are no measurements; empty if they come."""
        silent = [one.topic.name for one in (self._states, self._attitudes) if not one.writers]
        if silent:
            return f"a publisher of {' and of '.join(silent)}"
        now = time.monotonic()
        for name, heard in self._heard.items():
            if now - heard > _SILENCE:
                return f"{name}: no message that can be read for {now - heard:.1f} s"
        return self._merger.missing or self._refusal


class _VelocityCommands:
    """Forwards velocity commands to the controller."""

    def __init__(self, session: Session, live_controller: LiveController) -> None:
        self._session = session
        self._live_controller = live_controller
        self._velocities = VelocitySubscription(session.node, session.say)
        self._last: tuple[Velocity, float] | None = None
        """The last command and the `time.monotonic` at which it was taken, s."""

    def take(self, clock: ControlTime) -> None:
        """Forward the newest command; `clock` is the controller's."""
        newest = self._velocities.newest(self._session.refuse)
        if newest is not None:
            self._last = newest[1], newest[0].taken
        elif not clock.simulated or self._last is None or time.monotonic() - self._last[1] > _COMMAND_TIMEOUT:
            # In simulated time, a command that is new by the system's time is repeated: its publisher may not be
            # slowed down or accelerated with the simulator.
            return
        assert self._last is not None
        velocity, taken = self._last
        try:
            self._live_controller.command(*velocity, clock.of(taken))
        except QuadrupedError as error:
            self._last = None
            self._session.refuse(str(error))


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
