"""The real ROS 2 that tests meet: the distributions that `make ros2` installs, and how their programs are started."""

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent.parent / ".ros2"
DISTRIBUTIONS = ("kilted", "jazzy")


class Ros2:
    """One distribution.

    Args:
        name: one of `DISTRIBUTIONS`; the test skips if it is not installed.
    """

    def __init__(self, name):
        self.name = name
        self.prefix = ROOT / name
        if not (self.prefix / ".installed").exists():
            pytest.skip(f"no ROS 2 {name.capitalize()}: make ros2")
        self.python = self.prefix / "bin" / "python"

    def environment(self, **more):
        """Environment variables of its programs; the domain is that of this process (fixture `domain_id`).

        The wheels' Python finds its libraries itself.
        """
        foreign = (
            "PYTHONPATH",
            "PYTHONHOME",
            "LD_LIBRARY_PATH",
            "RMW_IMPLEMENTATION",
            "_ROS_WHEELS_BOOTSTRAP_COMPLETE",
        )
        own = {name: value for name, value in os.environ.items() if name not in foreign}
        return own | {
            "AMENT_PREFIX_PATH": str(self.prefix),
            "PYTHONNOUSERSITE": "1",
            "PYTHONUNBUFFERED": "1",
            "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
            **more,
        }

    def start(self, program, *arguments, **settings):
        """A Python program in this distribution, as a process whose output is a pipe."""
        command = [self.python, program, *map(str, arguments)]
        pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
        return subprocess.Popen(command, **(pipes | {"env": self.environment()} | settings))

    def share(self, package):
        """The directory of what a package installs, or None without the package."""
        directory = self.prefix / "share" / package
        return directory if directory.is_dir() else None


def colcon():
    """The program `colcon` that `make ros2` installs; the test skips without it."""
    if not (ROOT / "colcon" / ".installed").exists():
        pytest.skip("no colcon: make ros2")
    return ROOT / "colcon" / "bin" / "colcon"
