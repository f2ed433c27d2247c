"""Joint states and joint commands, validated and in the joint order of the robot or its driver."""

import itertools
import statistics
from collections import deque
from collections.abc import Callable, Sequence
from typing import Final, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.joint_command import LIMP, MAX_MEASURED, Target
from quadruped_env.control.timestamp_filter import MAX_AGE
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.live.middleware.topics import JOINT_STATES
from quadruped_env.ros.robot_messages import RawJointState, joint_state, read_joint_state
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.utils.arrays import Floats

_REMEMBERED: Final = 16
"""Number of lists of names whose order is remembered."""
_SHOWN: Final = 4
"""Number of names shown in a message."""
_VELOCITY_FILTER: Final = 0.01
"""Time constant of the filter of computed velocities, half a control step, s."""
_STAMPS: Final = 10
"""Number of steps between timestamps from which a period is computed, and the least for a rate."""
_RATE_STAMPS: Final = 50
"""Number of timestamps from which a rate is computed."""
_PERIODS: Final = 1.5
_MIN_TOLERANCE: Final = 0.02
"""A control step: faster streams are paired within it, since their transport may take longer than their period, s."""


class Jointed(Protocol):
    """A robot, or its driver, whose messages may name other joints (`DriverJoints`)."""

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Names of the joints (J,)."""
        ...


class Joints(NamedTuple):
    """One message in the order of the robot's joints; a field that the message leaves out is `None`."""

    stamp: int
    """Timestamp, ns."""
    positions: Floats | None
    """Joint positions (J,), rad; NaN for joints that are not in the message."""
    velocities: Floats | None
    """Joint velocities (J,), rad/s; NaN means unknown."""
    efforts: Floats | None
    """Joint torques (J,), N m; NaN means unknown."""
    others: tuple[str, ...] = ()
    """Names in the message that are not joints of the robot."""


class JointReader:
    """Reads the messages of one topic.

    Args:
        robot: robot whose joints the messages contain, or its driver, whose `limits` take the place of `MAX_MEASURED`.
        states: True for measured states: a message may hold some of the robot's joints and other joints, velocities
            may be NaN, and positions and a timestamp are needed. False for commands, which name each joint once.
    """

    def __init__(self, robot: Jointed, states: bool = False) -> None:
        self._joints = robot.joint_names
        self._states = states
        limits = {"position": MAX_MEASURED, "velocity": MAX_MEASURED, **getattr(robot, "limits", {})}
        self._limits = {kind: np.broadcast_to(limit, len(self._joints)) for kind, limit in limits.items()}
        self._columns: dict[tuple[str, ...], _Columns] = {}

    def __call__(self, data: bytes) -> Joints:
        """Decode the CDR bytes of a JointState.

        Raises:
            QuadrupedError: if the bytes are corrupt, the names do not fit the robot, the numbers of values and names
                differ, a position or velocity is invalid or over its limit, or positions or timestamp are missing.
        """
        raw = read_joint_state(data)
        columns = self._columns.get(raw.names)
        if columns is None:
            if len(self._columns) >= _REMEMBERED:
                self._columns.clear()
            columns = self._columns[raw.names] = _columns(raw.names, self._joints, whole=not self._states)
        if self._states and raw.names and not len(columns.joints):
            return Joints(raw.stamp, np.full(len(self._joints), np.nan), None, None, columns.others)
        joints = Joints(
            raw.stamp,
            self._values(raw, "position", columns),
            self._values(raw, "velocity", columns, nan=self._states),
            self._values(raw, "effort", columns),
            columns.others,
        )
        if self._states and joints.positions is None:
            raise QuadrupedError("holds no positions; send one per joint (servos that report none: their last targets)")
        if self._states and raw.stamp == 0:
            raise QuadrupedError("the timestamp is empty; have the publisher fill header.stamp")
        return joints

    def _values(self, raw: RawJointState, field: str, columns: "_Columns", nan: bool = False) -> Floats | None:
        given = getattr(raw, field)
        if not len(given):
            return None
        if len(given) != len(raw.names):
            raise QuadrupedError(f"{field} holds {len(given)} values for {len(raw.names)} names; send one per joint")
        values = np.full(len(self._joints), np.nan)
        values[columns.joints] = found = given[columns.places]
        if field not in self._limits:
            return values
        limits = self._limits[field]
        invalid = ~(np.abs(found) <= limits[columns.joints]) & ~(np.isnan(found) & nan)
        if invalid.any():
            joint = columns.joints[np.flatnonzero(invalid)[0]]
            raise QuadrupedError(
                f"{field} of {self._joints[joint]} is {values[joint]}; send finite numbers of at most {limits[joint]:g}"
            )
        return values


