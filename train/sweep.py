"""Train many policies at once on Ray Tune: `mini-quadruped sweep`, from a checkout."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # so that a Python without the package finds it, and prints a fix

from quadruped_env.cli.commands import run_script

if __name__ == "__main__":
    sys.exit(run_script("sweep"))
