"""Live benchmark: `sim` and `controller` as two processes, observed by a third one that sends a velocity command."""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final

import gymnasium
import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.joint_command import LIMP
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.live.messages.joint_messages import JointReader, read_target
from quadruped_env.live.middleware.dds import DOMAIN_VARIABLE, Network
from quadruped_env.live.middleware.node import Node
from quadruped_env.live.middleware.topics import CLOCK, CMD_VEL, JOINT_COMMANDS, JOINT_STATES, ODOMETRY
from quadruped_env.live.pace import Pace
from quadruped_env.policies import load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import Qos, cdr
from quadruped_env.ros.timestamps import NS_PER_SECOND, read_stamp
from quadruped_env.utils.files import write_whole

COMMAND_PERIOD: Final = 0.1
"""Time between messages on /cmd_vel, s."""
SETTLING: Final = 8.0
"""Time from the start of the processes to the first measurement, s: discovery, standing up and acceleration."""
_STARTS: Final = 10
"""Maximum number of waits of `SETTLING` for the first commands and odometry."""
ON_TIME: Final = 0.005
"""Maximum delay of a command after its tick that counts as on time, s."""
_LONG: Final = 600.0
"""Minimum duration for which the growth of memory is reported, s."""
_MEBIBYTE: Final = 2**20
_ENVIRONMENT_STEPS: Final = 1000
_CLOCKS: Final = 5
"""Messages of /clock per sample."""
_QUEUE_DEPTH: Final = 1000
"""Depth of the listener's queues: it reads rarely, to keep its load on the machine small."""


@dataclass(frozen=True)
class Sample:
    """State of the two processes at one time."""

    seconds: float
    """Time since the start of the measurement, s"""
    sim_memory: float
    """Resident memory of `sim`, MiB"""
    controller_memory: float
    """Resident memory of `controller`, MiB"""
    clock_lag: float
    """Lag of /clock behind the machine's clock on arrival, ms"""


@dataclass(frozen=True)
class Walk:
    """Result of the benchmark."""

    seconds: float
    realtime: bool
    commanded: float
    """Commanded forward velocity, m/s"""
    speed: float
    """Mean forward velocity of the base, m/s"""
    environment_speed: float
    """Mean forward velocity of the same policy in `MiniQuadruped-v0`, m/s"""
    fell: bool
    ticks: int
    """Number of control steps"""
    on_time: float
    """Fraction of ticks whose command was sent within `ON_TIME`"""
    latency_median: float
    """Median time from sending a state to sending the command that answers it, ms"""
    latency_99_9: float
    """99.9th percentile of that time, ms"""
    limp_commands: int
    """Number of commands that disable the motors"""
    clock_drift: float
    """Drift of the robot's clock relative to the machine's, ms/s"""
    memory_growth: float
    """Growth of the memory of both processes over the second half, MiB/hour"""
    samples: tuple[Sample, ...]

    @property
    def reached(self) -> bool:
        """True if all targets are reached. Memory growth is not checked, because it needs a long run."""
        return (
            abs(self.speed - self.environment_speed) <= 0.02
            and not self.fell
            and self.on_time >= 0.999
            and self.latency_median < 3.0
            and abs(self.clock_drift) <= 1.0
        )

    def __str__(self) -> str:
        grown = f"{self.memory_growth:+.2f} MiB/hour" if self.seconds >= _LONG else "takes a longer run"
        return "\n".join(
            (
                "| measure | value | to reach |",
                "|---|---|---|",
                f"| speed at {self.commanded:g} m/s commanded | {self.speed:.3f} m/s "
                f"| within 0.02 of the environment's {self.environment_speed:.3f} |",
                f"| fell, or was let go | {'yes' if self.fell or self.limp_commands else 'no'} | no |",
                f"| commands within {1e3 * ON_TIME:g} ms of their tick, of {self.ticks} | {self.on_time:.3%} | 99.9% |",
                f"| state to command, median | {self.latency_median:.2f} ms | under 3 ms |",
                f"| state to command, 99.9 % | {self.latency_99_9:.2f} ms | |",
                f"| drift of the robot's clock | {self.clock_drift:+.4f} ms/s | within 1 ms/s |",
                f"| growth of memory, second half | {grown} | flat, in an hour |",
            )
        )


