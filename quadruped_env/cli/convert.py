"""Convert a recording of joint states from any known format to another.

The format of IN is detected by its content: this project's CSV, any CSV with --columns, the output of
`ros2 topic echo /joint_states` (YAML, or CSV with --csv), a rosbag2 bag (its directory or its bare .mcap or .db3 file,
compressed or not), a ROS 1 bag, a CSV whose columns bear the joints' names.
The format of OUT follows from its name:

    NAME.csv                this project's CSV
    NAME                    a directory with a rosbag2 bag for Humble and later: /joint_states, and for the robot's
                            joints /robot_description, /tf and /tf_static
    NAME.mcap, NAME.db3     the bare storage file of such a bag

Nothing is guessed: for invalid input the error names the file, the message, the value and the option that fixes it, and
what no robot can have done is reported with the option that repairs it.

    mini-quadruped convert recorded_bag walk.csv
    mini-quadruped convert results/baseline-tuned.csv walk_bag
    mini-quadruped convert measured.csv leg_bag --columns dyna1.toml --map dyna1.toml
"""

import argparse
from pathlib import Path
from typing import Final

import numpy as np

from quadruped_env.cli.common_options import add_overwrite, add_reading_options, add_robot_file, load_with
from quadruped_env.cli.invocation import Invocation
from quadruped_env.control.task_file import load_robot
from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory import JointTrajectory, saving
from quadruped_env.trajectory.formats.bag_writer import STORAGES
from quadruped_env.utils.progress import ProgressLine

_GAPS_SHOWN: Final = 5


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add both files, how the recording is read and changed, and how it is written."""
    parser.add_argument("source", type=Path, metavar="IN", help="the recording")
    parser.add_argument("target", type=Path, metavar="OUT", help="file or bag to write")
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
    group.add_argument("--storage", choices=STORAGES, help="format of the storage in a bag's directory (default: mcap)")
    add_robot_file(parser)
    add_overwrite(parser, "replace OUT if it exists")


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Convert, and print what was read and written."""
    source, target = arguments.source, arguments.target
    saving.check(target, arguments.overwrite, arguments.storage)
    if target.exists() and source.exists() and target.samefile(source):
        raise QuadrupedError(f"{target}: is the file that is read; name another place")
    trajectory = load_with(source, arguments, ProgressLine("reading"))
    notes = trajectory.source.notes
    if arguments.start is not None or arguments.stop is not None:
        trajectory = trajectory.slice(arguments.start, arguments.stop)
    if arguments.rate is not None:
        trajectory = trajectory.resample(arguments.rate)
    if arguments.differentiate is not None:
        trajectory = trajectory.differentiate(arguments.differentiate)
    if arguments.map_back is not None:
        trajectory = trajectory.retarget(arguments.map_back, back=True)
    trajectory.save(target, arguments.overwrite, storage=arguments.storage, robot=load_robot(arguments.task))
    print("\n".join([*_content(trajectory), *notes]))
    print(f"\nwritten: {target}")
    return 0


def _content(trajectory: JointTrajectory) -> list[str]:
    """Return the content of a recording as text, one fact per line."""
    rate = 1.0 / float(np.median(np.diff(trajectory.times))) if len(trajectory) > 1 else float("nan")
    found = [
        f"{len(trajectory)} rows over {trajectory.duration:.3f} s, usually at {rate:.4g} Hz: "
        f"{', '.join(trajectory.kinds)}",
        f"{len(trajectory.names)} joints: {', '.join(trajectory.names)}",
    ]
    gaps = trajectory.gaps()
    found += [f"gap of {gap.seconds:.3f} s at {gap.start:.3f} s" for gap in gaps[:_GAPS_SHOWN]]
    if len(gaps) > _GAPS_SHOWN:
        found.append(f"... {len(gaps)} gaps in all, the longest {max(gap.seconds for gap in gaps):.3f} s")
    return found
