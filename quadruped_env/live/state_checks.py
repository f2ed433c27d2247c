"""Content of measurements: an IMU that repeats itself, two publishers of one joint, joints that freeze."""

import time
from collections.abc import Callable, Sequence
from typing import Final

import numpy as np

from quadruped_env.control.joint_command import LIMP, Target
from quadruped_env.live.messages.imu_messages import Imu
from quadruped_env.live.middleware.node import Received
from quadruped_env.live.middleware.ros_graph import Graph
from quadruped_env.live.middleware.topics import Topic
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.utils.arrays import Floats

_REPEATS: Final = 0.2, 5
"""Time, s, and messages for which an IMU may repeat itself bit for bit, which the noise of a working one prevents."""
_AT_REST: Final = 0.01
"""Motion of joints and targets up to which it may go on: a simulated robot can rest exactly, rad."""
_SOURCE_TIMEOUT: Final = 0.5
"""Time after its last message for which a publisher remains the source of a joint, s."""
_PERIOD: Final = 1.0
"""Time over which positions are compared, and for which two publishers of a joint are reported, s."""
_MIN_ROWS, _MAX_ROWS = 20, 1000
"""Number of positions below which nothing is said, and above which a period ends early."""
_TARGET_MOTION, _MOTION = 0.1, 0.05
"""Motion of a joint's target, and of most joints, with which it cannot stay at exactly one position, rad."""
_SHOWN_FOR: Final = 10.0
"""Time after which a problem that lasts is logged again, s."""


class ImuRepetition:
    """Tells an IMU that has stopped measuring, and goes on with fresh timestamps, from one at rest."""

    def __init__(self) -> None:
        self.frozen = False
        """True from when it has repeated itself while the robot moved or was moved, until it sends other numbers."""
        self._content = b""
        self._since, self._count = 0, 0
        self._before: Floats | None = None

    def add(self, imu: Imu, joints: Floats) -> None:
        """Take a message, and what must not change while the IMU does not: positions and targets, rad (N,), or NaN."""
        if imu.content != self._content or self._before is None:
            self._content, self._since, self._count = imu.content, imu.stamp, 0
            self._before, self.frozen = joints.copy(), False
            return
        if np.isnan(self._before).any():
            self._before = joints.copy()
        self._count += 1
        long = imu.stamp - self._since >= _REPEATS[0] * NS_PER_SECOND and self._count >= _REPEATS[1]
        self.frozen |= long and float(np.abs(joints - self._before).max(initial=0.0)) > _AT_REST


class Sources:
    """Publishers of one topic: each part of the robot has one.

    Args:
        graph: names of the publishers.
        topic: the topic.
        parts: names of the parts, such as joints.
    """

    def __init__(self, graph: Graph, topic: Topic, parts: Sequence[str]) -> None:
        self._graph, self._topic, self._parts = graph, topic, parts
        self._known: dict[int, tuple[int, float]] = {}
        """Part -> its publisher, and the `time.monotonic` of that one's last message, s."""
        self._problem, self._problem_at = "", 0.0

    def refusal(self, received: Received, parts: Sequence[int]) -> str:
        """Return why a message with these parts is refused: another publisher sends one of them; or an empty text."""
        for part in parts:
            writer, heard = self._known.get(part, (received.writer, 0.0))
            if writer != received.writer and received.taken - heard <= _SOURCE_TIMEOUT:
                self._problem_at = received.taken
                self._problem = (
                    f"{self._topic.name}: {self._owner(received.writer)} sends {self._parts[part]} too, which comes "
                    f"from {self._owner(writer)}; the second is refused: end one of the two"
                )
                return self._problem
        self._known.update(dict.fromkeys(parts, (received.writer, received.taken)))
        return ""

    @property
    def problem(self) -> str:
        """The reason of the last second; empty if there is none."""
        return self._problem if time.monotonic() - self._problem_at < _PERIOD else ""

    def _owner(self, writer: int) -> str:
        found = (one for one in self._graph.endpoints(self._topic.name) if one.handle == writer)
        return next(map(self._graph.owner, found), "a publisher that has left")


class FrozenJoints:
    """Names joints that stay at exactly one position while their targets, or most other joints, move.

    Args:
        names: of the joints (J,).
        say: called with one line for each such joint, and again while it lasts.
    """

    def __init__(self, names: tuple[str, ...], say: Callable[[str], None]) -> None:
        self.problems: tuple[str, ...] = ()
        """Problems in the last whole period of the check."""
        self.positions = np.full(len(names), np.nan)
        """The last positions, rad (J,); NaN before the first."""
        self._target: Floats | None = None
        self._names, self._say = names, say
        self._rows: list[tuple[Floats, Floats]] = []
        """Positions and targets since the begin of the period."""
        self._begin = 0
        """Timestamp of the first of them, ns."""
        self._said: dict[int, float] = {}
        """Joint -> `time.monotonic` at which it was named last, s."""

    def commanded(self, target: Target) -> None:
        """Take the targets (J,) that were sent. `LIMP` pauses the check: a simulator may put the robot anywhere."""
        if target is LIMP:
            self._rows.clear()
            self.problems = ()
        self._target = None if target is LIMP else target

    @property
    def moved(self) -> Floats:
        """Positions and targets (2 J,), rad; targets equal the positions while there are none."""
        return np.concatenate([self.positions, self.positions if self._target is None else self._target])

    def add(self, stamp: int, positions: Floats) -> None:
        """Take the positions (J,) of a state with a timestamp in ns."""
        self.positions = positions.copy()
        if self._target is None:
            return
        if not self._rows:
            self._begin = stamp
        self._rows.append((self.positions, self._target))
        if 0 <= stamp - self._begin < _PERIOD * NS_PER_SECOND and len(self._rows) < _MAX_ROWS:
            return
        enough = len(self._rows) >= _MIN_ROWS
        motion, target_motion = np.ptp(np.array(self._rows), axis=0)
        commanded = target_motion > _TARGET_MOTION
        others = np.count_nonzero(motion > _MOTION) >= len(self._names) / 2
        frozen = np.flatnonzero((motion == 0.0) & (commanded | others)).tolist() if enough else []
        self._rows.clear()
        texts = {
            joint: f"{self._names[joint]} stays at exactly {positions[joint]:.4g} rad for {_PERIOD:g} s while "
            f"{'its target moves' if commanded[joint] else 'other joints move'}; check its encoder and motor"
            for joint in frozen
        }
        self.problems, now = tuple(texts.values()), time.monotonic()
        for joint, text in texts.items():
            if now - self._said.get(joint, -_SHOWN_FOR) >= _SHOWN_FOR:
                self._said[joint] = now
                self._say(text)
