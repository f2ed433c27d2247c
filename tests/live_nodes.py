"""What tests of live nodes share."""

import subprocess
import sys
import time

from quadruped_env import JOINT_NAMES
from quadruped_env.ros import cdr

STAMP = 1_700_000_000_123_456_789
"""ns"""


def wait_until(condition, seconds=10.0):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "what the test waits for did not come"
        time.sleep(0.005)


def joint_state(stamp=STAMP, names=JOINT_NAMES, position=(0.1, -0.2) * 4, velocity=(), effort=()):
    return cdr.message(
        "sensor_msgs/msg/JointState",
        header=cdr.header(stamp),
        name=list(names),
        position=position,
        velocity=velocity,
        effort=effort,
    )


def started(*arguments, **settings):
    """A node that runs as a program of its own."""
    return subprocess.Popen(
        [sys.executable, "-m", "quadruped_env.live", *arguments],
        **({"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True} | settings),
    )
