"""Fit the simulator's motors to a recording of a robot, and test on held-out time whether that helps.

FILE holds the measured joints: positions, and velocities and efforts if they were recorded. The joint targets come from
another file (--commands), from another topic of the same bag (--commands-topic), or from other columns of the same file
(--commands-columns). Without any of them, they are read from NAME-commands.csv next to FILE, the name that `baseline`
uses. Targets are joint positions; each holds until the next. Both recordings must use the same clock.

    mini-quadruped identify measured.csv --commands targets.csv
    mini-quadruped identify walk_bag --commands-topic /joint_commands
    mini-quadruped identify measured.csv --commands control.csv --columns MAP.toml --map MAP.toml
    mini-quadruped identify log.csv --columns measured.toml --map measured.toml --commands-columns targets.toml
    mini-quadruped identify bench.csv --without RF_hip_joint RF_knee_joint    # which need not be in the file

Estimated for each kind of joint (hips, knees, abductions): stall_torque, kp, kd, damping, friction_loss and armature;
and one delay for all joints. A parameter that the recording does not determine keeps its value and is reported. A
recording is good if the joints move fast and in both directions, sometimes up to the motors' limits, with the robot on
a stand and its feet in the air. A recording on the ground is refused: its contact forces would appear as friction and
inertia. Confidence intervals allow for residuals that are correlated over time, between signals and between joints.
Estimates and intervals hold only if the parameters that are not fitted are right: with --fit kp, a wrong kd gives an
interval that excludes the true kp.

Results: motors.json, which the environment accepts as its config,

    gymnasium.make("MiniQuadruped-v0", config=json.load(open("motors.json")))

and `replay --motors`; identification.json (what this program prints, as data); report.html (before and after).
"""

import argparse
from pathlib import Path

from quadruped_env.cli.common_options import (
    NEXT_FREE,
    add_output,
    add_overwrite,
    add_reading_options,
    add_robot_file,
    load_with,
    reading_options,
)
from quadruped_env.cli.invocation import Invocation
from quadruped_env.errors import QuadrupedError
from quadruped_env.identification import FITTED, QUANTITIES
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.utils.files import check_free, free_path
from quadruped_env.utils.program import Extras
from quadruped_env.utils.progress import ProgressLine


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the recordings, the fit and the output."""
    parser.add_argument("file", type=Path, metavar="FILE", help="the measured joints")
    parser.add_argument("--commands", type=Path, metavar="FILE", help="the joint targets")
    parser.add_argument("--commands-topic", metavar="TOPIC", help="topic of the joint targets in the bag")
    parser.add_argument(
        "--commands-columns",
        type=Path,
        metavar="MAP.toml",
        help="map of the columns of the joint targets, in the file of --commands or in FILE (default: --columns). For "
        'the same --map they bear the names of the measured joints: positions = { q_0 = "q_des_0" }',
    )
    parser.add_argument(
        "--fit",
        nargs="+",
        choices=list(QUANTITIES),
        default=list(FITTED),
        metavar="NAME",
        help=f"parameters to estimate, of {', '.join(QUANTITIES)} (default: {' '.join(FITTED)}); "
        "the others are assumed to be right",
    )
    parser.add_argument(
        "--without",
        nargs="+",
        action="extend",
        default=[],
        metavar="JOINT",
        help="joints to leave out, which need not be in the files: they are then at rest in the stance",
    )
    parser.add_argument("--start", type=Path, metavar="MOTORS.json", help="motors to start from (default: the robot's)")
    add_robot_file(parser)
    add_output(parser, "DIR", f"directory of the results (default: results/identify-FILE, {NEXT_FREE})")
    add_overwrite(parser)
    add_reading_options(parser)


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Fit, write the results, and print them."""
    from quadruped_env.control.task_file import load_robot
    from quadruped_env.identification import identify
    from quadruped_env.identification.identification_report import (
        check_report_extra,
        identification_files,
        save_numbers,
        write_report,
    )
    from quadruped_env.replay.motors_file import read_motors
    from quadruped_env.report.report_directory import REPORT_FILE

    output = arguments.output or free_path(Path("results") / f"identify-{arguments.file.stem}")
    check_free(identification_files(output), arguments.overwrite)
    check_report_extra()
    robot = load_robot(arguments.task)
    start = None if arguments.start is None else read_motors(arguments.start, robot)
    measured = load_with(arguments.file, arguments, ProgressLine("reading"))
    others = {"topic": arguments.commands_topic, "columns": arguments.commands_columns}
    given = {name: value for name, value in others.items() if value is not None}
    file = arguments.commands or (arguments.file if given else _commands_beside(arguments.file))
    commands = JointTrajectory.load(file, **reading_options(arguments) | given)
    found = identify(
        measured,
        commands,
        start=start,
        fitted=arguments.fit,
        without=arguments.without,
        progress=ProgressLine("fitting"),
        robot=robot,
    )
    document = save_numbers(found, output, invocation.line, arguments.overwrite)
    print(found.text())
    print(f"\nmotors and numbers: {output}")
    extras = Extras()
    with extras.part(REPORT_FILE):
        print(f"report: {write_report(found, output, document)}")
    return extras.status


def _commands_beside(measured: Path) -> Path:
    """Return the path of the file of joint targets next to the measurements, named as by `mini-quadruped baseline`."""
    path = measured.with_name(f"{measured.stem}-commands.csv")
    if not path.is_file():
        raise QuadrupedError(
            f"{measured}: no joint targets: there is no {path.name} next to it; name the file (--commands), the topic "
            f"in the bag (--commands-topic), or the columns of the targets in {measured.name} (--commands-columns)"
        )
    return path
