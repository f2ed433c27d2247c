"""Content of measurements: an IMU that repeats itself, two publishers of one joint, joints that freeze or jump.

The checks of positions and velocities are those of recordings (`trajectory.plausibility`), over the last two seconds.
"""

import re
import time
from collections import deque
from collections.abc import Callable, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.joint_command import LIMP, Target
from quadruped_env.live.messages.imu_messages import Imu
from quadruped_env.live.messages.joint_messages import Joints
from quadruped_env.live.middleware.node import Received
from quadruped_env.live.middleware.ros_graph import Graph
from quadruped_env.live.middleware.topics import Topic
from quadruped_env.live.pace import Pace
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.plausibility import findings
from quadruped_env.trajectory.rows import Rows

_REPEATS: Final = 0.2, 5
"""Time, s, and messages for which an IMU may repeat itself bit for bit, which the noise of a working one prevents."""
_AT_REST: Final = 0.01
"""Motion of joints and targets up to which it may go on: a simulated robot can rest exactly, rad."""
_SOURCE_TIMEOUT: Final = 0.5
"""Time after its last message for which a publisher remains the source of a joint, s."""
_STILL: Final = 1.0
"""Time without any motion after which a joint that has to move is named, s."""
_WINDOW: Final = 2.0
"""Time over which positions are checked, s."""
_MAX_ROWS: Final = 400
_MIN_ROWS: Final = 20
_PERIOD: Final = 1.0
"""Time between checks, s."""
_TARGET_MOTION, _MOTION = 0.1, 0.05
"""Motion of a joint's target, and of most joints, with which it cannot stay at exactly one position, rad."""
_SHOWN_FOR: Final = 10.0
"""Time after which a problem that lasts is logged again, s."""
_PLACE: Final = re.compile(r",? (first )?at [\d.]+ s \(state \d+\)")
"""Place of a finding, which says nothing in a stream."""


class ImuRepetition:
    """Tells an IMU that has stopped measuring, and goes on with fresh timestamps, from one at rest."""

    def __init__(self) -> None:
        self.frozen = False
        """True from when it has repeated itself while the robot moved or was moved, until it sends other numbers."""
        self._content = b""
        self._since, self._count = 0, 0
        self._before: NDArray[np.float64] | None = None

    def add(self, imu: Imu, joints: NDArray[np.float64]) -> None:
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
        """Reason to refuse a message with these parts: another publisher sends one of them; empty if none does."""
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


class JointChecks:
    """Checks the positions and velocities of a robot that is being moved.

    Args:
        names: of the joints (J,).
        say: called with one line for each problem, and again while it lasts.
    """

    def __init__(self, names: tuple[str, ...], say: Callable[[str], None]) -> None:
        self.problems: tuple[str, ...] = ()
        """Problems in the last two seconds."""
        self.positions = np.full(len(names), np.nan)
        """The last positions, rad (J,); NaN before the first."""
        self._target: NDArray[np.float64] | None = None
        self._names, self._say = names, say
        self._rows: deque[tuple[int, NDArray[np.float64], NDArray[np.float64] | None, NDArray[np.float64]]] = deque(
            maxlen=_MAX_ROWS
        )
        self._pace = Pace(_PERIOD)
        self._said: dict[tuple[str, ...], float] = {}

    def commanded(self, target: Target) -> None:
        """Take the targets (J,) that were sent. `LIMP` pauses the checks: a simulator may put the robot anywhere."""
        if target is LIMP:
            self._rows.clear()
            self.problems = ()
        self._target = None if target is LIMP else target

    @property
    def moved(self) -> NDArray[np.float64]:
        """Positions and targets (2 J,), rad; targets equal the positions while there are none."""
        return np.concatenate([self.positions, self.positions if self._target is None else self._target])

    def add(self, joints: Joints, measured_velocities: bool) -> None:
        """Take a state; velocities that were computed from its positions say nothing about them."""
        assert joints.positions is not None
        self.positions = joints.positions.copy()
        if self._target is None:
            return
        velocities = joints.velocities if measured_velocities else None
        self._rows.append((joints.stamp, self.positions, velocities, self._target))
        while self._rows[-1][0] - self._rows[0][0] > _WINDOW * NS_PER_SECOND:
            self._rows.popleft()
        if self._pace.tick():
            found = [*self._still(), *self._implausible()] if len(self._rows) >= _MIN_ROWS else []
            self.problems = tuple(text for _, text in found)
            now = time.monotonic()
            for key, text in found:
                if now - self._said.get(key, -_SHOWN_FOR) >= _SHOWN_FOR:
                    self._said[key] = now
                    self._say(f"implausible states: {text}")

    def _still(self) -> list[tuple[tuple[str, ...], str]]:
        """Joints that do not move by a single bit though they have to."""
        begin = self._rows[-1][0] - round(_STILL * NS_PER_SECOND)
        if self._rows[0][0] > begin:
            return []
        rows = [row for row in self._rows if row[0] >= begin]
        positions, targets = np.array([row[1] for row in rows]), np.array([row[3] for row in rows])
        told = np.ptp(targets, axis=0) > _TARGET_MOTION
        others = np.count_nonzero(np.ptp(positions, axis=0) > _MOTION) >= len(self._names) / 2
        still = np.flatnonzero((np.ptp(positions, axis=0) == 0.0) & (told | others))
        return [
            (
                ("still", self._names[joint]),
                f"{self._names[joint]} stays at exactly {positions[-1, joint]:.4g} rad for {_STILL:g} s while "
                f"{'its target moves' if told[joint] else 'other joints move'}; check its encoder and its motor",
            )
            for joint in still
        ]

    def _implausible(self) -> list[tuple[tuple[str, ...], str]]:
        """Findings of the checks of recordings."""
        stamps, positions, velocities, _ = zip(*self._rows, strict=True)
        values = {"position": np.array(positions)}
        if all(one is not None and np.isfinite(one).all() for one in velocities):
            values["velocity"] = np.array(velocities)
        rows = Rows(np.arange(len(stamps)), np.array(stamps), self._names, values)
        return [
            ((one.kind, *one.joints), _PLACE.sub("", one.text).partition(";")[0]) for one in findings(rows, "state")
        ]
