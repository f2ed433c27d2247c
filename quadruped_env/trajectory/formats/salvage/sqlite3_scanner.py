"""sqlite3 bags without their B-tree: the pages of rows one by one, https://www.sqlite.org/fileformat2.html.

SQLite itself finds no row in a file whose upper pages are damaged, even if the rows are intact. The tables are those of
https://github.com/ros2/rosbag2: topics (id, name, type, ...) and messages (id, topic_id, timestamp, data).
"""

import struct
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final

from quadruped_env.trajectory.file_reading import Reading
from quadruped_env.trajectory.formats.salvage.records import MAX_SIZE, Message, Topic

_HEADER: Final = 100
"""Bytes of the header, at the beginning of the first page."""
_LEAF: Final = 0x0D
"""Type of a page with rows."""

Value = int | float | bytes | str | None
PageReader = Callable[[int], bytes]


def scan(path: Path, reading: Reading) -> Iterator[Topic | Message]:
    """Topics and messages in the order of the file."""
    with path.open("rb") as file:
        header = file.read(_HEADER)
        size = path.stat().st_size
        if len(header) < _HEADER:
            reading.note(f"{path.name}: cut off at byte {size}, within the header")
            return
        page_size, unused = struct.unpack_from(">H", header, 16)[0], header[20]
        page_size = 65536 if page_size == 1 else page_size
        if page_size < 512 or page_size & (page_size - 1):
            reading.note(f"{path.name}: byte 16: {page_size} is not a valid page size")
            return
        pages = struct.unpack_from(">I", header, 28)[0]
        if size < pages * page_size:
            reading.note(f"{path.name}: cut off at byte {size} of {pages * page_size}")

        def page(number: int) -> bytes:
            file.seek((number - 1) * page_size)
            return file.read(page_size)

        for number in range(1, size // page_size + 1):
            data = page(number)
            reading.report_progress(number * page_size / size)
            start = _HEADER if number == 1 else 0
            if data[start] != _LEAF:
                continue
            (count,) = struct.unpack_from(">H", data, start + 3)
            for i in range(count):
                try:
                    (at,) = struct.unpack_from(">H", data, start + 8 + 2 * i)
                    found = _found(*_row(data, at, page, page_size - unused))
                except (struct.error, IndexError, ValueError, OverflowError):
                    reading.note(f"{path.name}: page {number}: damaged rows were left out")
                    continue
                if found is not None:
                    yield found


def _found(key: int, row: list[Value]) -> Topic | Message | None:
    """The topic or message in a row, recognised by the types of its columns; the first, the key, is not stored."""
    match row:
        case [None, int(topic), int(time), bytes(data)]:
            return Message(topic, time, data)
        case [None, str(name), str(message_type), str(), *_] if name.startswith("/"):
            return Topic(key, name, message_type)
    return None


def _row(page: bytes, at: int, read_page: PageReader, usable: int) -> tuple[int, list[Value]]:
    """Key and columns of the row at an offset of a page."""
    size, at = _varint(page, at)
    key, at = _varint(page, at)
    if size > MAX_SIZE:
        raise ValueError(f"a row claims {size} bytes")
    payload = _payload(page, at, size, read_page, usable)
    head, at = _varint(payload, 0)
    kinds = []
    while at < head:
        kind, at = _varint(payload, at)
        kinds.append(kind)
    values = []
    for kind in kinds:
        value, at = _value(payload, at, kind)
        values.append(value)
    return key, values


def _payload(page: bytes, at: int, size: int, read_page: PageReader, usable: int) -> bytes:
    """The bytes of a row, which continue on other pages if they do not fit."""
    most, least = usable - 35, (usable - 12) * 32 // 255 - 23
    if size <= most:
        local = size
    else:
        local = least + (size - least) % (usable - 4)
        local = local if local <= most else least
    parts = [page[at : at + local]]
    missing = size - local
    (following,) = struct.unpack_from(">I", page, at + local) if missing else (0,)
    while missing > 0 and following:
        overflow = read_page(following)
        (following,) = struct.unpack_from(">I", overflow)
        parts.append(overflow[4 : 4 + min(missing, usable - 4)])
        missing -= usable - 4
    data = b"".join(parts)
    if len(data) != size:
        raise ValueError("a row is cut off")
    return data


def _value(data: bytes, at: int, kind: int) -> tuple[Value, int]:
    """A column, decoded by its serial type, and the offset of its end."""
    lengths = (0, 1, 2, 3, 4, 6, 8, 8, 0, 0, 0, 0)
    length = lengths[kind] if kind < 12 else (kind - 12) // 2
    part = data[at : at + length]
    if len(part) < length:
        raise ValueError("a column is cut off")
    value: Value
    if kind >= 12:
        value = part if kind % 2 == 0 else part.decode()
    elif kind == 7:
        (value,) = struct.unpack(">d", part)
    elif kind in {0, 10, 11}:
        value = None
    else:
        value = kind - 8 if kind in {8, 9} else int.from_bytes(part, "big", signed=True)
    return value, at + length


def _varint(data: bytes, at: int) -> tuple[int, int]:
    """A number of one to nine bytes, and the offset of its end."""
    value = 0
    for i in range(8):
        byte = data[at + i]
        value = value << 7 | byte & 0x7F
        if byte < 0x80:
            return value, at + i + 1
    return value << 8 | data[at + 8], at + 9
