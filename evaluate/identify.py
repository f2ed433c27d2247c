"""Fit the simulator's motors to a recording of a robot, and validate them on held-out time.

FILE holds the measured joint states: positions, and velocities and efforts if they were recorded. The commanded
positions come from another file (--commands) or from another topic of the same bag (--commands-topic). Without either,
a file next to FILE is used, under the name that baseline.py gives it: NAME-commands.csv. Each command holds until the
next. Both must use the same clock.

    python evaluate/identify.py measured.csv --commands commands.csv
    python evaluate/identify.py walk_bag --commands-topic /joint_commands
    python evaluate/identify.py measured.csv --commands control.csv --columns MAP.toml --map MAP.toml

Estimated parameters, for hips and for knees: stall_torque (the motor's strength), kp, kd, damping, friction_loss and
armature; and one delay for all. Parameters that the recording does not determine keep their values and are named.
Record the robot on a stand, feet in the air (--base fixed), with joints that move fast, back and forth, up to the
motors' limits now and then. A recording of a robot on the ground is of little use: with --base fixed the ground's
forces are mistaken for friction and inertia, and with --base free contacts make the error so rough that the motors
found may be far from the real ones. Both bases are compared before the fit; if the other one explains the recording
better, the result says not to trust the motors. Intervals are given only for a robot on a stand; they allow for
residuals that are correlated over time, between signals and between joints.

Results: motors.json, which the environment accepts as it is,

    gymnasium.make("MiniQuadruped-v0", config=json.load(open("motors.json")))

and replay.py with --motors; identification.json (what this program prints, as data); report.html (before and after).
"""

import argparse
import shlex
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import JointTrajectory, MissingExtraError, QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.cli.options import plain_warnings
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.files import check_free, free_path
from quadruped_env.identification import BASES, FITTED, QUANTITIES, find_commands, identify
from quadruped_env.identification.identification_report import check_report_extra, identification_files, save
from quadruped_env.replay.motors_file import read_motors
from quadruped_env.trajectory.arguments import add_reading_options, load_with, reading_options


def main() -> None:
    """Run the program."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("file", type=Path, metavar="FILE", help="measured joint states")
    parser.add_argument("--commands", type=Path, metavar="FILE", help="commanded joint positions")
    parser.add_argument("--commands-topic", metavar="TOPIC", help="topic of the commands in the bag")
    parser.add_argument(
        "--base",
        choices=BASES,
        default=BASES[0],
        help="fixed: the robot hangs on a stand, feet in the air; free: it is on flat ground; default: fixed",
    )
    parser.add_argument(
        "--fit", nargs="+", choices=list(QUANTITIES), default=list(FITTED), metavar="NAME", help=" ".join(QUANTITIES)
    )
    parser.add_argument("--without", nargs="+", default=[], metavar="JOINT", help="joints to leave out of the fit")
    parser.add_argument("--start", type=Path, metavar="MOTORS.json", help="initial values; default: the model file's")
    parser.add_argument("--share", type=float, default=0.7, help="share of the time used for the fit; default: 0.7")
    parser.add_argument(
        "--timestep", type=float, metavar="S", help="time step of the physics; default: the environment's, 0.005 s"
    )
    parser.add_argument(
        "--out",
        type=Path,
        metavar="DIRECTORY",
        help="where to write; default: results/identify-FILE, with the next free number if that exists",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")
    add_reading_options(parser)
    args = parser.parse_args()

    out = args.out or free_path(Path("results") / f"identify-{args.file.stem}")
    try:
        check_free(identification_files(out), args.overwrite)
        check_report_extra()
        start = None if args.start is None else read_motors(args.start)
        with plain_warnings("identify.py"):
            measured = load_with(args.file, args, ProgressLine("reading"))
            if args.commands_topic is not None:
                options = {**reading_options(args), "topic": args.commands_topic}
                commands = JointTrajectory.load(args.commands or args.file, **options)
            else:
                commands = load_with(args.commands or find_commands(args.file), args)
            found = identify(
                measured,
                commands,
                args.base,
                start,
                args.fit,
                args.share,
                args.timestep,
                args.without,
                ProgressLine("fitting"),
            )
        save(found, out, shlex.join(["python", "evaluate/identify.py", *sys.argv[1:]]), args.overwrite)
    except (QuadrupedError, MissingExtraError) as error:
        sys.exit(f"identify.py: {error}")
    print(found.table())
    print(f"\nmotors, numbers and report: {out}")


if __name__ == "__main__":
    main()