def measure(
    seconds: float,
    policy: str = "flat",
    velocity: float = 0.5,
    realtime: bool = False,
    progress: Callable[[str], None] = lambda line: None,
) -> Walk:
    """Run `sim` and `controller`, and measure them.

    Args:
        seconds: duration of the measurement, s.
        policy: policy of the controller.
        velocity: forward velocity command, m/s.
        realtime: True to run both processes with real-time priority.
        progress: called with a line of text, at most once every 10 s.

    Raises:
        MissingExtraError: if cyclonedds or psutil is not installed.
        QuadrupedError: if one of the two ends before its time.
    """
    environment_speed = speed_in_environment(policy, velocity)
    network = Network.from_environment()
    node = Node("benchmark", network)
    options = ["--realtime"] * realtime
    try:
        with (
            process("sim", network, "--pick-up", "2", *options) as sim,
            process("controller", network, policy, *options) as controller,
        ):
            listener = _Listener(node, velocity)
            # On a busy machine the processes need more time for start-up and discovery.
            for _ in range(_STARTS):
                listener.listen(SETTLING, sim, controller, lambda line: None)
                if listener.hears:
                    break
            listener.begin()
            listener.listen(seconds, sim, controller, progress)
            return listener.result(seconds, environment_speed, realtime)
    finally:
        node.close()


@contextmanager
def process(name: str, network: Network, *arguments: str) -> Iterator["subprocess.Popen[str]"]:
    """Context manager that runs a node in a separate process."""
    environment = {**os.environ, DOMAIN_VARIABLE: str(network.domain_id)}
    with subprocess.Popen(  # noqa: S603
        [sys.executable, "-m", "quadruped_env.live", name, *arguments, "--quiet"],
        env=environment,
        stderr=subprocess.DEVNULL,
        encoding="utf-8",
    ) as started:
        try:
            yield started
        finally:
            started.send_signal(signal.SIGINT)


