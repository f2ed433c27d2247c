"""Convert a recording of joint states from any known format to another.

The format of IN is detected by its content: this project's CSV, any CSV with --columns, the output of
`ros2 topic echo /joint_states` (YAML, or CSV with --csv), JSON lines of rosbridge, a rosbag2 bag (its directory or its
bare .mcap or .db3 file, compressed or not), a ROS 1 bag, a CSV whose columns bear the joints' names.
The format of OUT follows from its name:

    NAME.csv                this project's CSV
    NAME                    a directory with a rosbag2 bag for Humble and later: /joint_states, and for the robot's
                            joints /robot_description, /tf and /tf_static
    NAME.mcap, NAME.db3     the bare storage file of such a bag

Nothing is guessed: for invalid input the error names the file, the message, the value and the option that fixes it, and
what no robot can have done is reported with the option that repairs it. Recordings of any length need little memory,
unless an option changes them as a whole (--sort, --unwrap, --despike, --rate, --start, --stop, --differentiate,
--map-back).

    mini-quadruped convert recorded_bag walk.csv
    mini-quadruped convert results/baseline-tuned.csv walk_bag
    mini-quadruped convert measured.csv leg_bag --columns dyna1.toml --map dyna1.toml
"""

import argparse
from pathlib import Path

from quadruped_env.cli.common_options import (
    add_output,
    add_overwrite,
    add_reading_options,
    add_robot_file,
    reading_options,
)
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.progress_line import ProgressLine
from quadruped_env.control.task_file import load_robot
from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.trajectory.file_conversion import convert
from quadruped_env.trajectory.read_options import ReadOptions
from quadruped_env.trajectory.saving import WriteOptions


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add both files, how the recording is read and changed, and how it is written."""
    parser.add_argument("source", type=Path, metavar="IN", help="the recording")
    parser.add_argument(
        "target", type=Path, nargs="?", metavar="OUT", help="file or bag to write; -o OUT does the same"
    )
    add_reading_options(parser)
    group = parser.add_argument_group("changing")
    group.add_argument(
        "--start", type=float, metavar="S", help="discard all samples before this time, in s from the first timestamp"
    )
    group.add_argument("--stop", type=float, metavar="S", help="discard all samples from this time on")
    group.add_argument(
        "--rate", type=float, metavar="HZ", help="resample to this rate, with linear interpolation between messages"
    )
    group.add_argument(
        "--differentiate",
        type=float,
        metavar="S",
        nargs="?",
        const=0.05,
        help="compute velocities from the positions, filtered over this time in s (default of the time: 0.05)",
    )
    group.add_argument(
        "--map-back",
        type=Path,
        metavar="MAP.toml",
        help="write the joints of the robot that the map describes, in its units, from this robot's joints",
    )
    group = parser.add_argument_group("writing")
    group.add_argument(
        "--storage", choices=["mcap", "sqlite3"], help="format of the storage in a bag's directory (default: mcap)"
    )
    group.add_argument(
        "--tf-rate",
        type=float,
        default=20.0,
        metavar="HZ",
        help="rate of /tf in a bag; 0 leaves it out (default: %(default)g)",
    )
    group.add_argument("--compress", action="store_true", help="compress a bag with zstd")
    add_robot_file(parser)
    add_output(parser, "OUT", argparse.SUPPRESS)
    add_overwrite(parser, "replace OUT if it exists")


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Convert, and print what was read and written."""
    if (arguments.target is None) == (arguments.output is None):
        raise QuadrupedError("expected one place to write to, OUT or -o OUT; name it once")
    target = arguments.target or arguments.output

    def change(trajectory: JointTrajectory) -> JointTrajectory:
        """Apply the options to the whole recording."""
        if arguments.start is not None or arguments.stop is not None:
            trajectory = trajectory.slice(arguments.start, arguments.stop)
        if arguments.rate is not None:
            trajectory = trajectory.resample(arguments.rate)
        if arguments.differentiate is not None:
            trajectory = trajectory.differentiate(arguments.differentiate)
        return trajectory if arguments.map_back is None else trajectory.retarget(arguments.map_back, back=True)

    changing = (arguments.start, arguments.stop, arguments.rate, arguments.differentiate, arguments.map_back)
    account = convert(
        arguments.source,
        target,
        ReadOptions.of(**reading_options(arguments)),
        WriteOptions(
            arguments.storage, arguments.tf_rate, arguments.compress, arguments.overwrite, load_robot(arguments.task)
        ),
        change if any(value is not None for value in changing) else None,
        ProgressLine("converting"),
    )
    print(account.text())
    print(f"\nwritten: {target}")
    return 0
