"""`python -m quadruped_env` is the command `mini-quadruped`."""

import sys

from quadruped_env.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
