"""Storage files of rosbag2: the messages of MCAP and sqlite3, also of files that were cut off, damaged or never closed.

Files are read without an index and without `metadata.yaml`, which such bags lack, in the order of the files.
"""

import re
import sqlite3
import struct
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.ros.robot_messages import JOINT_STATE, RECORDED_TYPES
from quadruped_env.trajectory.formats.storage import mcap_scanner, sqlite3_scanner
from quadruped_env.trajectory.formats.storage.records import Message, Topic, zstd, zstd_has_checksum
from quadruped_env.trajectory.reading import KEEP, Reading

DEFAULT_TOPIC: Final = "/joint_states"

_METADATA: Final = "metadata.yaml"
_MAX_METADATA: Final = 1_000_000
_SCANNERS: Final[Mapping[bytes, Callable[[Path, Reading], Iterator[Topic | Message]]]] = {
    b"\x89MCAP0": mcap_scanner.scan,
    b"SQLite": sqlite3_scanner.scan,
}
"""First bytes of a file -> its scanner"""
_SUFFIXES: Final = (".mcap", ".db3")
_STEP: Final = 1 << 16
_SMALL_STEP: Final = 4096


def messages(reading: Reading) -> Iterator[Message]:
    """Yield every joint state that can be read.

    Raises:
        QuadrupedError: if there is no topic of joint states, or several and the options name none; at damage, unless
            the options ask to salvage.
        MissingExtraError: if rosbags is not installed.
    """
    topics: dict[tuple[Path, Any], Topic] = {}
    # The file is scanned twice, since a topic may come after its messages; the first scan reports no progress.
    for path, found in _scan(replace(reading, progress=None)):
        if isinstance(found, Topic):
            topics[path, found.key] = found
    wanted = choose_topics({topic.name: topic.message_type for topic in topics.values()}, reading)
    for topic in topics.values():
        if topic.name in wanted and topic.encoding not in {"", "cdr"}:
            problem = f"{topic.name} is serialized as {topic.encoding!r}; only 'cdr' is known: convert the bag"
            raise reading.error(None, problem)
    types = {key: wanted[topic.name] for key, topic in topics.items() if topic.name in wanted}
    count = 0
    for path, found in _scan(reading):
        if isinstance(found, Message) and (path, found.topic) in types:
            count += 1
            # Not by `replace`, which takes a tenth of the time of reading.
            yield Message(found.topic, found.time, found.data, types[path, found.topic], found.checked)
    _note_missing_messages(wanted, count, reading)


def choose_topics(types: Mapping[str, str], reading: Reading) -> dict[str, str]:
    """Return the topics of joint states that the options name, or the only one in the bag, or `/joint_states`.

    Args:
        types: topic -> message type, as ROS 1 or ROS 2 name it.
        reading: of the bag; its options may name topics.

    Returns:
        Topic -> message type, one of `RECORDED_TYPES`.

    Raises:
        QuadrupedError: if there is none, or several and none is `/joint_states`.
    """
    known = {topic: _full_name(name) for topic, name in sorted(types.items()) if _full_name(name) in RECORDED_TYPES}
    wanted = reading.options.topic
    if wanted is not None:
        names = wanted.split(",")
        if missing := next((name for name in names if name not in known), None):
            found = ", ".join(f"{topic} ({name})" for topic, name in sorted(types.items())) or "no topic"
            raise reading.error(
                None, f"no topic {missing!r} of type {' or '.join(map(_short_name, RECORDED_TYPES))}; it has {found}"
            )
        if len(names) > 1 and not reading.repairs("merge"):
            problem = "several are read as one robot's if they are merged (--repair merge)"
            raise reading.error(None, f"topics {wanted}: {problem}")
        return {name: known[name] for name in names}
    if not known:
        found = ", ".join(sorted(set(types.values()))) or "none"
        raise reading.error(None, f"no topic of type {_short_name(JOINT_STATE)}; the types in it are: {found}")
    best = min(known.values(), key=RECORDED_TYPES.index)
    topics = [topic for topic, name in known.items() if name == best]
    if len(topics) == 1:
        return {topics[0]: best}
    if DEFAULT_TOPIC not in topics:
        several = f"several topics of type {_short_name(best)}; name one (--topic): {', '.join(topics)}"
        raise reading.error(None, several)
    others = ", ".join(topic for topic in topics if topic != DEFAULT_TOPIC)
    reading.note(f"read {DEFAULT_TOPIC}; there are joint states on {others} too (--topic)")
    return {DEFAULT_TOPIC: best}


