"""Render the README's moving picture: the shipped policy, walking."""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.policies import PolicyController, load_policy
from quadruped_env.reporting.films.film import Motion
from quadruped_env.reporting.films.video import prepare_video, save_film

START, STRIDES = 3.0, 6
"""Time until the gait is periodic, s; strides of the loop."""


def main() -> int:
    """Parse the arguments and render."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.ArgumentDefaultsHelpFormatter
    )
    parser.add_argument("--policy", default="flat", help="a run, or a shipped policy")
    parser.add_argument("--velocity", type=float, default=0.5, metavar="M/S", help="velocity command")
    parser.add_argument(
        "--output", type=Path, default=Path("assets/pictures/walk.webp"), help="output file (overwritten)"
    )
    args = parser.parse_args()
    try:
        prepare_video(args.output, overwrite=True)
        policy = load_policy(args.policy)
        stop = START + STRIDES / policy.config.clock_frequency
        rollout = roll_out(PolicyController(policy), [(args.velocity, 0.0)], [FIRST_SEED], stop, policy.config)
        save_film(args.output, [Motion.of_rollout(rollout, 0, "trained policy", START)], ProgressLine("drawing"))
    except (QuadrupedError, MissingExtraError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print(f"written to {args.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
