"""Joint states of ROS bags: rosbag2 (MCAP and sqlite3, compressed or not) and ROS 1, through `rosbags`.

A rosbag2 bag is a directory with `metadata.yaml`, or one bare storage file. Messages come in the order in which they
were recorded. Their timestamps are those of the headers unless the options say otherwise, so they may decrease.
"""

from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path, PurePath
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, short
from quadruped_env.ros.robot_messages import RawJointState, read_joint_state, read_ros1_joint_state
from quadruped_env.trajectory.file_reading import Reading
from quadruped_env.trajectory.formats import salvage
from quadruped_env.trajectory.formats.echo_text import yaml_module
from quadruped_env.trajectory.formats.message_rows import assembled
from quadruped_env.trajectory.formats.salvage import DIRECTORY, MCAP, ROS1, SQLITE3, choose_topic
from quadruped_env.trajectory.formats.salvage.records import ZSTD_MAGIC, Message, zstd, zstd_has_checksum
from quadruped_env.trajectory.formats.salvage.sqlite3_scanner import unapplied
from quadruped_env.trajectory.rows import Rows
from quadruped_env.utils.documents import MAX_DEPTH

ROS1_DIGEST: Final = "3066dcd76a6cfaef579bd0f34173e9fd"
"""MD5 digest of ROS 1's definition of the message."""
METADATA_FILE: Final = "metadata.yaml"
_MAX_METADATA: Final = 1_000_000
"""Maximum characters of the metadata: enough for thousands of files or topics."""
_MESSAGES_PER_UPDATE: Final = 1000


def read_rosbag2(reading: Reading) -> Iterator[Rows]:
    """The joint states of a rosbag2 directory, not validated.

    Raises:
        QuadrupedError: if the bag is damaged.
        MissingExtraError: if rosbags is not installed.
    """
    return _rows(reading, DIRECTORY, read_joint_state)


def read_mcap(reading: Reading) -> Iterator[Rows]:
    """The joint states of a bare MCAP file; see `read_rosbag2`."""
    return _rows(reading, MCAP, read_joint_state)


def read_sqlite3(reading: Reading) -> Iterator[Rows]:
    """The joint states of a bare sqlite3 file; see `read_rosbag2`."""
    return _rows(reading, SQLITE3, read_joint_state)


def read_ros1(reading: Reading) -> Iterator[Rows]:
    """The joint states of a ROS 1 bag; see `read_rosbag2`."""
    return _rows(reading, ROS1, read_ros1_joint_state)


def _rows(reading: Reading, storage: str, decode: Callable[[bytes], RawJointState]) -> Iterator[Rows]:
    return assembled(_messages(reading, storage, decode), reading, is_text=False)


def _messages(
    reading: Reading, storage: str, decode: Callable[[bytes], RawJointState]
) -> Iterator[tuple[int, RawJointState]]:
    """Number in the bag, and message."""
    reading.row_name = "message"
    number = 0
    payloads = salvage.messages if reading.options.salvage and storage != ROS1 else _indexed
    for found in payloads(reading, storage):
        try:
            state = decode(_plain(found.data))
        except QuadrupedError as error:
            if not reading.options.salvage:
                raise reading.error(number, f"{error}; leave damaged messages out (--salvage)") from error
            reading.leave_out("the message is damaged")
            reading.rows += 1
        else:
            if not (found.checked or zstd_has_checksum(found.data)):
                reading.mark_unchecked(number)
            yield number, state if reading.options.stamps == "header" else state._replace(stamp=found.time)
        number += 1
    if not number:
        raise reading.error(None, "the topic has no message; record again, or name another topic (--topic)")


def _indexed(reading: Reading, storage: str) -> Iterator[Message]:
    """Every joint state, found by rosbags through the bag's index, which has to be intact.

    Raises:
        QuadrupedError: if the bag is damaged; the message names the message.
    """
    found = None
    try:
        with ExitStack() as stack:
            reader = _open(reading.path, storage, stack)
            topic = choose_topic({one.topic: one.msgtype for one in reader.connections}, reading)
            connections = [connection for connection in reader.connections if connection.topic == topic]
            for connection in connections:
                _check_connection(connection, reading)
            total = sum(connection.msgcount for connection in connections)
            found = 0
            for _, time, data in reader.messages(connections):
                if not isinstance(time, int) or not isinstance(data, (bytes, memoryview)):
                    raise TypeError("time or bytes of a message have another type")
                if found % _MESSAGES_PER_UPDATE == 0:
                    reading.report_progress(found / max(total, 1))
                yield Message(topic, time, bytes(data), checked=True)
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
            fix = "keep what can be read (--salvage)"
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
    if storage == DIRECTORY:
        _check_metadata(path / METADATA_FILE)
    for file in salvage.storage_files(path) if storage == DIRECTORY else [path]:
        if rest := unapplied(file):
            raise ValueError(f"{rest.name} holds changes that are not in {file.name} yet")
    reader = Reader1(path) if storage == ROS1 else Reader2.STORAGE_PLUGINS[storage](path)
    reader.open()
    stack.callback(reader.close)
    return reader


def _check_metadata(path: Path) -> None:
    """Raise a QuadrupedError if the metadata would keep rosbags busy for long; it reports other damage itself."""
    yaml = yaml_module()
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return
    problem = f"over {_MAX_METADATA} characters" if len(text) > _MAX_METADATA else ""
    depth = 0
    try:
        for event in () if problem else yaml.parse(text, yaml.CSafeLoader):
            depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
            if depth > MAX_DEPTH:
                problem = f"nested deeper than {MAX_DEPTH} levels"
                break
        if not problem:
            problem = _repeated_file(yaml.load(text, yaml.CBaseLoader))
    except yaml.YAMLError:
        return
    if problem:
        raise QuadrupedError(
            f"{path}: {problem}, which no bag's metadata are; name the storage file itself, or keep what can be read "
            f"(--salvage)"
        )


def _repeated_file(metadata: Any) -> str:
    """Description of a file that is named twice, which rosbags would read twice; empty without one."""
    section = metadata.get("rosbag2_bagfile_information") if isinstance(metadata, dict) else None
    paths = section.get("relative_file_paths") if isinstance(section, dict) else None
    # rosbags looks for all of them in the bag's own directory.
    names = [PurePath(path).name for path in paths if isinstance(path, str)] if isinstance(paths, list) else []
    repeated = next((name for name, count in Counter(names).items() if count > 1), None)
    return "" if repeated is None else f"relative_file_paths: names {short(repeated)} {names.count(repeated)} times"


def _check_connection(connection: Any, reading: Reading) -> None:
    """Raise a QuadrupedError if the messages have an unknown serialization or definition."""
    form = getattr(connection.ext, "serialization_format", "cdr")
    if form != "cdr":
        raise reading.error(None, f"{connection.topic} is serialized as {form!r}; only 'cdr' is known: convert the bag")
    if not hasattr(connection.ext, "serialization_format") and connection.digest != ROS1_DIGEST:
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
