"""Live nodes in threads, and where the process is what a test is about as processes; and messages for them."""

import contextlib
import io
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import waiting
from built_in import STANCE

from quadruped_env import JOINT_NAMES, QuadrupedError
from quadruped_env.live.__main__ import make_parser
from quadruped_env.live.middleware.topics import IMU, JOINT_POSITIONS, JOINT_STATES, ODOMETRY
from quadruped_env.live.nodes import node_module
from quadruped_env.live.session import Session
from quadruped_env.ros import cdr

STAMP = 1_700_000_000_123_456_789
"""ns"""


class InThread(Session):
    """One node in a thread of this process, with its log."""

    def __init__(self, *arguments):
        self.arguments, self.text = make_parser(only=arguments[0]).parse_args(arguments), io.StringIO()
        super().__init__(arguments[0], self.arguments, self.text)
        self.returncode = None
        self.thread = threading.Thread(target=self._run)
        self.thread.start()

    def _run(self):
        try:
            with self:
                self.returncode = node_module(self.arguments.node).run(self, self.arguments)
        except QuadrupedError as error:
            self.say(f"error: {error}")
            self.returncode = 2
        except ZeroDivisionError:
            self.returncode = 1

    @property
    def said(self):
        """Its log so far."""
        return self.text.getvalue()

    def poll(self):
        """Its exit status, or None while it runs."""
        return self.returncode

    def status(self):
        """Wait for its end; returns its exit status."""
        self.thread.join(waiting.DEADLINE)
        return self.returncode

    def interrupt(self):
        """End it, as Ctrl-C does; returns its exit status."""
        self.stop()
        return self.status()


class Running:
    """One node: its process and its output."""

    def __init__(self, log, *arguments):
        self._log = log
        with log.open("w") as file:
            self.process = subprocess.Popen(
                [sys.executable, "-m", "quadruped_env.live", *arguments], stderr=file, stdout=file
            )

    @property
    def said(self):
        """Output of the process so far."""
        return self._log.read_text()

    def kill(self):
        """Kill it, as a crash would."""
        self.process.kill()
        self.process.wait()

    def interrupt(self):
        """Interrupt it, as Ctrl-C does; returns its exit status."""
        self.process.send_signal(signal.SIGINT)
        return self.status()

    def poll(self):
        """Its exit status, or None while it runs."""
        return self.process.poll()

    def status(self):
        """Wait for its end; returns its exit status."""
        return waiting.status_of(self.process)


@contextlib.contextmanager
def launcher(directory):
    """A function that starts nodes; at the end, stops those that still run and checks that none printed a traceback."""
    started = []

    def start(*arguments):
        started.append(Running(directory / f"{len(started)}-{arguments[0]}.log", *arguments))
        return started[-1]

    try:
        yield start
    finally:
        for node in started:
            if node.process.poll() is None:
                node.process.send_signal(signal.SIGCONT)
                node.interrupt()
    for node in started:
        assert "Traceback" not in node.said, node.said


def joint_state(stamp=STAMP, names=JOINT_NAMES, position=(0.1, -0.2) * 4, velocity=(), effort=()):
    return cdr.message(
        "sensor_msgs/msg/JointState",
        header=cdr.header(stamp),
        name=list(names),
        position=position,
        velocity=velocity,
        effort=effort,
    )


def received_from(subscription, count, alive=None):
    """Wait for `count` messages of a subscription; returns all that arrived, `count` or more."""
    received = []
    waiting.wait_until(
        lambda: received.extend(subscription.take()) or len(received) >= count, f"{count} messages", alive
    )
    return received


def usable(topic):
    """Bytes of a valid message with the current time."""
    now = time.time_ns()
    if topic.type_name == JOINT_STATES.type_name:
        return cdr.serialize(joint_state(now, JOINT_NAMES, STANCE, np.zeros(8), np.zeros(8)))
    fields = {
        IMU.name: {"header": cdr.header(now), "orientation": {"w": 1.0}},
        ODOMETRY.name: {"header": cdr.header(now), "pose": {"pose": {"orientation": {"w": 1.0}}}},
        JOINT_POSITIONS.name: {"data": STANCE},
    }
    return cdr.serialize(cdr.message(topic.type_name, **fields.get(topic.name, {})))


def started(*arguments, **settings):
    """Context manager of a node that runs as a process of its own."""
    process = subprocess.Popen(
        [sys.executable, "-m", "quadruped_env.live", *arguments],
        **({"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True} | settings),
    )
    return waiting.killed_on_failure(process)
