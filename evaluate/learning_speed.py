"""Measure how long it takes to learn to walk: runs tools/learning_speed.py, a tool for maintainers."""

import runpy
import sys
from pathlib import Path

TOOLS = Path(__file__).parents[1] / "tools"

if __name__ == "__main__":
    sys.path[0] = str(TOOLS)  # as if it had been started there
    runpy.run_path(str(TOOLS / "learning_speed.py"), run_name="__main__")
