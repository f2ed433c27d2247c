"""Put a trained run's policy into the package, with its metrics on its card.

After `mini-quadruped train`: tools/ship.py runs/latest
"""

import argparse
import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from benchmarks.shipping import ship
from quadruped_env.policies.files import SHIPPED
from quadruped_env.utils.program import run_program
from quadruped_env.utils.progress import ProgressLine


def main() -> int:
    """Parse the arguments and ship; fails where the policy does not pass the acceptance test."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", type=Path, nargs="?", default=Path("runs/latest"), help="a run (%(default)s)")
    parser.add_argument("--name", choices=SHIPPED, default=SHIPPED[0], help="what load_policy calls it (%(default)s)")
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    directory, card = ship(arguments.run, arguments.name, ProgressLine("measuring"))
    print(json.dumps({name: card[name] for name in ("acceptance", "disturbed", "metrics")}, indent=2))
    print(f"{card['verdict']}\nshipped: {directory}")
    return 0 if card["acceptance"]["accepted"] else 1


if __name__ == "__main__":
    sys.exit(main())