def speed_in_environment(policy: str, velocity: float) -> float:
    """Mean forward velocity in m/s of a policy in the environment, over the last 16 of 20 s."""
    loaded = load_policy(policy)
    env: Any = gymnasium.make("MiniQuadruped-v0", config=loaded.config.to_dict())
    observation, _ = env.reset(seed=0, options={"command": (velocity, 0.0)})
    speeds = []
    for _ in range(_ENVIRONMENT_STEPS):
        observation, _, _, _, info = env.step(loaded.predict(observation))
        speeds.append(info["base_linear_velocity"][0])
    env.close()
    return float(np.mean(speeds[_ENVIRONMENT_STEPS // 5 :]))


class _Listener:
    """Sends the velocity command and records the messages of both processes."""

    def __init__(self, node: Node, velocity: float) -> None:
        self._node = node
        self._velocity = velocity
        self._commands = node.subscribe(JOINT_COMMANDS, Qos(_QUEUE_DEPTH))
        self._states = node.subscribe(JOINT_STATES, Qos(_QUEUE_DEPTH))
        self._odometry = node.subscribe(ODOMETRY, Qos(_QUEUE_DEPTH))
        self._clock = node.subscribe(CLOCK)
        self._ask = node.publish(CMD_VEL)
        self._twist = cdr.message("geometry_msgs/msg/Twist")
        self._twist.linear.x = velocity
        self._read_state = JointReader(JOINT_STATES.name, MINI_QUADRUPED)
        self._read_command = JointReader(JOINT_COMMANDS.name, MINI_QUADRUPED)
        self.begin()

    def begin(self) -> None:
        """Discard all messages so far and start the measurement."""
        for one in (self._commands, self._states, self._odometry, self._clock):
            one.take()
        self._sent: dict[int, int] = {}
        """Timestamp of a state -> time at which it was sent, ns"""
        self._answers: list[tuple[int, int]] = []
        """Timestamp of the state that a command answers, and time at which the command was sent, ns"""
        self._limp = 0
        self._speeds: list[float] = []
        self._lowest = 1.0
        self._samples: list[Sample] = []

    @property
    def hears(self) -> bool:
        """True if commands and odometry have been received."""
        return bool(self._answers) and bool(self._speeds)

    def listen(
        self,
        seconds: float,
        sim: "subprocess.Popen[str]",
        controller: "subprocess.Popen[str]",
        progress: Callable[[str], None],
    ) -> None:
        """Record messages for some time."""
        start = time.monotonic()
        ask, look = Pace(COMMAND_PERIOD), Pace(min(10.0, seconds / 20))
        while time.monotonic() - start < seconds:
            time.sleep(max(0.0, ask.remaining))
            if ask.tick():
                self._ask.send(self._twist)
                self._collect()
            if look.tick() and self._speeds:
                for name, running in (("sim", sim), ("controller", controller)):
                    if running.poll() is not None:
                        raise QuadrupedError(
                            f"{name} ended with status {running.returncode}; start it alone to see why"
                        )
                self._look(time.monotonic() - start, sim.pid, controller.pid, progress)

    def result(self, seconds: float, environment_speed: float, realtime: bool) -> Walk:
        """Result of the measurement since `begin`."""
        if not self._answers or not self._speeds:
            raise QuadrupedError("no commands or no odometry came; start sim and controller alone to see why")
        stamps, sent = np.array(self._answers).T
        latencies = np.array([at - self._sent[stamp] for stamp, at in self._answers if stamp in self._sent]) / 1e6
        policy_period = round(np.median(np.diff(np.unique(stamps))))
        ticks = round((stamps.max() - stamps.min()) / policy_period) + 1
        late = (sent - stamps) / NS_PER_SECOND
        met = len(np.unique(stamps[late <= ON_TIME]))
        lags = np.array([[sample.seconds, sample.clock_lag] for sample in self._samples])
        half = [sample for sample in self._samples if sample.seconds >= seconds / 2]
        memory = np.array([[s.seconds / 3600, s.sim_memory + s.controller_memory] for s in half])
        return Walk(
            seconds=seconds,
            realtime=realtime,
            commanded=self._velocity,
            speed=float(np.mean(self._speeds)),
            environment_speed=environment_speed,
            fell=self._lowest < 0.5,
            ticks=ticks,
            on_time=min(1.0, met / ticks),
            latency_median=float(np.median(latencies)),
            latency_99_9=float(np.percentile(latencies, 99.9)),
            limp_commands=self._limp,
            clock_drift=_slope(*lags.T),
            memory_growth=_slope(*memory.T),
            samples=tuple(self._samples),
        )

    def _collect(self) -> None:
        for one in self._states.take():
            self._sent[self._read_state(one.data).stamp] = one.sent
        for one in self._commands.take():
            joints = self._read_command(one.data)
            self._answers.append((joints.stamp, one.sent))
            self._limp += read_target(joints) is LIMP
        for one in self._odometry.take():
            odometry = self._odometry.decode(one)
            self._speeds.append(odometry.twist.twist.linear.x)
            turn = odometry.pose.pose.orientation
            self._lowest = min(self._lowest, 1.0 - 2.0 * (turn.x**2 + turn.y**2))

    def _look(self, seconds: float, sim: int, controller: int, progress: Callable[[str], None]) -> None:
        # The minimum of a few lags: the others waited for a CPU.
        lags = []
        for _ in range(_CLOCKS):
            self._node.wait(0.02)
            if taken := self._clock.take():
                received = taken[-1]
                lags.append((received.sent - read_stamp(self._clock.decode(received).clock)) / 1e6)
        sample = Sample(seconds, _memory(sim), _memory(controller), min(lags, default=float("nan")))
        if np.isfinite(sample.clock_lag):
            self._samples.append(sample)
        progress(
            f"{seconds:.0f} s: {np.mean(self._speeds[-1000:]):.3f} m/s, sim {sample.sim_memory:.1f} MiB, "
            f"controller {sample.controller_memory:.1f} MiB, clock {sample.clock_lag:.2f} ms behind"
        )


def _slope(x: NDArray[np.float64], y: NDArray[np.float64]) -> float:
    """Slope of the least-squares line through points (N,)."""
    x = x - x.mean()
    return float(x @ y / (x @ x)) if x.any() else 0.0


def _memory(process_id: int) -> float:
    try:
        import psutil
    except ImportError as error:
        raise MissingExtraError("measuring memory", "dev") from error
    return float(psutil.Process(process_id).memory_info().rss / _MEBIBYTE)


def write(walk: Walk, machine: str, versions: dict[str, str], path: Path) -> None:
    """Write the result as JSON.

    Raises:
        QuadrupedError: if it cannot be written.
    """
    document = {"machine": machine, "versions": versions, **asdict(walk)}
    write_whole({path: (json.dumps(document, indent=2) + "\n").encode()})
