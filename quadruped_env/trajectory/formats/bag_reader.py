"""Joint states of ROS bags: rosbag2 (MCAP and sqlite3, compressed or not) and ROS 1, through `rosbags`.

A rosbag2 bag is a directory with `metadata.yaml`, or one bare storage file. Messages come in the order in which they
were recorded. Their timestamps are those of the headers unless the options say otherwise, so they may decrease.
"""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path, PurePath
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, short
from quadruped_env.ros.robot_messages import RawJointState, read_recorded, ros1_digest
from quadruped_env.trajectory.formats import salvage
from quadruped_env.trajectory.formats.echo_text import safe_yaml
from quadruped_env.trajectory.formats.message_rows import assembled
from quadruped_env.trajectory.formats.salvage import DIRECTORY, ROS1, choose_topics
from quadruped_env.trajectory.formats.salvage.records import ZSTD_MAGIC, Message, zstd, zstd_has_checksum
from quadruped_env.trajectory.formats.salvage.sqlite3_scanner import unapplied
from quadruped_env.trajectory.reading import KEEP, Reading
from quadruped_env.trajectory.rows import Rows
from quadruped_env.utils.documents import MAX_DEPTH

METADATA_FILE: Final = "metadata.yaml"
_MAX_METADATA: Final = 1_000_000
"""Maximum characters of the metadata: enough for thousands of files or topics."""
_MESSAGES_PER_UPDATE: Final = 1000


def read(reading: Reading, storage: str) -> Iterator[Rows]:
    """The joint states of a rosbag2 directory, of a bare MCAP or sqlite3 file, or of a ROS 1 bag, not validated.

    Raises:
        QuadrupedError: if the bag is damaged.
        MissingExtraError: if rosbags is not installed.
    """
    return assembled(_messages(reading, storage), reading, is_text=False)


def _messages(reading: Reading, storage: str) -> Iterator[tuple[int, list[RawJointState]]]:
    """Number in the bag, and joint states of the messages."""
    reading.row_name = "message"
    header, salvages = reading.options.stamps != "log", reading.repairs("salvage")
    number = 0
    by_index = storage == ROS1 or not (salvages or _irregular(reading, storage))
    for found in (_indexed if by_index else salvage.messages)(reading, storage):
        try:
            states = read_recorded(_plain(found.data), found.message_type, found.time, header, storage == ROS1)
        except QuadrupedError as error:
            if not salvages:
                raise reading.error(number, f"{error}; leave damaged messages out (--repair salvage)") from error
            reading.left_out["the message is damaged"] += 1
            reading.rows += 1
        else:
            reading.unchecked += salvages and not (found.checked or zstd_has_checksum(found.data))
            yield number, states
        number += 1
    if not number:
        raise reading.error(None, "the topic has no message; record again, or name another topic (--topic)")


def _irregular(reading: Reading, storage: str) -> bool:
    """True for a rosbag2 bag that is whole and that rosbags would refuse: it is read without its index, with a remark.

    Raises:
        QuadrupedError: if the metadata name files that are not there.
    """
    files = salvage.storage_files(reading.path) if storage == DIRECTORY else [reading.path]
    for file in files:
        if rest := unapplied(file):
            reading.note(f"{rest.name} holds changes that are not in {file.name} yet: both were read, on a copy")
            return True
    if storage != DIRECTORY:
        return False
    metadata = reading.path / METADATA_FILE
    if not metadata.exists():
        reading.note(f"there is no {METADATA_FILE}: the storage files were read without it")
        return True
    named, qos_is_readable = _named_files(metadata)
    there = [file.name for file in files]
    missing = [name for name in named if name not in there]
    if not missing and not qos_is_readable:
        reading.note(f"the offered_qos_profiles in {METADATA_FILE} are not valid: the files were read without it")
        return True
    if not missing:
        return False
    names = f"{METADATA_FILE} names {', '.join(named)}, and the directory holds {', '.join(there)}"
    if len(named) != len(there):
        raise reading.error(None, f"{names}; add {missing[0]}, or {KEEP}")
    reading.note(f"{names}: those were read")
    return True


