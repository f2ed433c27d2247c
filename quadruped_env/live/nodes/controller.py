"""Control the robot with a policy at 50 Hz: /joint_states, /imu/data and /cmd_vel in, /joint_commands out.

    mini-quadruped live controller              the shipped policy flat
    mini-quadruped live controller runs/latest  the policy of a training run
    mini-quadruped live controller tuned        the scripted gait that follows /cmd_vel
    mini-quadruped live controller --arrays     for a robot with ros2_control
    mini-quadruped live controller --map my_robot.toml    for motors with other names, signs, zeros or units
    mini-quadruped live controller --start-stopped        limp until /estop is released, as a service should start

Waits for fresh states, moves slowly from the measured joint positions to the stance, then follows /cmd_vel; without
a command newer than 0.5 s it stands. Control steps without a new state use the last one. Holds its position when no
state arrives for 0.2 s, and lets the robot go limp after 1 s, after a fall, or after 0.2 s of joint targets that are
not finite; then it waits for fresh states again. Joint targets keep to the joints' range and speed.
States may come in several messages and with other joints; velocities that they lack are computed from the positions if
the policy needs them. States with NaN or wrong counts, and with old, repeated or empty timestamps, are refused and
logged; while the robot is limp, states that are all late are accepted after 0.5 s. Each command has the timestamp of
the state that it answers.

/estop true lets the robot go limp. After the release it stays so until a velocity command other than zero comes. The
node ends if another one commands the robot already.
"""

import argparse
import functools
from typing import Final

import numpy as np

from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.live_controller import JointCommand, LiveController, Mode
from quadruped_env.control.task_file import Terms, load_terms
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import PRESETS
from quadruped_env.live.command_publisher import CommandPublisher
from quadruped_env.live.control_time import ControlTime, SimTime, SystemTime
from quadruped_env.live.controller_inputs import Measurements, SlowInputs, VelocityCommands
from quadruped_env.live.emergency_stop import EmergencyStop
from quadruped_env.live.messages.diagnostics import ERROR, OK, WARN, Diagnostics
from quadruped_env.live.messages.driver_joints import DriverJoints, add_map_argument
from quadruped_env.live.middleware.topics import CLOCK, ESTOP, JOINT_POSITIONS, RESET
from quadruped_env.live.session import Session, add_realtime_argument
from quadruped_env.policies.by_name import find_controller
from quadruped_env.policies.files import DEFAULT, SHIPPED, kept_file, read_policy
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.rotations import from_roll_pitch_yaw

