"""Convert a recording of joint states from any known format to another.

IN is recognised by what is in it: this project's CSV, any CSV with --columns, what `ros2 topic echo /joint_states`
prints (as YAML or with --csv), a rosbag2 bag (its directory or its bare .mcap or .db3 file, compressed or not), a ROS 1
bag. OUT is what its name says:

    NAME.csv                this project's CSV
    NAME                    a directory with a rosbag2 bag for Humble and later: /joint_states, and for this robot's
                            joints /robot_description, /tf and /tf_static
    NAME.mcap, NAME.db3     the bare storage file of such a bag

Nothing is guessed: what does not fit is an error that names the file, the message, the value and the option that helps.
Recordings of any length need little memory, unless --sort, --rate, --start, --stop or --differentiate is given.

    python evaluate/convert.py recorded_bag walk.csv
    python evaluate/convert.py results/baseline-tuned.csv walk_bag
    python evaluate/convert.py measured.csv leg_bag --columns dyna1.toml --map dyna1.toml
"""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import JointTrajectory, MissingExtraError, QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.evaluation.progress import ProgressLine
from quadruped_env.trajectory.arguments import add_reading_options, reading_options
from quadruped_env.trajectory.convert import convert
from quadruped_env.trajectory.options import ReadOptions
from quadruped_env.trajectory.saving import WriteOptions


def main() -> None:
    """Run the program."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("source", type=Path, metavar="IN", help="the recording")
    parser.add_argument("target", type=Path, metavar="OUT", help="where to write")
    add_reading_options(parser)
    group = parser.add_argument_group("changing")
    group.add_argument("--start", type=float, metavar="S", help="leave out what is before, in s from the first stamp")
    group.add_argument("--stop", type=float, metavar="S", help="leave out what is from there on")
    group.add_argument("--rate", type=float, metavar="HZ", help="even rows at this rate, on straight lines between")
    group.add_argument(
        "--differentiate",
        type=float,
        metavar="S",
        nargs="?",
        const=0.05,
        help="make velocities of the positions, filtered over this many s; 0.05 unless given",
    )
    group = parser.add_argument_group("writing")
    group.add_argument("--storage", choices=["mcap", "sqlite3"], help="of a bag's directory; default: mcap")
    group.add_argument(
        "--tf-rate", type=float, default=20.0, metavar="HZ", help="of /tf in a bag; default: 20; 0 leaves it out"
    )
    group.add_argument("--compress", action="store_true", help="compress a bag with zstd")
    group.add_argument("--overwrite", action="store_true", help="replace OUT if it exists")
    args = parser.parse_args()

    def change(trajectory: JointTrajectory) -> JointTrajectory:
        """What the options make of the whole recording."""
        if args.start is not None or args.stop is not None:
            trajectory = trajectory.slice(args.start, args.stop)
        if args.rate is not None:
            trajectory = trajectory.resample(args.rate)
        return trajectory if args.differentiate is None else trajectory.differentiate(args.differentiate)

    changes = any(value is not None for value in (args.start, args.stop, args.rate, args.differentiate))
    try:
        account = convert(
            args.source,
            args.target,
            ReadOptions.of(**reading_options(args)),
            WriteOptions(args.storage, args.tf_rate, args.compress, args.overwrite),
            change if changes else None,
            ProgressLine("converting"),
        )
    except (QuadrupedError, MissingExtraError) as error:
        sys.exit(f"convert.py: {error}")
    print(account.text())
    print(f"\nwritten: {args.target}")


if __name__ == "__main__":
    main()