def _full_name(name: str) -> str:
    """Return a message type as ROS 2 names it."""
    return name if "/msg/" in name else name.replace("/", "/msg/")


def _short_name(name: str) -> str:
    return name.replace("/msg/", "/")


def decompressed(path: Path, stack: ExitStack, reading: Reading) -> Path:
    """Return a storage file, decompressed with zstd into a directory that is removed when the stack closes.

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
                if not reading.repairs("salvage"):
                    raise reading.error(None, f"{where}; {KEEP}")
                reading.note(where)
                break
        else:
            if zstd_has_checksum(head):
                reading.checked_files.add(plain)
    return plain


def _scan(reading: Reading) -> Iterator[tuple[Path, Topic | Message]]:
    """Yield topics and messages of all files of a bag, each with its file."""
    is_directory = reading.path.is_dir()
    if is_directory:
        _note_missing_files(reading)
    for path in storage_files(reading.path) if is_directory else [reading.path]:
        with ExitStack() as stack:
            plain = decompressed(path, stack, reading) if path.suffix == ".zstd" else path
            for found in _scan_file(plain, reading):
                yield path, found


def _metadata(reading: Reading) -> str:
    """Return the text of a bag's metadata, empty without any."""
    try:
        with (reading.path / _METADATA).open("rb") as file:
            return file.read(_MAX_METADATA).decode(errors="replace")
    except OSError:
        return ""


def _note_missing_messages(wanted: Iterable[str], found: int, reading: Reading) -> None:
    """Add a remark if the metadata count more messages of topics than were found."""
    counts = dict.fromkeys(wanted, 0)
    for entry in re.split(r"^\s*- (?=message_count:|topic_metadata:)", _metadata(reading), flags=re.MULTILINE)[1:]:
        name, count = (re.search(rf"^\s*{key}: (\S{{1,99}})", entry, re.MULTILINE) for key in ("name", "message_count"))
        if name and count and name[1] in counts and count[1].isdecimal():
            counts[name[1]] = int(count[1])
    if found < (total := sum(counts.values())):
        lost = "the bag was cut off, or files of it are missing"
        reading.note(f"{_METADATA} counts {total} messages of {', '.join(counts)}, and {found} were found: {lost}")


def _note_missing_files(reading: Reading) -> None:
    """Add a remark on files that the metadata name by other names. Raises a QuadrupedError if their number differs."""
    pattern = r"^\s*- (?:\S*/)?([^\s/]{1,99}\.(?:mcap|db3)(?:\.zstd)?)\s*$"
    named = re.findall(pattern, _metadata(reading), re.MULTILINE)
    there = [file.name for file in storage_files(reading.path)]
    missing = [name for name in named if name not in there]
    if missing:
        names = f"{_METADATA} names {', '.join(named[:9])}, and the directory holds {', '.join(there)}"
        if len(named) != len(there) and not reading.repairs("salvage"):
            raise reading.error(None, f"{names}; add {missing[0]}, or {KEEP}")
        reading.note(f"{names}: those were read")


def _scan_file(path: Path, reading: Reading) -> Iterator[Topic | Message]:
    """Yield topics and messages of one file, up to damage that the scanner cannot skip."""
    checked = path in reading.checked_files
    try:
        with path.open("rb") as file:
            head = file.read(6)
        # By the content of the file; a damaged beginning leaves its name.
        scan = _SCANNERS.get(head) or _SCANNERS[b"SQLite" if path.suffix == ".db3" else b"\x89MCAP0"]
        for found in scan(path, reading):
            yield replace(found, checked=True) if checked and isinstance(found, Message) else found
    except QuadrupedError:
        raise
    except OSError as error:
        raise reading.error(None, f"{path.name} cannot be read ({error.strerror})") from error
    except sqlite3.Error as error:
        reading.damage(f"{path.name}: SQLite cannot read it: {error}")
    except (struct.error, LookupError, ValueError, OverflowError, MemoryError) as error:
        reading.damage(f"{path.name}: the rest is damaged: {error!r}")


def storage_files(directory: Path) -> list[Path]:
    """Return the storage files of a bag in the order of their numbers."""
    files = [path for path in directory.iterdir() if path.name.removesuffix(".zstd").endswith(_SUFFIXES)]
    return sorted(files, key=lambda path: [int(part) for part in re.findall(r"\d+", path.name)] + [0])
