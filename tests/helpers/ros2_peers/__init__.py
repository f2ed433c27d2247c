"""Real ROS 2 distributions for tests, as `make ros2` installs them, and processes that run in them."""

import contextlib
import json
import os
import subprocess
import threading
from dataclasses import asdict
from pathlib import Path

import pytest
from paths import ROOT
from waiting import status_of, wait_until

INSTALLED = ROOT / ".ros2"
DISTRIBUTIONS = ("kilted", "jazzy")
PEER = Path(__file__).parent / "peer.py"
_FOREIGN = ("PYTHONPATH", "PYTHONHOME", "LD_LIBRARY_PATH", "RMW_IMPLEMENTATION", "_ROS_WHEELS_BOOTSTRAP_COMPLETE")


class Ros2:
    """One ROS 2 distribution.

    Args:
        name: one of `DISTRIBUTIONS`; the test skips if it is not installed.
    """

    def __init__(self, name):
        self.name = name
        self.prefix = INSTALLED / name
        if not (self.prefix / ".installed").exists():
            pytest.skip(f"no ROS 2 {name.capitalize()}: make ros2")
        self.python = self.prefix / "bin" / "python"

    def environment(self, **more):
        """Environment variables of its programs; the domain is this process's (fixture `domain_id`).

        The wheels' Python finds its libraries itself.
        """
        own = {name: value for name, value in os.environ.items() if name not in _FOREIGN}
        return own | {
            "AMENT_PREFIX_PATH": str(self.prefix),
            # No shared memory, which only Fast DDS has: segments left by another release of it can crash a process.
            "FASTDDS_BUILTIN_TRANSPORTS": "UDPv4",
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
        """The share directory of a package, or None if the package is not installed."""
        directory = self.prefix / "share" / package
        return directory if directory.is_dir() else None

    @contextlib.contextmanager
    def node(self, name="peer", **environment):
        """An rclpy node, see `peer.py`; fails the test if it prints anything but answers, such as ROS 2's log."""
        with self.start(PEER, name, env=self.environment(**environment)) as process:
            node = RosNode(process)
            try:
                wait_until(lambda: node.said("ready"), node.state, process)
                yield node
            finally:
                process.stdin.close()
                status = status_of(process)
                node.reader.join()
        assert (status, [line for line in node.log if "localhost_only" not in line.lower()]) == (0, [])


class RosNode:
    """An rclpy node in a process of its own."""

    def __init__(self, process):
        self.process = process
        self.lines = []
        """Answers, in the order in which they came."""
        self.log = []
        """Other lines that it printed."""
        self.reader = threading.Thread(target=self._read, daemon=True)
        self.reader.start()

    def _read(self):
        for line in self.process.stdout:
            if line.startswith("{"):
                self.lines.append(json.loads(line))
            else:
                self.log.append(line)

    def ask(self, **line):
        """Send it one line."""
        self.process.stdin.write(json.dumps(line) + "\n")
        self.process.stdin.flush()

    def subscribe(self, topic, qos=None):
        """Let it subscribe to a `Topic`."""
        self.ask(subscribe=topic.name, type=topic.type_name, qos=asdict(qos or topic.qos))

    def publish(self, topic, qos=None):
        """Let it publish a `Topic`."""
        self.ask(publish=topic.name, type=topic.type_name, qos=asdict(qos or topic.qos))

    def said(self, kind, topic=None):
        """Its answers of one kind, of every topic or of one."""
        return [one for one in list(self.lines) if kind in one and topic in (None, one[kind])]

    def received(self, topic):
        """The messages that it received on a topic, as dicts."""
        return [one["message"] for one in self.said("received", topic.name)]

    def matched(self, topic):
        """Number of endpoints of other nodes that its own endpoint of a topic is matched with now."""
        counts = self.said("matched", topic.name)
        return counts[-1]["count"] if counts else 0

    def state(self):
        """Its last answers and its log, for the message of a failed test."""
        return f"{self.lines[-5:]} {self.log}"


def colcon():
    """The program `colcon` that `make ros2` installs; the test skips without it."""
    if not (INSTALLED / "colcon" / ".installed").exists():
        pytest.skip("no colcon: make ros2")
    return INSTALLED / "colcon" / "bin" / "colcon"
