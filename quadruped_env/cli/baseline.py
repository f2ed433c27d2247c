"""Measure a scripted gait, and record the joints of a robot that walks with it.

The metrics come from several episodes with random starts. The recorded episode starts with the robot at rest in its
stance and is deterministic, so `replay`, on the same terrain, can repeat it to the last bit:

    mini-quadruped baseline --preset tuned --commands -o results/tuned.csv
    mini-quadruped replay results/tuned.csv --mode dynamic

The result is a CSV of joint states (timestamp in ns; position in rad, velocity in rad/s, effort in N m of each joint),
or a bag for `ros2 bag play` (-o walk_bag).
"""

import argparse
from pathlib import Path

from quadruped_env.cli import common_options as options
from quadruped_env.cli.invocation import Invocation
from quadruped_env.gait import PRESETS
from quadruped_env.utils.files import free_path
from quadruped_env.utils.progress import ProgressLine


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the gait, the episodes and the output."""
    parser.add_argument("--preset", choices=PRESETS, default="tuned", help="the gait (default: %(default)s)")
    parser.add_argument(
        "--commands",
        action="store_true",
        help="write the joint targets that the gait computes, instead of the measured joints",
    )
    parser.add_argument(
        "--rate",
        type=float,
        default=50.0,
        metavar="HZ",
        help="joint targets per second: 50 is the robot's control rate, 20 the rate of the ROS 2 tutorial's publisher; "
        "measured joints always come at 50 Hz (default: %(default)g)",
    )
    parser.add_argument(
        "--seconds", type=float, default=10.0, metavar="S", help="length of an episode, s (default: %(default)g)"
    )
    parser.add_argument(
        "--episodes",
        type=int,
        default=20,
        metavar="N",
        help="random starts that the metrics are computed from (default: %(default)s)",
    )
    options.add_robot_file(parser, terrain=True)
    options.add_terrain(parser, "flat")
    options.add_output(
        parser,
        "FILE",
        "NAME.csv, or NAME for a rosbag2 bag with /tf from odom on "
        f"(default: results/baseline-PRESET.csv, {options.NEXT_FREE})",
    )
    options.add_overwrite(parser)


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Measure, record, and print the metrics."""
    from quadruped_env.control.task_file import load_robot
    from quadruped_env.evaluation.baseline import run_baseline
    from quadruped_env.trajectory import saving

    name = f"baseline-{arguments.preset}{'-commands' if arguments.commands else ''}.csv"
    output = arguments.output or free_path(Path("results") / name)
    saving.check(output, arguments.overwrite)
    baseline = run_baseline(
        arguments.preset,
        arguments.seconds,
        arguments.rate,
        arguments.episodes,
        progress=ProgressLine("measuring"),
        robot=load_robot(arguments.task),
        terrain=options.named_terrain(arguments),
    )
    if arguments.commands:
        baseline.commands.save(output, arguments.overwrite, robot=baseline.recording.robot)
    else:
        baseline.recording.save(output, arguments.overwrite)
    print(f"{baseline.table()}\n\n{'commands' if arguments.commands else 'measured joints'}: {output}")
    return 0
