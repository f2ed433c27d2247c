"""Paths of the repository and of data outside it."""

import os
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
TESTS = ROOT / "tests"
_SHARED = next((place for place in (ROOT / "shared", ROOT.parent / "shared") if place.is_dir()), ROOT / "shared")
DYNA1 = _SHARED / "data" / "dyna1"
"""Recordings of a real robot; tests that need them skip where they are absent."""
ROBOTS = _SHARED / "data" / "robots"
"""Published robot descriptions; tests that need them skip where they are absent."""


def importing():
    """Environment variables with which another process imports the same modules as this one."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
