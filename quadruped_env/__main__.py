"""`python -m quadruped_env` is the command `mini-quadruped`, and so is `python path/to/quadruped_env`."""

import sys

if not __package__:
    from pathlib import Path

    sys.path[0] = str(Path(__file__).resolve().parents[1])  # instead of the package's own directory

from quadruped_env.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