_POLL_PERIOD: Final = 0.01
"""Time between checks for missing states, s."""
_SET_BACK: Final = "the clock was set back"


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
        f"order {', '.join(MINI_QUADRUPED.joint_names)}, or the order of --task's robot, or with --map the one "
        "in the log. This format has no limp command: the node stops sending, and the driver has to disable the "
        "motors",
    )
    add_map_argument(parser)
    parser.add_argument(
        "--task",
        metavar="FILE",
        help="Python file of your robot, or of the custom terms that the policy was trained with; it is executed. A "
        "policy needs it if it defines its robot or observations",
    )
    parser.add_argument(
        "--trust-task", action="store_true", help="execute the copy of that file that the run keeps, instead of --task"
    )
    parser.add_argument(
        "--imu-mount",
        nargs=3,
        type=float,
        metavar=("ROLL", "PITCH", "YAW"),
        help="orientation of the IMU in the base frame, rad, as rpy in a URDF; needed if its frame_id is another",
    )
    parser.add_argument(
        "--sim-time",
        action="store_true",
        help=f"the time comes from {CLOCK.name}, or from the states' timestamps where nothing publishes it: for a "
        "simulator that does not run at real time, or starts again (ROS's use_sim_time)",
    )
    parser.add_argument(
        "--start-stopped",
        action="store_true",
        help=f"start as after an emergency stop: the robot stays limp until {ESTOP.name} is false and then a velocity "
        "command comes. For a program that is started again after it was killed, as systemd does",
    )
    add_realtime_argument(parser)


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Control the robot until the session ends, then let it go limp."""
    terms = _terms(arguments)
    robot, load = terms.robot, functools.partial(read_policy, terms=terms)
    live_controller = LiveController(
        find_controller(arguments.policy, load, robot).make(), say=session.say, robot=robot
    )
    driver = DriverJoints.load(arguments.map, robot)
    if arguments.map is not None:
        session.say(f"--map: drives {', '.join(driver.joint_names)}")
    publisher = CommandPublisher(
        session, driver, arguments.arrays, lambda: live_controller.mode not in (Mode.WAITING, Mode.LIMP)
    )
    try:
        _control(session, arguments, live_controller, driver, publisher)
    finally:
        # Also where an error ends the node: otherwise the motors keep their torque until the driver's watchdog trips.
        publisher.let_go()
    return 0


def _control(
    session: Session,
    arguments: argparse.Namespace,
    live_controller: LiveController,
    driver: DriverJoints,
    publisher: CommandPublisher,
) -> None:
    """Answer the robot's states until the session ends."""
    robot = live_controller.robot
    commands = VelocityCommands(session, live_controller)
    clock: ControlTime = SimTime(session.node) if arguments.sim_time else SystemTime()
    stop, resets = EmergencyStop(session, arguments.start_stopped), session.node.subscribe(RESET)
    inbox = Measurements(session, robot, driver, live_controller.needs_velocities, _mount(arguments))

    def send(answer: JointCommand | None) -> None:
        if answer is not None:
            try:
                publisher.send(answer.stamp, driver.target_to_driver(answer.target))
                inbox.commanded(answer.target)
            except QuadrupedError as error:
                # Sent here too: an error of the map comes before the publisher has seen anything.
                publisher.send(answer.stamp, live_controller.fail(str(error)).target)
                inbox.commanded(LIMP)

    slow = SlowInputs(1.0 / live_controller.period, session.say)
    diagnostics = Diagnostics(session.node, robot.name)
    for _ in session.turns(lambda: min(_POLL_PERIOD, live_controller.remaining(clock.now))):
        if resets.newest(session.refuse):
            live_controller.restart("reset")
            inbox.commanded(LIMP)
        if clock.set_back(session.refuse):
            live_controller.restart(_SET_BACK)
        send(live_controller.emergency_stop(stop.stopped))
        commands.take(clock)
        answer = None
        try:
            if received := inbox.newest():
                at, back = clock.state(received[0].stamp, received[1])
                if back:
                    live_controller.restart(_SET_BACK)
                answer = live_controller.measured(received[0], at)
        except QuadrupedError as error:
            session.refuse(str(error))
        now = clock.now
        send(answer or live_controller.silent(now))
        waiting = live_controller.waiting_for
        if waiting:
            waiting = stop.awaited if stop.stopped else inbox.missing() or waiting
        session.wait_for(waiting)
        slow.update(inbox.rates)
        problems = [
            one for one in (live_controller.fault, publisher.guard.problem, slow.warning, *inbox.problems) if one
        ]
        mode = live_controller.mode
        level = ERROR if mode is Mode.LIMP or live_controller.fault else WARN if waiting or problems else OK
        diagnostics.send(
            level,
            "; ".join([mode.value, *[f"waits for {waiting}"] * bool(waiting), *problems]),
            {
                "policy": arguments.policy,
                "velocity command": live_controller.moving(now),
                "refused messages": session.refuse.count,
                "problems": "; ".join(problems),
                "control rate, Hz": f"{1.0 / live_controller.period:g}",
                **{f"{name}, Hz by timestamps": f"{rate:.1f}" for name, rate in inbox.rates.items()},
            },
        )


def _terms(arguments: argparse.Namespace) -> Terms:
    """Load robot and terms of `--task`, or of the copy that the run of the policy keeps."""
    if not arguments.trust_task:
        return Terms() if arguments.task is None else load_terms(arguments.task)
    if arguments.task is not None:
        raise QuadrupedError(f"--trust-task: found next to --task {arguments.task}; give one of them")
    kept = kept_file(arguments.policy)
    return Terms() if kept is None else load_terms(*kept)


def _mount(arguments: argparse.Namespace) -> Floats | None:
    """Return the quaternion of `--imu-mount`."""
    angles = arguments.imu_mount
    if angles is None:
        return None
    if not np.isfinite(angles).all():
        raise QuadrupedError(f"--imu-mount: expected three finite angles in rad; found {angles}")
    return from_roll_pitch_yaw(angles)
