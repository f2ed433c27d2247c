"""MCAP without its index: https://mcap.dev/spec."""

import mmap
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO, Final
from zlib import crc32

from quadruped_env.trajectory.formats.storage.records import Message, Topic, decompress
from quadruped_env.trajectory.reading import Reading

_MAGIC: Final = b"\x89MCAP0\r\n"
_SCHEMA, _CHANNEL, _MESSAGE, _CHUNK = 0x03, 0x04, 0x05, 0x06
"""Types of records."""
_CHUNK_HEAD: Final = struct.Struct("<BQQQQII")
"""Head of a chunk: type, length, first and last time, size, checksum, length of the compression's name."""
_COMPRESSIONS: Final = (b"", b"lz4", b"zstd")


def scan(path: Path, reading: Reading) -> Iterator[Topic | Message]:
    """Yield topics and messages in the order of the file."""
    schemas: dict[int, str] = {}
    for op, data, checked in _records(path, reading):
        try:
            if op == _SCHEMA:
                (key,) = struct.unpack_from("<H", data)
                schemas[key] = _text(data, 2)[0]
            elif op == _CHANNEL:
                key, schema = struct.unpack_from("<HH", data)
                name, end = _text(data, 4)
                yield Topic(key, name, schemas.get(schema, ""), _text(data, end)[0])
            elif op == _MESSAGE:
                key, _, time, _ = struct.unpack_from("<HIQQ", data)
                yield Message(key, time, data[22:], checked=checked)
        except (struct.error, UnicodeDecodeError):
            reading.damage(f"{path.name}: a damaged record was left out")


def _records(path: Path, reading: Reading) -> Iterator[tuple[int, bytes, bool]]:
    """Yield the type, data and "covered by a correct checksum" of all records with content, also of those in chunks."""
    with path.open("rb") as file:
        if file.read(len(_MAGIC)) != _MAGIC:
            reading.damage(f"{path.name}: the beginning is damaged")
        size = path.stat().st_size
        while True:
            start = file.tell()
            reading.report_progress(start / size)
            head = file.read(9)
            if len(head) < 9:
                if head[: len(_MAGIC)] != _MAGIC:
                    reading.damage(f"{path.name}: cut off at byte {start}")
                return
            op, length = struct.unpack("<BQ", head)
            whole = start + 9 + length <= size
            if not whole:
                reading.damage(f"{path.name}: cut off or damaged from byte {start} on")
            if op == _CHUNK:
                yield from _chunk_records(file.read(min(length, size)), whole, f"{path.name}: byte {start}", reading)
            elif whole and op in {_SCHEMA, _CHANNEL, _MESSAGE}:
                yield op, file.read(length), False
            following = start + 9 + length if whole else _next_chunk(file, start + 1, size)
            if following is None:
                return
            file.seek(following)


def _next_chunk(file: BinaryIO, start: int, size: int) -> int | None:
    """Return the offset of the next plausible chunk from `start` on; None if there is none."""
    with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        at = data.find(bytes([_CHUNK]), start)
        while 0 <= at <= size - _CHUNK_HEAD.size:
            _, length, first, last, _, _, name = _CHUNK_HEAD.unpack_from(data, at)
            end = at + _CHUNK_HEAD.size
            if name <= 4 and first <= last and at + 9 + length <= size and data[end : end + name] in _COMPRESSIONS:
                held = int.from_bytes(data[end + name : end + name + 8], "little")
                if held == length - 40 - name:
                    return at
            at = data.find(bytes([_CHUNK]), at + 1)
    return None


def _chunk_records(data: bytes, whole: bool, where: str, reading: Reading) -> Iterator[tuple[int, bytes, bool]]:
    """Yield records of a chunk, up to a cut; none if its checksum is wrong."""
    try:
        _, _, size, checksum = struct.unpack_from("<QQQI", data)
        compression, at = _text(data, 28)
        plain, checked = decompress(data[at + 8 :], compression, size)
    except (struct.error, UnicodeDecodeError, ValueError) as error:
        reading.damage(f"{where}: a chunk was left out: {error}")
        return
    complete = len(plain) == size
    if (whole and not complete) or (complete and checksum and crc32(plain) != checksum):
        reading.damage(f"{where}: a chunk is damaged, by its size or checksum, and was left out")
        return
    checked = complete and (checked or checksum != 0)
    at = 0
    while at + 9 <= len(plain):
        op, length = struct.unpack_from("<BQ", plain, at)
        if at + 9 + length > len(plain):
            return
        yield op, plain[at + 9 : at + 9 + length], checked
        at += 9 + length


def _text(data: bytes, at: int) -> tuple[str, int]:
    """Return a text, and the offset of its end."""
    (length,) = struct.unpack_from("<I", data, at)
    end = at + 4 + length
    if end > len(data):
        raise struct.error("a text is too long")
    return data[at + 4 : end].decode(), end