class JointMerger:
    """Merges messages that each hold some of the robot's joints into states, and computes velocities that are missing.

    A state is complete when every joint has been measured since the last one. Its timestamp is the newest of its
    joints; the oldest may be older by the tolerance of `Period`.

    Args:
        robot: the robot, or its driver.
        velocities: True if states need velocities: missing ones are then the differences of positions, filtered.
        say: called with one line when velocities are computed for the first time.
        rates: velocity of each joint, in its unit, per unit of position and second (J,).
    """

    def __init__(
        self,
        robot: Jointed,
        velocities: bool,
        say: Callable[[str], None] = lambda text: None,
        rates: Floats | float = 1.0,
    ) -> None:
        self.period = Period()
        """Period of complete states."""
        self._names = robot.joint_names
        self._needed = velocities
        self._say = say
        self._rates = rates
        self._stamps = np.zeros(len(self._names), dtype=np.int64)
        """Timestamp of each joint's last position, ns; 0 before the first."""
        self._positions, self._velocities = np.full((2, len(self._names)), np.nan)
        self._fresh = np.zeros(len(self._names), dtype=bool)
        self._others: tuple[str, ...] = ()
        self.computes_velocities = False
        """True once a velocity was missing."""

    def add(self, joints: Joints) -> Joints | None:
        """Take a message with positions. Returns the state if it is complete, otherwise None."""
        assert joints.positions is not None
        self._others = joints.others
        found = np.isfinite(joints.positions)
        measured = np.full(len(found), np.nan) if joints.velocities is None else joints.velocities
        unknown = found & np.isnan(measured)
        if self._needed and unknown.any():
            measured = np.where(unknown, self._differentiated(joints), measured)
        self._positions = np.where(found, joints.positions, self._positions)
        self._velocities = np.where(found, measured, self._velocities)
        self._stamps[found] = joints.stamp
        self._fresh |= found
        if not self._fresh.all():
            return None
        self._fresh[:] = False
        stamp = int(self._stamps.max())
        self.period.add(stamp)
        if self.missing or (self._needed and np.isnan(self._velocities).any()):
            return None
        return Joints(stamp, self._positions, self._velocities, None)

    @property
    def missing(self) -> str:
        """Description of the joints without a state, or with one that is too old; empty if there are none."""
        unseen = [name for name, stamp in zip(self._names, self._stamps.tolist(), strict=True) if not stamp]
        if unseen:
            return missing_joints(unseen, self._others)
        oldest, newest = int(self._stamps.argmin()), int(self._stamps.argmax())
        lag = float(self._stamps[newest] - self._stamps[oldest]) / NS_PER_SECOND
        if lag <= self.period.tolerance:
            return ""
        return f"{self._names[oldest]} on {JOINT_STATES.name}: {lag:.2f} s older than {self._names[newest]}"

    def _differentiated(self, joints: Joints) -> Floats:
        """Compute velocities (J,) from the last positions and a message, through a first-order low-pass filter."""
        if not self.computes_velocities:
            self.computes_velocities = True
            self._say(
                f"{JOINT_STATES.name}: no velocities; they are computed from the positions, with a low-pass filter of "
                f"{1e3 * _VELOCITY_FILTER:g} ms"
            )
        elapsed = np.where(self._stamps > 0, (joints.stamp - self._stamps) / NS_PER_SECOND, 0.0)
        later = elapsed > 0.0
        slope = self._rates * (joints.positions - self._positions) / np.where(later, elapsed, np.nan)
        gain = -np.expm1(-elapsed / _VELOCITY_FILTER)
        filtered = self._velocities + gain * (slope - self._velocities)
        return np.where(later, np.where(np.isnan(self._velocities), slope, filtered), self._velocities)


