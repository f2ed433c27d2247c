"""Put a trained run's policy into the package, with its metrics on its card.

python train/ppo.py && python evaluate/ship.py runs/latest
"""

import argparse
import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.cli.options import plain_warnings
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.control.policy import SHIPPED
from quadruped_env.evaluation.shipping import ship


def main() -> int:
    """Parse the arguments and ship; fails where the policy does not pass the acceptance test."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("run", type=Path, nargs="?", default=Path("runs/latest"), help="a run (%(default)s)")
    parser.add_argument("--name", choices=SHIPPED, default=SHIPPED[0], help="its name for load_policy (%(default)s)")
    args = parser.parse_args()
    try:
        with plain_warnings("ship.py"):
            directory, card = ship(args.run, args.name, ProgressLine("measuring"))
    except QuadrupedError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print(json.dumps({"acceptance": card["acceptance"], "metrics": card["metrics"]}, indent=2))
    print(f"{card['verdict']}\nshipped: {directory}")
    return 0 if card["acceptance"]["accepted"] else 1


if __name__ == "__main__":
    sys.exit(main())
