"""Train many policies at once: `mini-quadruped sweep`, from a checkout."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

from quadruped_env.cli.main import main

if __name__ == "__main__":
    sys.exit(main(["sweep", *sys.argv[1:]]))
