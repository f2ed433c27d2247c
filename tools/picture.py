"""Render the README's animation: the policy that pages show, on stairs."""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)

# isort: split

from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.policies import PolicyController, load_policy
from quadruped_env.policies.files import SHOWN
from quadruped_env.report.films.film import Clip
from quadruped_env.report.films.video import prepare_video, save_film
from quadruped_env.utils.program import run_program
from quadruped_env.utils.progress import ProgressLine

START, STRIDES = 3.0, 6
"""Time after which the gait is steady, s, and number of strides in the loop."""


def main() -> int:
    """Parse the arguments and draw."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--policy", default=SHOWN, help="a run, or a shipped policy")
    parser.add_argument("--terrain", default="stairs", help="a built-in terrain")
    parser.add_argument("--velocity", type=float, default=0.4, metavar="M/S", help="commanded")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path("assets/pictures/walk.webp"), help="what to write, over"
    )
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    prepare_video(arguments.output, overwrite=True)
    policy = load_policy(arguments.policy)
    config = policy.config.on_terrain(arguments.terrain)
    stop = START + STRIDES / policy.config.clock_frequency
    rollout = roll_out(PolicyController(policy), [(arguments.velocity, 0.0)], [FIRST_SEED], stop, config)
    save_film(arguments.output, [Clip.of_rollout(rollout, 0, "trained policy", START)], ProgressLine("drawing"))
    print(f"written to {arguments.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
