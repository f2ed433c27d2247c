"""Bags without their index: the readable messages of a rosbag2 bag that was cut off, damaged or never closed.

Messages come in the order of the file. ROS itself repairs ROS 1 bags (`rosbag reindex`).
"""

import re
import sqlite3
import struct
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.trajectory.file_reading import Reading
from quadruped_env.trajectory.formats.salvage import mcap_scanner, sqlite3_scanner
from quadruped_env.trajectory.formats.salvage.records import Message, Topic, zstd, zstd_has_checksum

DIRECTORY: Final = "dir"
MCAP: Final = ".mcap"
SQLITE3: Final = ".db3"
ROS1: Final = ".bag"

JOINT_STATE: Final = "sensor_msgs/JointState"
DEFAULT_TOPIC: Final = "/joint_states"

_SCANNERS: Final = {MCAP: mcap_scanner.scan, SQLITE3: sqlite3_scanner.scan}
_STEP: Final = 1 << 16
_SMALL_STEP: Final = 4096


def messages(reading: Reading, storage: str) -> Iterator[Message]:
    """Every joint state that can be read.

    Raises:
        QuadrupedError: if there is no topic of joint states, or several and the options name none.
        MissingExtraError: if rosbags is not installed.
    """
    topics: dict[tuple[Path, Any], Topic] = {}
    # The file is scanned twice, since a topic may come after its messages; the first scan reports no progress.
    for path, found in _scan(replace(reading, progress=None), storage):
        if isinstance(found, Topic):
            topics[path, found.key] = found
    wanted = choose_topic({topic.name: topic.message_type for topic in topics.values()}, reading)
    keys = {key for key, topic in topics.items() if topic.name == wanted}
    for path, found in _scan(reading, storage):
        if isinstance(found, Message) and (path, found.topic) in keys:
            yield found


def first_damage(reading: Reading, storage: str) -> str:
    """Place of the first damage in a bag that cannot be opened, as seen without its index; "" if none is seen."""
    looking = Reading(reading.path, replace(reading.options, salvage=True))
    try:
        for _ in _scan(looking, storage):
            if looking.notes:
                break
    except (QuadrupedError, OSError):
        return ""
    return looking.notes[0] if looking.notes else ""


def choose_topic(types: Mapping[str, str], reading: Reading) -> str:
    """The topic of joint states that the options name, or the only one in the bag, or `/joint_states`.

    Args:
        types: topic -> message type, as ROS 1 or ROS 2 name it.
        reading: of the bag; its options may name a topic.

    Raises:
        QuadrupedError: if there is none, or several and none is `/joint_states`.
    """
    topics = sorted(topic for topic, name in types.items() if name.replace("/msg/", "/") == JOINT_STATE)
    wanted = reading.options.topic
    if wanted is not None:
        if wanted in topics:
            return wanted
        found = ", ".join(f"{topic} ({name})" for topic, name in sorted(types.items())) or "no topic"
        raise reading.error(None, f"no topic {wanted!r} of type {JOINT_STATE}; it has {found}")
    if not topics:
        found = ", ".join(sorted(set(types.values()))) or "none"
        raise reading.error(None, f"no topic of type {JOINT_STATE}; the types in it are: {found}")
    if len(topics) == 1:
        return topics[0]
    if DEFAULT_TOPIC not in topics:
        raise reading.error(None, f"several topics of type {JOINT_STATE}; name one (--topic): {', '.join(topics)}")
    others = ", ".join(topic for topic in topics if topic != DEFAULT_TOPIC)
    reading.note(f"read {DEFAULT_TOPIC}; there are joint states on {others} too (--topic)")
    return DEFAULT_TOPIC


def decompressed(path: Path, stack: ExitStack, reading: Reading) -> Path:
    """A storage file, decompressed with zstd into a directory that is removed when the stack closes.

    Raises:
        QuadrupedError: if the file is damaged, unless the options ask to salvage.
        MissingExtraError: if rosbags is not installed.
    """
    plain = Path(stack.enter_context(tempfile.TemporaryDirectory())) / path.stem
    with path.open("rb") as source, plain.open("wb") as target:
        decompressor = zstd().ZstdDecompressor()
        head = source.read(8)
        source.seek(0)
        while not decompressor.eof:
            part = source.read(_STEP) if decompressor.needs_input else None
            try:
                # In small steps: a call that fails returns nothing.
                target.write(decompressor.decompress(part or b"", _SMALL_STEP))
                problem = "it ends too early" if part == b"" else None
            except zstd().ZstdError as error:
                problem = str(error)
            if problem is not None:
                where = f"{path.name}, byte {source.tell()}: the compressed file is damaged: {problem}"
                if not reading.options.salvage:
                    raise reading.error(None, f"{where}; keep what can be read (--salvage)")
                reading.note(where)
                break
        else:
            if zstd_has_checksum(head):
                reading.checked_files.add(plain)
    return plain


def _scan(reading: Reading, storage: str) -> Iterator[tuple[Path, Topic | Message]]:
    """Topics and messages of all files of a bag, each with its file."""
    if storage != DIRECTORY:
        for found in _scan_file(reading.path, storage, reading):
            yield reading.path, found
        return
    for path in storage_files(reading.path):
        with ExitStack() as stack:
            plain = decompressed(path, stack, reading) if path.suffix == ".zstd" else path
            for found in _scan_file(plain, plain.suffix, reading):
                yield path, found


def _scan_file(path: Path, storage: str, reading: Reading) -> Iterator[Topic | Message]:
    """Topics and messages of one file, up to damage that the scanner cannot skip."""
    checked = path in reading.checked_files
    try:
        for found in _SCANNERS[storage](path, reading):
            yield replace(found, checked=True) if checked and isinstance(found, Message) else found
    except OSError as error:
        raise reading.error(None, f"{path.name} cannot be read ({error.strerror})") from error
    except sqlite3.Error as error:
        reading.note(f"{path.name}: SQLite cannot read it: {error}")
    except (struct.error, LookupError, ValueError, OverflowError, MemoryError) as error:
        reading.note(f"{path.name}: the rest is damaged: {error!r}")


def storage_files(directory: Path) -> list[Path]:
    """The storage files of a bag in the order of their numbers."""
    files = [path for path in directory.iterdir() if path.name.removesuffix(".zstd").endswith((MCAP, SQLITE3))]
    return sorted(files, key=lambda path: [int(part) for part in re.findall(r"\d+", path.name)] + [0])