def missing_joints(joints: Sequence[str], others: Sequence[str]) -> str:
    """Return the description of joints that `/joint_states` does not hold, and of other ones that it holds."""
    more = f" and {len(joints) - 1} more" if len(joints) > 1 else ""
    held = f", which holds {', '.join(map(short, others[:_SHOWN]))}{', ...' * (len(others) > _SHOWN)}"
    return f"{joints[0]}{more} on {JOINT_STATES.name}{held if others else ''}"


class Period:
    """Period and rate of a stream of timestamps, and the tolerance of pairing its messages with another's."""

    def __init__(self) -> None:
        self._stamps: deque[int] = deque(maxlen=_RATE_STAMPS)

    def add(self, stamp: int) -> None:
        """Take the timestamp of a message, ns."""
        self._stamps.append(stamp)

    @property
    def rate(self) -> float | None:
        """Mean rate of different timestamps without silences of over 0.2 s, Hz; None while there are too few."""
        steps = [step for step in self._steps() if step <= MAX_AGE * NS_PER_SECOND]
        return len(steps) * NS_PER_SECOND / sum(steps) if len(steps) >= _STAMPS else None

    def _steps(self, count: int = 0) -> list[int]:
        """Return the steps between increasing timestamps, of the last `count` timestamps or of all, ns."""
        stamps = list(self._stamps)[-count:]
        return [later - earlier for earlier, later in itertools.pairwise(stamps) if later > earlier]

    @property
    def tolerance(self) -> float:
        """1.5 periods (median of the last ones), but at least 0.02 s, as before the second message, at most 0.2 s."""
        steps = self._steps(_STAMPS)
        period = statistics.median(steps) / NS_PER_SECOND if steps else 0.0
        return min(max(_PERIODS * period, _MIN_TOLERANCE), MAX_AGE)


def command_message(robot: Jointed, stamp: int, target: Target) -> bytes:
    """Serialize a `/joint_commands` message to CDR.

    Args:
        robot: the robot that is commanded, or its driver.
        stamp: timestamp of the state that the target was computed from, ns.
        target: joint targets in rad (J,), or `LIMP`.
    """
    if target is LIMP:
        return joint_state(stamp, robot.joint_names, effort=np.zeros(len(robot.joint_names)))
    return joint_state(stamp, robot.joint_names, target)


def read_target(joints: Joints) -> Target:
    """Read the target of a `/joint_commands` message.

    Raises:
        QuadrupedError: if the message holds neither positions nor efforts of zero alone.
    """
    if joints.positions is not None:
        return joints.positions
    if joints.efforts is not None and not joints.efforts.any() and joints.velocities is None:
        return LIMP
    raise QuadrupedError("has no positions; send positions in rad, or only efforts of 0 to let the robot go limp")


class _Columns(NamedTuple):
    """Where a list of names holds the robot's joints."""

    joints: NDArray[np.intp]
    """Indices of the joints that are in the list (K,)."""
    places: NDArray[np.intp]
    """Their places in the list (K,)."""
    others: tuple[str, ...]
    """Names in the list that are no joints of the robot."""


def _columns(names: tuple[str, ...], joints: tuple[str, ...], whole: bool) -> _Columns:
    """Find the joints in a list of names; with `whole`, it has to hold each of them once and nothing else."""
    others = tuple(name for name in names if name not in joints)
    found = [i for i, joint in enumerate(joints) if joint in names]
    twice = len(names) - len(others) > len(found)
    if twice or (whole and (others or len(found) < len(joints))):
        missing = [joint for joint in joints if joint not in names]
        what = "one comes twice" if twice else f"unknown {others[0]!r}" if others else f"{missing[0]} is missing"
        once = "each of" if whole else "some of"
        raise QuadrupedError(
            f"the names are not this robot's: {what} among {len(names)}; expected {once} {', '.join(joints)} once"
        )
    places = [names.index(joints[i]) for i in found]
    return _Columns(np.array(found, dtype=np.intp), np.array(places, dtype=np.intp), others)
