"""Replay a recorded joint trajectory, and report how closely the robot follows it.

FILE is a recording of joint positions in any known format: CSV, ROS 2 and ROS 1 bags, the output of `ros2 topic
echo`. Another robot's recording needs a map of its joints (--map), a CSV of another layout a map of its columns
(--columns).

    kinematic   sets the joints to the recorded positions: no forces, no ground, no errors. Link poses are in the
                frame of base_link.
    dynamic     interpolates them linearly and sets them as joint targets, 50 times a second, with gravity and ground.
                The robot starts at rest in the recording's first pose, on its feet, facing along x. Nothing is
                randomized, so every run is the same; commands written by baseline.py repeat its recording bit for bit.
                Link poses are in the world frame.

    python evaluate/replay.py results/baseline-tuned.csv --video walk.mp4
    python evaluate/replay.py results/baseline-tuned-commands.csv --compare results/baseline-tuned.csv
    python evaluate/replay.py control.csv --columns MAP.toml --map MAP.toml --compare measured.csv --motors motors.json

Results: report.html (errors, lag and limits of each joint, and pictures), link_poses.csv (x, y, z in m and quaternion
w, x, y, z of every link over time), tracking.json (what this program prints, as data), and in dynamic mode
joint_states.csv (the joints as measured). A tracking error is the played position minus the recorded one at the same
time, the start included.
"""

import argparse
import shlex
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.cli.options import add_video_option, plain_warnings
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.files import check_free, free_path
from quadruped_env.replay.motors_file import read_motors
from quadruped_env.replay.replay import MODES, replay, replay_files
from quadruped_env.replay.replay_report import write_replay_report
from quadruped_env.reporting.films.video import prepare_video, save_film
from quadruped_env.trajectory.arguments import add_reading_options, load_with


def main() -> None:
    """Run the program."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("file", type=Path, metavar="FILE", help="a recording of joint states")
    parser.add_argument("--mode", choices=MODES, default="dynamic", help="default: dynamic")
    parser.add_argument(
        "--clip",
        action="store_true",
        help="move positions outside the joint limits to the limit; without it they are an error",
    )
    parser.add_argument(
        "--compare",
        type=Path,
        nargs="?",
        const=True,
        metavar="RECORDING",
        help="compare the simulated positions, velocities and efforts with a recording on the same clock: what the "
        "robot did with the commands in FILE; without a name, with FILE itself",
    )
    parser.add_argument("--motors", type=Path, metavar="MOTORS.json", help="the robot's motors, from identify.py")
    parser.add_argument(
        "--out",
        type=Path,
        metavar="DIRECTORY",
        help="where to write; default: results/replay-FILE, with the next free number if that exists",
    )
    parser.add_argument("--no-report", action="store_true", help="leave out report.html, which needs the report extra")
    add_video_option(parser)
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")
    add_reading_options(parser)
    args = parser.parse_args()

    out = args.out or free_path(Path("results") / f"replay-{args.file.stem}")
    compare = args.compare is not None
    try:
        check_free(replay_files(out), args.overwrite)
        prepare_video(args.video, args.overwrite)
        with plain_warnings("replay.py"):
            result = replay(
                load_with(args.file, args, ProgressLine("reading")),
                args.mode,
                args.clip,
                ProgressLine("playing"),
                None if args.motors is None else read_motors(args.motors),
                load_with(args.compare, args) if isinstance(args.compare, Path) else None,
            )
            result.save(out, args.overwrite, ProgressLine("writing"), compare)
        if not args.no_report:
            write_replay_report(result, out, shlex.join(["python", "evaluate/replay.py", *sys.argv[1:]]), compare)
        if args.video:
            save_film(args.video, [result.film()], ProgressLine("filming"))
    except (QuadrupedError, MissingExtraError) as error:
        sys.exit(f"replay.py: {error}")
    print(result.table())
    if compare:
        print(f"\n{result.comparison().table()}")
    print(
        f"\n{'' if args.no_report else 'report, '}link poses, {'joints and ' if args.mode == 'dynamic' else ''}"
        f"tracking errors: {out}"
    )
    if args.video:
        print(f"video: {args.video}")


if __name__ == "__main__":
    main()
