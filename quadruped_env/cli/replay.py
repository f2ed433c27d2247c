"""Play a recorded joint trajectory again, and measure how closely the robot follows it.

FILE is a recording of joint positions in any known format: CSV, ROS 2 and ROS 1 bags, what `ros2 topic echo` prints.
Another robot's recording needs a map of its joints (--map), a CSV that is not this project's a map of its columns
(--columns).

    kinematic   sets the joints to the recorded positions: no forces, no ground, no errors. Link poses are in the
                frame of base_link.
    dynamic     makes them, on straight lines and 50 times a second, the targets of the motors, with gravity and ground.
                The robot starts at rest in the recording's first pose, on its feet, facing along x, and has no
                randomness, so it does the same every time; commands that `baseline` wrote repeat its recording to the
                last bit. Link poses are in the world.

    mini-quadruped replay results/baseline-tuned.csv --video walk.mp4
    mini-quadruped replay results/baseline-tuned-commands.csv --compare results/baseline-tuned.csv
    mini-quadruped replay control.csv --columns MAP.toml --map MAP.toml --compare measured.csv --motors motors.json

Results: report.html (errors, lag and limits of each joint, and pictures), link_poses.csv (x, y, z in m and quaternion
w, x, y, z of every link over time), tracking.json (what this program prints, as data), and in dynamic mode
joint_states.csv (the joints as measured). A tracking error is the played position minus the recorded one at the same
time, the start included.
"""

import argparse
from pathlib import Path

from quadruped_env.cli import common_options as options
from quadruped_env.cli.common_options import add_reading_options, load_with
from quadruped_env.cli.invocation import Invocation
from quadruped_env.replay.replay import MODES
from quadruped_env.utils.files import check_free, free_path
from quadruped_env.utils.program import Extras
from quadruped_env.utils.progress import ProgressLine


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the recording, how it is played, and the output."""
    parser.add_argument("file", type=Path, metavar="FILE", help="a recording of joint states")
    parser.add_argument("--mode", choices=MODES, default="dynamic", help="as above (default: %(default)s)")
    parser.add_argument(
        "--compare",
        type=Path,
        nargs="?",
        const=True,
        metavar="RECORDING",
        help="compare the simulated positions, velocities and efforts with a recording on the same clock, made by "
        "the robot that received the targets in FILE; without a name, with FILE's own",
    )
    parser.add_argument(
        "--motors", type=Path, metavar="MOTORS.json", help="motors of the robot, a result of `identify`"
    )
    options.add_robot_file(parser, terrain=True)
    options.add_terrain(parser, "flat", level=False)
    options.add_output(parser, "DIR", f"directory of the results (default: results/replay-FILE, {options.NEXT_FREE})")
    options.add_video(parser)
    options.add_overwrite(parser)
    add_reading_options(parser)


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Play, write the results, and print them."""
    from quadruped_env.control.task_file import load_robot
    from quadruped_env.replay.motors_file import read_motors
    from quadruped_env.replay.replay import replay, replay_files
    from quadruped_env.replay.replay_report import write_replay_report
    from quadruped_env.report.films.video import prepare_video
    from quadruped_env.report.report_directory import REPORT_FILE

    output = arguments.output or free_path(Path("results") / f"replay-{arguments.file.stem}")
    compare = arguments.compare is not None
    check_free(replay_files(output), arguments.overwrite)
    prepare_video(arguments.video, arguments.overwrite)
    robot = load_robot(arguments.task)
    result = replay(
        load_with(arguments.file, arguments, ProgressLine("reading")),
        arguments.mode,
        ProgressLine("playing"),
        None if arguments.motors is None else read_motors(arguments.motors, robot),
        load_with(arguments.compare, arguments) if isinstance(arguments.compare, Path) else None,
        robot,
        options.named_terrain(arguments),
    )
    result.save(output, arguments.overwrite, ProgressLine("writing"), compare)
    print(result.text(compare))
    written = "joints and tracking errors" if arguments.mode == "dynamic" else "tracking errors"
    print(f"\nlink poses, {written}: {output}")
    extras = Extras()
    with extras.part(REPORT_FILE):
        write_replay_report(result, output, invocation.line, compare)
        print(f"report:  {output / REPORT_FILE}")
    options.save_video(arguments.video, lambda: [result.film()], extras)
    return extras.status
