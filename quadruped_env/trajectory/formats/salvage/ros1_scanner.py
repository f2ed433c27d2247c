"""ROS 1 bags without their index: https://wiki.ros.org/Bags/Format/2.0."""

import struct
from collections.abc import Iterator, Mapping
from io import BytesIO
from pathlib import Path
from typing import BinaryIO, Final

from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.file_reading import Reading
from quadruped_env.trajectory.formats.salvage.records import Message, Topic, decompress

_MAGIC: Final = b"#ROSBAG V2.0\n"
_MESSAGE, _CHUNK, _CONNECTION = 2, 5, 7
"""Types of records."""


def scan(path: Path, reading: Reading) -> Iterator[Topic | Message]:
    """Topics and messages in the order of the file."""
    with path.open("rb") as file:
        if file.read(len(_MAGIC)) != _MAGIC:
            reading.note(f"{path.name}: the beginning is damaged")
        yield from _records(file, path.stat().st_size, path.name, reading)


def _records(
    file: BinaryIO, size: int, name: str, reading: Reading, checked: bool = False
) -> Iterator[Topic | Message]:
    """Topics and messages from the current position on; a chunk, `checked` or not, is a file within the file."""
    while file.tell() < size:
        start = file.tell()
        if not isinstance(file, BytesIO):
            reading.report_progress(start / size)
        try:
            (length,) = struct.unpack("<I", file.read(4))
            fields = _fields(file.read(min(length, size)))
            (length,) = struct.unpack("<I", file.read(4))
            whole = file.tell() + length <= size
            data = file.read(min(length, size))
            op = fields["op"][0]
            if op == _CHUNK:
                compression = fields["compression"].decode().removeprefix("none")
                plain, correct = decompress(data, compression, struct.unpack("<I", fields["size"])[0])
                yield from _records(BytesIO(plain), len(plain), f"{name}: chunk at byte {start}", reading, correct)
            elif op == _CONNECTION and whole:
                kind = _fields(data)["type"].decode()
                yield Topic(struct.unpack("<I", fields["conn"])[0], fields["topic"].decode(), kind)
            elif op == _MESSAGE and whole:
                sec, nanosec = struct.unpack("<II", fields["time"])
                time = sec * NS_PER_SECOND + nanosec
                yield Message(struct.unpack("<I", fields["conn"])[0], time, data, checked)
        except (struct.error, KeyError, IndexError, ValueError) as error:
            reading.note(f"{name}: damaged from byte {start} on: {error!r}")
            return
        if not whole:
            reading.note(f"{name}: cut off in the record at byte {start}")
            return


def _fields(data: bytes) -> Mapping[str, bytes]:
    """Fields of a header: name=value, each after its length."""
    fields, at = {}, 0
    while at < len(data):
        (length,) = struct.unpack_from("<I", data, at)
        name, separator, value = data[at + 4 : at + 4 + length].partition(b"=")
        if not separator:
            raise ValueError("a field has no value")
        fields[name.decode()] = value
        at += 4 + length
    return fields
