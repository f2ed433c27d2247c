"""Draw the README's picture: the shipped policy through one gait cycle."""

import argparse
import sys
from pathlib import Path

import numpy as np

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.evaluation.video import RolloutRenderer, write_png
from quadruped_env.policies import PolicyController, load_policy


def main() -> int:
    """Parse the arguments and draw."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--policy", default="flat", help="a run, or a shipped policy")
    parser.add_argument("--output", type=Path, default=Path("assets/pictures/walk.png"), help="where to write")
    args = parser.parse_args()
    try:
        rollout = roll_out(PolicyController(load_policy(args.policy)), [(0.5, 0.0)], [FIRST_SEED], 5.0)
        renderer = RolloutRenderer()
        frames = list(renderer.clip(rollout, 0, 3.0, 3.48))
        renderer.close()
        # Three moments of a cycle side by side, cropped to the robot.
        strip = np.concatenate([frame[120:420, 130:510] for frame in frames[::4][:3]], axis=1)
        args.output.parent.mkdir(parents=True, exist_ok=True)
        write_png(args.output, strip)
    except (QuadrupedError, MissingExtraError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print(f"written to {args.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
