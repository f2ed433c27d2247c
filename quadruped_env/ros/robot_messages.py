"""The messages of which recordings consist: joint states, and the transforms of the robot's links."""

from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.ros import cdr
from quadruped_env.ros.message_types import typestore
from quadruped_env.ros.timestamps import NS_PER_SECOND, read_stamp

JOINT_STATE = "sensor_msgs/msg/JointState"


class RawJointState(NamedTuple):
    """One message as received, unchecked: the arrays may have any lengths."""

    stamp: int
    """ns"""
    names: tuple[str, ...]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    effort: NDArray[np.float64]


def read_joint_state(data: bytes) -> RawJointState:
    """The joint state that CDR bytes hold. Raises a QuadrupedError if they do not hold one."""
    return _raw(cdr.deserialize(data, JOINT_STATE), len(data))


def read_ros1_joint_state(data: bytes) -> RawJointState:
    """The joint state that bytes of ROS 1 hold. Raises a QuadrupedError if they do not hold one."""
    try:
        message = _ros1_typestore().deserialize_ros1(data, JOINT_STATE)
    except Exception as error:  # rosbags does not document which errors it raises for damaged bytes
        raise QuadrupedError(f"{len(data)} bytes do not hold a {JOINT_STATE}: {error}") from error
    return _raw(message, len(data))


def joint_state(
    stamp: int, names: Sequence[str], position: ArrayLike = (), velocity: ArrayLike = (), effort: ArrayLike = ()
) -> bytes:
    """The CDR bytes of a joint state.

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
    return cdr.serialize(types[JOINT_STATE](_header(stamp, ""), list(names), *arrays))


def transform_messages(stamps: Sequence[int], transforms: Iterable[Any]) -> Iterator[bytes]:
    """The CDR bytes of a `tf2_msgs/msg/TFMessage` for each timestamp.

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
            found.append(stamped(_header(stamp, one.parent), one.child, moved))
        yield cdr.serialize(types["tf2_msgs/msg/TFMessage"](found))


def _header(stamp: int, frame_id: str) -> Any:
    """As `cdr.header`, in a third of the time."""
    types = typestore().types
    return types["std_msgs/msg/Header"](types["builtin_interfaces/msg/Time"](*cdr.seconds_of(stamp)), frame_id)


@cache
def _ros1_typestore() -> Any:
    from rosbags.typesys import Stores, get_typestore

    return get_typestore(Stores.ROS1_NOETIC)


def _raw(message: Any, size: int) -> RawJointState:
    time = message.header.stamp
    if time.nanosec >= NS_PER_SECOND:
        raise QuadrupedError(
            f"{size} bytes do not hold a {JOINT_STATE}: {time.nanosec} ns in a second are too many; the message is "
            f"damaged"
        )
    return RawJointState(read_stamp(time), tuple(message.name), message.position, message.velocity, message.effort)
