"""Measure a scripted gait, and record the joints of a robot that walks with it.

The gait's metrics come from several episodes with random starts. The recorded episode begins with the robot at rest
in its stance and is not randomized, so evaluate/replay.py can repeat it bit for bit:

    python evaluate/baseline.py --preset tuned --commands --out results/tuned.csv
    python evaluate/replay.py results/tuned.csv --mode dynamic

The result is a CSV of joint states (timestamp in ns; position in rad, velocity in rad/s, effort in N m of each joint),
or a bag for `ros2 bag play` (--out walk_bag), and a JSON file of the metrics next to it.
"""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.cli.options import add_video_option
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.evaluation.baseline import check_target, report_path, run_baseline
from quadruped_env.evaluation.rollout import FIRST_SEED
from quadruped_env.files import free_path
from quadruped_env.gait import PRESETS
from quadruped_env.reporting.films.film import Motion
from quadruped_env.reporting.films.video import prepare_video, save_film


def main() -> None:
    """Run the program."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--preset", choices=PRESETS, default="tuned", help="the gait; default: tuned")
    parser.add_argument(
        "--commands",
        action="store_true",
        help="write the gait's joint targets instead of the measured joint states",
    )
    parser.add_argument(
        "--rate",
        type=float,
        default=50.0,
        metavar="HZ",
        help="joint targets per second: 50 is the robot's control rate (the default), 20 that of the ROS 2 tutorial's "
        "publisher. Measured joint states are always recorded at 50 Hz",
    )
    parser.add_argument("--seconds", type=float, default=10.0, help="length of an episode; default: 10")
    parser.add_argument("--episodes", type=int, default=20, help="random starts for the metrics; default: 20")
    parser.add_argument(
        "--seed", type=int, default=FIRST_SEED, help=f"seed of the first random start; default: {FIRST_SEED}"
    )
    parser.add_argument(
        "--out",
        type=Path,
        metavar="FILE",
        help="where to write: NAME.csv, or NAME for a rosbag2 bag with /tf starting at odom; default: "
        "results/baseline-PRESET.csv, with the next free number if that exists",
    )
    add_video_option(parser)
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")
    args = parser.parse_args()

    name = f"baseline-{args.preset}{'-commands' if args.commands else ''}.csv"
    out = args.out or free_path(Path("results") / name)
    try:
        check_target(out, args.overwrite)
        prepare_video(args.video, args.overwrite)
        progress = ProgressLine("measuring")
        baseline = run_baseline(args.preset, args.seconds, args.rate, args.episodes, args.seed, progress)
        baseline.save(out, args.commands, args.overwrite)
        if args.video:
            save_film(args.video, [Motion.of_recording(baseline.recording, args.preset)], ProgressLine("filming"))
    except (QuadrupedError, MissingExtraError) as error:
        sys.exit(f"baseline.py: {error}")
    print(baseline.table())
    print(f"\n{'commands' if args.commands else 'measured joints'}: {out}\nmetrics: {report_path(out)}")
    if args.video:
        print(f"video: {args.video}")


if __name__ == "__main__":
    main()