def _indexed(reading: Reading, storage: str) -> Iterator[Message]:
    """Every joint state, found by rosbags through the bag's index, which has to be intact.

    Raises:
        QuadrupedError: if the bag is damaged; the message names the message.
    """
    found = None
    try:
        with ExitStack() as stack:
            reader = _open(reading.path, storage, stack)
            topics = choose_topics({one.topic: one.msgtype for one in reader.connections}, reading)
            connections = [connection for connection in reader.connections if connection.topic in topics]
            for connection in connections:
                _check_connection(connection, reading)
            total = sum(connection.msgcount for connection in connections)
            found = 0
            for connection, time, data in reader.messages(_stored(reader, connections)):
                if not isinstance(time, int) or not isinstance(data, (bytes, memoryview)):
                    raise TypeError("time or bytes of a message have another type")
                if found % _MESSAGES_PER_UPDATE == 0:
                    reading.report_progress(found / max(total, 1))
                yield Message(connection.topic, time, bytes(data), topics[connection.topic], checked=True)
                found += 1
            if found != total:
                raise ValueError(f"it says that there are {total} messages")
    except (QuadrupedError, MissingExtraError):
        raise
    # On damaged bytes rosbags raises errors of many types, which are not documented.
    except Exception as error:
        reason = " ".join(str(error).split()).rstrip(".") or type(error).__name__
        if storage == ROS1:
            fix = f"repair it with ROS 1 (rosbag reindex {reading.name}), and read it again"
        else:
            fix = KEEP
            place = "" if found is not None else salvage.first_damage(reading, storage)
            reason = f"{reason} ({place})" if place else reason
        raise reading.error(
            found, f"the bag is damaged, cut off, or was not closed: {reason}; {fix}, or record again"
        ) from error


def _open(path: Path, storage: str, stack: ExitStack) -> Any:
    """A reader of rosbags, closed with the stack."""
    try:
        from rosbags.rosbag1 import Reader as Reader1
        from rosbags.rosbag2 import Reader as Reader2
    except ImportError as error:
        raise MissingExtraError("reading bags", "ros") from error
    # By the content of the file; rosbags goes by its name.
    reader = Reader1(path) if storage == ROS1 else Reader2.STORAGE_PLUGINS[storage](path)
    reader.open()
    stack.callback(reader.close)
    return reader


def _stored(reader: Any, connections: Sequence[Any]) -> list[Any]:
    """Connections with the QoS of the storage files, by which rosbags finds their messages: metadata may be edited."""
    files = getattr(reader, "storages", ())
    return [*connections] + [
        one._replace(ext=stored.ext)
        for one in connections
        for file in files
        for stored in file.connections
        if (stored.topic, stored.msgtype) == (one.topic, one.msgtype) and stored.ext != one.ext
    ]


def _named_files(path: Path) -> tuple[list[str], bool]:
    """Names of the files in the metadata, and whether their QoS profiles are valid.

    rosbags looks for all files in the bag's own directory. There are none if the metadata are damaged, which rosbags
    reports.

    Raises:
        QuadrupedError: if they would keep rosbags busy for long, or make it read a file twice.
    """
    names: list[str] = []
    valid, problem = True, ""
    try:
        text = path.read_text(encoding="utf-8")
        if len(text) > _MAX_METADATA:
            problem = f"over {_MAX_METADATA} characters"
        metadata = safe_yaml(text, MAX_DEPTH) if not problem else None
        section = metadata.get("rosbag2_bagfile_information") if isinstance(metadata, dict) else None
        paths = section.get("relative_file_paths") if isinstance(section, dict) else None
        names = [PurePath(one).name for one in paths if isinstance(one, str)] if isinstance(paths, list) else []
        valid = not isinstance(section, dict) or _has_valid_qos(section)
    except ValueError as error:  # also for bytes that are no text
        problem = str(error) if "nested" in str(error) else ""
    except OSError:
        return [], True
    repeated = next((name for name, count in Counter(names).items() if count > 1), None)
    if repeated is not None:
        problem = f"relative_file_paths: names {short(repeated)} {names.count(repeated)} times"
    if problem:
        raise QuadrupedError(f"{path}: {problem}, which no bag's metadata are; name the storage file itself, or {KEEP}")
    return names, valid


def _has_valid_qos(section: Mapping[str, Any]) -> bool:
    """True if rosbags can read the profiles of all topics, without which it reads no bag."""
    from rosbags.rosbag2.metadata import parse_qos

    topics = section.get("topics_with_message_count")
    try:
        for topic in topics if isinstance(topics, list) else ():
            parse_qos(topic["topic_metadata"].get("offered_qos_profiles", ""))
    except Exception:  # of many types, which are not documented
        return False
    return True


def _check_connection(connection: Any, reading: Reading) -> None:
    """Raise a QuadrupedError if the messages have an unknown serialization or definition."""
    form = getattr(connection.ext, "serialization_format", "cdr")
    if form != "cdr":
        raise reading.error(None, f"{connection.topic} is serialized as {form!r}; only 'cdr' is known: convert the bag")
    if not hasattr(connection.ext, "serialization_format") and connection.digest != ros1_digest(connection.msgtype):
        raise reading.error(
            None, f"{connection.topic} has another definition of {connection.msgtype}, {connection.digest}"
        )


def _plain(data: bytes) -> bytes:
    """A message, decompressed: only the metadata say that it is compressed, and they may be lost."""
    if not data.startswith(ZSTD_MAGIC):
        return data
    try:
        return bytes(zstd().decompress(data))
    except Exception as error:
        raise QuadrupedError(f"byte 0: a compressed message: {error}") from error
