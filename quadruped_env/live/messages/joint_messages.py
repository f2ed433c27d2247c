"""Joint states and joint commands, validated and in the robot's joint order."""

from collections.abc import Sequence
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.joint_command import LIMP, Target
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.middleware.topics import JOINT_COMMANDS, JOINT_POSITIONS
from quadruped_env.robot.robot import Robot
from quadruped_env.ros import cdr
from quadruped_env.ros.robot_messages import RawJointState, joint_state, read_joint_state

MAX_VALUE: Final = 1e3
"""Largest accepted position or velocity, rad or rad/s. Larger values indicate corrupt data and would lead to NaN."""


class Joints(NamedTuple):
    """One message in the order of the robot's joints; a field that the message leaves out is `None`."""

    stamp: int
    """Timestamp, ns."""
    positions: NDArray[np.float64] | None
    """Joint positions (J,), rad."""
    velocities: NDArray[np.float64] | None
    """Joint velocities (J,), rad/s."""
    efforts: NDArray[np.float64] | None
    """Joint torques (J,), N m; NaN means unknown."""


class JointReader:
    """Reads the messages of one topic.

    Args:
        topic: topic name for error messages.
        robot: robot whose joints the messages contain.
        needs: fields of `Joints` that every message must contain.
    """

    def __init__(self, topic: str, robot: Robot, needs: Sequence[str] = ()) -> None:
        self._topic = topic
        self._joints = robot.joint_names
        self._needs = tuple(needs)
        self._names: tuple[str, ...] | None = None
        self._order = np.empty(0, dtype=np.intp)

    def __call__(self, data: bytes) -> Joints:
        """Decode the CDR bytes of a JointState.

        Raises:
            QuadrupedError: if the bytes are corrupt, the names are not this robot's, the numbers of values and names
                differ, a position or velocity is not finite or exceeds `MAX_VALUE`, or a needed field is missing.
        """
        try:
            raw = read_joint_state(data)
            if raw.names != self._names:
                self._order = _order(raw.names, self._joints)
                self._names = raw.names
            joints = Joints(
                raw.stamp,
                self._values(raw, "position"),
                self._values(raw, "velocity"),
                self._values(raw, "effort", finite=False),
            )
            if any(getattr(joints, field) is None for field in self._needs):
                raise QuadrupedError(f"needs {' and '.join(self._needs)}; send one value per joint")
            return joints
        except QuadrupedError as error:
            raise QuadrupedError(f"{self._topic}: {error}") from error

    def _values(self, raw: RawJointState, field: str, finite: bool = True) -> NDArray[np.float64] | None:
        given = getattr(raw, field)
        if not len(given):
            return None
        if len(given) != len(raw.names):
            raise QuadrupedError(f"{field} holds {len(given)} values for {len(raw.names)} names; send one per joint")
        values: NDArray[np.float64] = given[self._order]
        if finite and not (np.abs(values) <= MAX_VALUE).all():
            wrong = int(np.flatnonzero(~(np.abs(values) <= MAX_VALUE))[0])
            raise QuadrupedError(
                f"{field} of {self._joints[wrong]} is {values[wrong]}; send finite numbers of at most {MAX_VALUE:g}"
            )
        return values


def command_message(robot: Robot, stamp: int, target: Target) -> bytes:
    """The CDR bytes of a `/joint_commands` message.

    Args:
        robot: robot that is commanded.
        stamp: timestamp of the state that the target was computed from, ns.
        target: joint targets in rad (J,), or `LIMP`.
    """
    if target is LIMP:
        return joint_state(stamp, robot.joint_names, effort=np.zeros(robot.num_joints))
    return joint_state(stamp, robot.joint_names, target)


def read_target(joints: Joints) -> Target:
    """The target of a `/joint_commands` message.

    Raises:
        QuadrupedError: if the message holds neither positions nor efforts of zero alone.
    """
    if joints.positions is not None:
        return joints.positions
    if joints.efforts is not None and not joints.efforts.any() and joints.velocities is None:
        return LIMP
    raise QuadrupedError(
        f"{JOINT_COMMANDS.name}: has no positions; send positions in rad, or only efforts of 0 to let the robot go limp"
    )


def positions_message(target: NDArray[np.float64]) -> Any:
    """A `/forward_position_controller/commands` message.

    Args:
        target: joint targets, rad (J,).
    """
    return cdr.message(JOINT_POSITIONS.type_name, data=target)


def read_positions(message: Any, robot: Robot) -> NDArray[np.float64]:
    """The joint targets of a `/forward_position_controller/commands` message, rad (J,).

    Raises:
        QuadrupedError: if it does not hold a finite number for each joint.
    """
    positions = np.array(message.data, dtype=np.float64)
    if positions.shape != (robot.num_joints,) or not np.isfinite(positions).all():
        found = positions.tolist() if positions.size <= robot.num_joints else f"{positions.size} numbers"
        raise QuadrupedError(
            f"{JOINT_POSITIONS.name}: holds {found}; send a finite number of rad for each of "
            f"{', '.join(robot.joint_names)}"
        )
    return positions


def _order(names: tuple[str, ...], joints: tuple[str, ...]) -> NDArray[np.intp]:
    """Index of each of the robot's joints in a list of names."""
    if sorted(names) != sorted(joints):
        unknown = [name for name in names if name not in joints]
        missing = [name for name in joints if name not in names]
        if unknown or missing:
            what = f"unknown {unknown[0]!r}" if unknown else f"{missing[0]} is missing"
        else:
            what = "one comes twice"
        raise QuadrupedError(
            f"the names are not this robot's: {what} among {len(names)}; expected each of {', '.join(joints)} once"
        )
    return np.array([names.index(name) for name in joints])
