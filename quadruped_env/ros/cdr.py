"""Messages and their bytes: CDR, the format of DDS topics and rosbag2 bags, through `rosbags`.

    joint_state = cdr.message("sensor_msgs/msg/JointState", header=cdr.header(time_ns), name=["a"], position=[0.5])
    data = cdr.serialize(joint_state)

A message is a dataclass of `rosbags`, with the fields of its `MessageType`. Fields left out have ROS's defaults: 0, ""
or empty, and 1 for the w of a quaternion.
"""

from collections.abc import Mapping
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.ros.message_types import Field, MessageType, message_type, typestore
from quadruped_env.ros.timestamps import NS_PER_SECOND

_ENCAPSULATION: Final = 4
"""Bytes in front of a message."""


def message(type_name: str, **fields: Any) -> Any:
    """Make a message from fields by name; a field that is a message may be given as a mapping.

    Arrays are converted to the field's type: `rosbags` would write an array of another type as garbage.

    Raises:
        QuadrupedError: if the type or a field is unknown, or an array has the wrong length.
    """
    kind = message_type(type_name)
    unknown = fields.keys() - {field.name for field in kind.fields}
    if unknown:
        names = ", ".join(field.name for field in kind.fields)
        raise QuadrupedError(f"{type_name}: unknown field {min(unknown)!r}; its fields are {names}")
    values = {field.name: _value(kind, field, fields.get(field.name)) for field in kind.fields}
    return typestore().types[type_name](**values)


def seconds_of(stamp: int) -> tuple[int, int]:
    """Split a timestamp in ns into s and ns. Raises a QuadrupedError if it does not fit into a message."""
    sec, nanosec = divmod(stamp, NS_PER_SECOND)
    if not -(2**31) <= sec < 2**31:
        raise QuadrupedError(f"timestamp {stamp} ns: a ROS message holds -2^31 to 2^31 - 1 s")
    return sec, nanosec


def header(stamp: int, frame_id: str = "") -> Any:
    """Return a `std_msgs/msg/Header` from a timestamp in ns."""
    types = typestore().types
    return types["std_msgs/msg/Header"](types["builtin_interfaces/msg/Time"](*seconds_of(stamp)), frame_id)


def serialize(value: Any) -> bytes:
    """Serialize a message to CDR, little endian, with the four bytes of encapsulation in front."""
    return bytes(typestore().serialize_cdr(value, value.__msgtype__, little_endian=True))


def deserialize(data: bytes, type_name: str) -> Any:
    """Decode CDR bytes of either byte order; bytes behind the message are ignored, as ROS does.

    rclpy's `serialize_message` writes up to 8 of them behind empty sequences. `rosbags` accepts 3.

    Args:
        data: the bytes.
        type_name: a type of `typestore`.

    Raises:
        QuadrupedError: if they do not hold a message of that type.
    """
    store = typestore()
    try:
        if data[:2] not in (b"\x00\x00", b"\x00\x01") or len(data) < _ENCAPSULATION:
            raise ValueError("they do not begin with the encapsulation of plain CDR")
        definition = store.get_msgdef(type_name)
        read = definition.deserialize_cdr_le if data[1] else definition.deserialize_cdr_be
        return read(data[_ENCAPSULATION:], 0, definition.cls, store)[0]
    # rosbags does not document which errors it raises for damaged bytes.
    except Exception as error:
        raise QuadrupedError(f"{len(data)} bytes do not hold a {type_name}: {error}") from error


def _value(kind: MessageType, field: Field, given: Any) -> Any:
    """Convert the value of one field of a message, or return its default."""
    if not field.many:
        return _single(kind.name, field, given)
    given = () if given is None else given
    values: Any
    if field.is_message or field.base == "string":
        values = [_single(kind.name, field, one) for one in given]
    else:
        values = np.ascontiguousarray(given, dtype=np.dtype(field.base))
        if field.count is not None and not len(values):
            values = np.zeros(field.count, dtype=values.dtype)
    if field.count is not None and len(values) != field.count:
        raise QuadrupedError(f"{kind.name}: {field.name} holds {field.count} values; found {len(values)}")
    return values


def _single(type_name: str, field: Field, given: Any) -> Any:
    if field.is_message:
        if given is None or isinstance(given, Mapping):
            return message(field.base, **(given or {}))
        return given
    if field.base == "string":
        return given or ""
    if field.base == "bool":
        return bool(given)
    convert = float if field.base.startswith("float") else int
    default = type_name == "geometry_msgs/msg/Quaternion" and field.name == "w"
    return convert(default if given is None else given)
