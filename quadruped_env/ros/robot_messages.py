"""The messages of which recordings consist: joint states in their several types, and the transforms of the links."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from quadruped_env.errors import QuadrupedError
from quadruped_env.ros import cdr
from quadruped_env.ros.message_types import typestore
from quadruped_env.ros.timestamps import NS_PER_SECOND, read_stamp
from quadruped_env.utils.arrays import Floats

JOINT_STATE = "sensor_msgs/msg/JointState"
_DYNAMIC = "control_msgs/msg/DynamicJointState"
_TRAJECTORY = "trajectory_msgs/msg/JointTrajectory"
_ARRAY = "std_msgs/msg/Float64MultiArray"
RECORDED_TYPES: Final = (JOINT_STATE, _DYNAMIC, _TRAJECTORY, _ARRAY)
"""Types of messages that hold joint positions; where a bag has several, the first is read."""


class RawJointState(NamedTuple):
    """One message as received, unchecked: the arrays may have any lengths."""

    stamp: int
    """ns"""
    names: tuple[str, ...]
    position: Floats
    velocity: Floats
    effort: Floats


def read_joint_state(data: bytes) -> RawJointState:
    """Read a joint state from CDR bytes. Raises a QuadrupedError if they do not hold one."""
    return _raw(cdr.deserialize(data, JOINT_STATE), len(data))


def read_recorded(data: bytes, type_name: str, time: int, header: bool = True) -> list[RawJointState]:
    """Read the joint states of a message: one, or the points of a `JointTrajectory`.

    Args:
        data: CDR bytes.
        type_name: one of `RECORDED_TYPES`.
        time: of recording, ns: the timestamp of a message that has none.
        header: True if the header's timestamp counts, where there is one.

    Raises:
        QuadrupedError: if they do not hold such a message.
    """
    message = cdr.deserialize(data, type_name)
    if type_name == _ARRAY:
        return [RawJointState(time, (), message.data, np.empty(0), np.empty(0))]
    if type_name == JOINT_STATE:
        raw = _raw(message, len(data))
        return [raw if header else raw._replace(stamp=time)]
    stamp = _checked_stamp(message.header.stamp, type_name, len(data))
    # A trajectory without a time begins when it arrives.
    stamp = stamp if header and (stamp or type_name == _DYNAMIC) else time
    if type_name == _DYNAMIC:
        values = [(one.interface_names, one.values) for one in message.interface_values]
        return [dynamic_state(stamp, message.joint_names, values)]
    return [
        RawJointState(
            stamp + read_stamp(point.time_from_start),
            tuple(message.joint_names),
            point.positions,
            point.velocities,
            point.effort,
        )
        for point in message.points
    ]


def dynamic_state(
    stamp: int, names: Sequence[str], interfaces: Sequence[tuple[Sequence[str], ArrayLike]]
) -> RawJointState:
    """Return the joint state of a `DynamicJointState`, which holds names and values of each joint's interfaces.

    Raises:
        QuadrupedError: if the lengths differ.
    """
    if len(interfaces) != len(names) or any(len(keys) != np.size(values) for keys, values in interfaces):
        raise QuadrupedError(f"{len(names)} joints and {len(interfaces)} lists of interfaces, or of unequal lengths")
    tables = [dict(zip(keys, np.ravel(values), strict=True)) for keys, values in interfaces]
    arrays = []
    for kind in ("position", "velocity", "effort"):
        known = any(kind in table for table in tables)
        arrays.append(np.array([table.get(kind, np.nan) for table in tables] if known else (), dtype=np.float64))
    return RawJointState(stamp, tuple(names), *arrays)


def joint_state(
    stamp: int, names: Sequence[str], position: ArrayLike = (), velocity: ArrayLike = (), effort: ArrayLike = ()
) -> bytes:
    """Serialize a joint state to CDR.

    Args:
        stamp: ns, below 2^31 s.
        names: of the joints (J,).
        position: rad (J,), or empty, as the other two.
        velocity: rad/s (J,).
        effort: N m (J,).

    Raises:
        QuadrupedError: if the timestamp does not fit into the message.
    """
    types = typestore().types
    arrays = (np.asarray(values, dtype=np.float64) for values in (position, velocity, effort))
    return cdr.serialize(types[JOINT_STATE](cdr.header(stamp), list(names), *arrays))


def transform_messages(stamps: Sequence[int], transforms: Iterable[Any]) -> Iterator[bytes]:
    """Yield the CDR bytes of a `tf2_msgs/msg/TFMessage` for each timestamp.

    Args:
        stamps: ns (T,).
        transforms: transforms of the robot's links (`quadruped_env.robot.Transform`), one per timestamp or constant.
    """
    types = typestore().types
    stamped, transform = types["geometry_msgs/msg/TransformStamped"], types["geometry_msgs/msg/Transform"]
    vector, quaternion = types["geometry_msgs/msg/Vector3"], types["geometry_msgs/msg/Quaternion"]
    transforms = list(transforms)
    places = [np.atleast_2d(one.translation).tolist() for one in transforms]
    rotations = [np.atleast_2d(one.rotation).tolist() for one in transforms]
    for row, stamp in enumerate(stamps):
        found = []
        for one, place, rotation in zip(transforms, places, rotations, strict=True):
            w, *xyz = rotation[row]
            moved = transform(vector(*place[row]), quaternion(*xyz, w))
            found.append(stamped(cdr.header(stamp, one.parent), one.child, moved))
        yield cdr.serialize(types["tf2_msgs/msg/TFMessage"](found))


def _raw(message: Any, size: int) -> RawJointState:
    stamp = _checked_stamp(message.header.stamp, JOINT_STATE, size)
    return RawJointState(stamp, tuple(message.name), message.position, message.velocity, message.effort)


def _checked_stamp(time: Any, type_name: str, size: int) -> int:
    if time.nanosec >= NS_PER_SECOND:
        raise QuadrupedError(
            f"{size} bytes do not hold a {type_name}: {time.nanosec} ns in a second are too many; the message is "
            f"damaged"
        )
    return read_stamp(time)
