"""Play a recorded joint trajectory again, and say how closely the robot followed it.

FILE is a CSV of joint states, as evaluate/baseline.py writes it: a header line, then stamp_ns and the position.<joint>
columns (rad) of all eight joints; velocity.<joint> and effort.<joint> may be there and do not matter here.

    kinematic   sets the joints to the recorded positions: no forces, no ground, no errors. Link poses are in the
                frame of base_link.
    dynamic     makes them the targets of the motors, with gravity and ground. The robot starts at rest in its stance,
                facing along x, and has no randomness, so it does the same every time; commands that baseline.py wrote
                repeat its recording to the last bit. Link poses are in the world.

Results: link_poses.csv (x, y, z in m and quaternion w, x, y, z of every link over time), tracking.json (what this
program prints, as data), and in dynamic mode joint_states.csv (the joints as measured). A tracking error is the played
position minus the recorded one at the same time, the start included.
"""

import argparse
import sys
from pathlib import Path

from quadruped_env import JointTrajectory, MissingExtraError, QuadrupedError
from quadruped_env.evaluation.options import add_video_option
from quadruped_env.evaluation.progress import ProgressLine
from quadruped_env.evaluation.replay import MODES, replay, replay_files
from quadruped_env.evaluation.results import check_free, free_path
from quadruped_env.evaluation.video import prepare_video, save_film


def main() -> None:
    """Run the program."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=Path, metavar="FILE", help="a CSV of joint states")
    parser.add_argument("--mode", choices=MODES, default="dynamic", help="default: dynamic")
    parser.add_argument(
        "--clip",
        action="store_true",
        help="move positions outside the joint limits to the limit; without it they are an error",
    )
    parser.add_argument(
        "--out",
        type=Path,
        metavar="DIRECTORY",
        help="where to write; default: results/replay-FILE, or the next free number behind that name",
    )
    add_video_option(parser)
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")
    args = parser.parse_args()

    out = args.out or free_path(Path("results") / f"replay-{args.file.stem}")
    try:
        check_free(replay_files(out), args.overwrite)
        prepare_video(args.video, args.overwrite)
        result = replay(JointTrajectory.load(args.file), args.mode, args.clip, ProgressLine("playing"))
        result.save(out, args.overwrite, ProgressLine("writing"))
        if args.video:
            save_film(args.video, [result.film()], ProgressLine("filming"))
    except (QuadrupedError, MissingExtraError) as error:
        sys.exit(f"replay.py: {error}")
    print(result.table())
    print(f"\nlink poses, {'joints and ' if args.mode == 'dynamic' else ''}tracking errors: {out}")
    if args.video:
        print(f"video: {args.video}")


if __name__ == "__main__":
    main()
