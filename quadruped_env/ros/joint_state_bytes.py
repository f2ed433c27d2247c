"""Fast serialization of `sensor_msgs/msg/JointState`, of which long recordings consist.

A publisher sends the same frame and names in every message, so both directions prepare those once. Bytes and values are
those of `quadruped_env.ros.cdr`; only little-endian CDR is read here, which is what every machine of today writes.
"""

import struct
from array import array
from collections.abc import Sequence
from typing import Final, NamedTuple

from quadruped_env.errors import QuadrupedError
from quadruped_env.ros.timestamps import NS_PER_SECOND

_ENCAPSULATION: Final = b"\x00\x01\x00\x00"
"""Header of little-endian CDR."""
_START: Final = len(_ENCAPSULATION) + 8
"""Offset of the frame's name, after the timestamp."""
_STAMP: Final = struct.Struct("<iI")
_UINT32: Final = struct.Struct("<I")
_MAX_PADDING: Final = 3
"""Maximum number of padding bytes after a message: some implementations pad to a multiple of 4."""


class RawJointState(NamedTuple):
    """One message as received, unchecked: the arrays may have any lengths."""

    stamp: int
    """ns"""
    names: tuple[str, ...]
    position: "array[float]"
    velocity: "array[float]"
    effort: "array[float]"


class Decoder:
    """Reads messages of one topic."""

    def __init__(self) -> None:
        self._prefix = b""
        """Frame and names of the previous message, as bytes."""
        self._names: tuple[str, ...] = ()

    def __call__(self, data: bytes) -> RawJointState:
        """The message that CDR bytes hold.

        Raises:
            QuadrupedError: if they do not hold one; the message names the byte.
        """
        if data[:4] != _ENCAPSULATION:
            raise QuadrupedError(
                f"byte 0: the message begins with {data[:4].hex()}; expected {_ENCAPSULATION.hex()}, CDR"
            )
        try:
            sec, nanosec = _STAMP.unpack_from(data, 4)
            if not self._prefix or not data.startswith(self._prefix, _START):
                self._names, end = _names(data)
                self._prefix = bytes(data[_START:end])
            at = _START + len(self._prefix)
            position, at = _doubles(data, at)
            velocity, at = _doubles(data, at)
            effort, at = _doubles(data, at)
        except struct.error as error:
            raise QuadrupedError(f"byte {len(data)}: the message ends within a field") from error
        if nanosec >= NS_PER_SECOND:
            raise QuadrupedError(f"byte 8: {nanosec} ns in a second are too many; the message is damaged")
        if at + _MAX_PADDING < len(data):
            raise QuadrupedError(f"byte {at}: the message should end here and has {len(data) - at} bytes more")
        return RawJointState(sec * NS_PER_SECOND + nanosec, self._names, position, velocity, effort)


class Encoder:
    """Writes messages of one set of joints.

    Args:
        names: of the joints (J,).
        frame_id: of the header; joint states have none.
    """

    def __init__(self, names: Sequence[str], frame_id: str = "") -> None:
        prefix = bytearray(_ENCAPSULATION + bytes(8))
        _append_string(prefix, frame_id)
        _append_count(prefix, len(names))
        for name in names:
            _append_string(prefix, name)
        self._prefix = bytes(prefix[_START:])

    def __call__(self, stamp: int, position: bytes, velocity: bytes = b"", effort: bytes = b"") -> bytes:
        """The CDR bytes of one message.

        Args:
            stamp: ns, below 2^31 s.
            position: float64 in the machine's byte order, as returned by `tobytes`.
            velocity: the same format, or empty.
            effort: the same format, or empty.

        Raises:
            QuadrupedError: if the timestamp does not fit into the message.
        """
        try:
            data = bytearray(_ENCAPSULATION + _STAMP.pack(*divmod(stamp, NS_PER_SECOND)) + self._prefix)
        except struct.error as error:
            raise QuadrupedError(f"timestamp {stamp} ns: a ROS message holds -2^31 to 2^31 - 1 s") from error
        for values in (position, velocity, effort):
            _append_count(data, len(values) // 8)
            if values:
                data += bytes((4 - len(data)) % 8)
                data += values
        return bytes(data)


def decode_ros1(data: bytes) -> RawJointState:
    """The message that bytes of ROS 1 hold: nothing is aligned, and the header counts messages.

    Raises:
        QuadrupedError: if they do not hold one.
    """
    try:
        _, sec, nanosec, length = struct.unpack_from("<IIII", data)
        at = 16 + length
        (count,) = _UINT32.unpack_from(data, at)
        at += 4
        names = []
        for _ in range(count):
            (length,) = _UINT32.unpack_from(data, at)
            names.append(_text(data, at + 4, at + 4 + length))
            at += 4 + length
        arrays = []
        for _ in range(3):
            (count,) = _UINT32.unpack_from(data, at)
            arrays.append(_array(data, at + 4, count))
            at += 4 + 8 * count
    except struct.error as error:
        raise QuadrupedError(f"byte {len(data)}: the message ends within a field") from error
    if at != len(data) or nanosec >= NS_PER_SECOND:
        raise QuadrupedError(f"byte {at}: {len(data)} bytes do not hold a joint state; the message is damaged")
    return RawJointState(sec * NS_PER_SECOND + nanosec, tuple(names), *arrays)


def _names(data: bytes) -> tuple[tuple[str, ...], int]:
    """The joint names in CDR bytes, and the offset of their end."""
    _, at = _string(data, _START)
    at += -at % 4
    (count,) = _UINT32.unpack_from(data, at)
    at += 4
    names = []
    for _ in range(count):
        at += -at % 4
        name, at = _string(data, at)
        names.append(name)
    return tuple(names), at


def _string(data: bytes, at: int) -> tuple[str, int]:
    (length,) = _UINT32.unpack_from(data, at)
    start, end = at + 4, at + 4 + length
    # The length counts the zero that ends it.
    if not length or data[end - 1 : end] != b"\x00":
        raise QuadrupedError(f"byte {at}: a text of {length} bytes does not end with a zero; the message is damaged")
    return _text(data, start, end - 1), end


def _text(data: bytes, start: int, end: int) -> str:
    if end > len(data):
        raise QuadrupedError(f"byte {start}: a text goes on behind the message's end; the message is damaged")
    try:
        return data[start:end].decode()
    except UnicodeDecodeError as error:
        raise QuadrupedError(f"byte {start}: a text is not UTF-8 ({error.reason}); the message is damaged") from error


def _doubles(data: bytes, at: int) -> tuple["array[float]", int]:
    """The numbers of a sequence, and the offset of its end; numbers are aligned to 8 bytes behind the encapsulation."""
    at += -at % 4
    (count,) = _UINT32.unpack_from(data, at)
    at += 4
    if not count:
        return array("d"), at
    at += (4 - at) % 8
    return _array(data, at, count), at + 8 * count


def _array(data: bytes, start: int, count: int) -> "array[float]":
    end = start + 8 * count
    if end > len(data):
        raise QuadrupedError(f"byte {start}: {count} numbers go on behind the message's end; the message is damaged")
    return array("d", data[start:end])


def _append_count(data: bytearray, count: int) -> None:
    data += bytes(-len(data) % 4)
    data += _UINT32.pack(count)


def _append_string(data: bytearray, text: str) -> None:
    encoded = text.encode() + b"\x00"
    _append_count(data, len(encoded))
    data += encoded
