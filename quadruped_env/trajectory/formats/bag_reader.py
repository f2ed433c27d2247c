"""Joint states of ROS bags: rosbag2 (MCAP and sqlite3, compressed or not), and ROS 1 through `rosbags`.

A rosbag2 bag is a directory, or one bare storage file. Messages come in the order of the file. Their timestamps are
those of the headers unless the options say otherwise, so they may decrease.
"""

from collections.abc import Iterator
from typing import Final

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.ros.robot_messages import RawJointState, read_recorded, ros1_digest
from quadruped_env.trajectory.formats import storage
from quadruped_env.trajectory.formats.message_rows import assembled
from quadruped_env.trajectory.formats.storage import choose_topics
from quadruped_env.trajectory.formats.storage.records import ZSTD_MAGIC, Message, zstd, zstd_has_checksum
from quadruped_env.trajectory.reading import Reading
from quadruped_env.trajectory.rows import Rows

_MESSAGES_PER_UPDATE: Final = 1000


def read(reading: Reading) -> Iterator[Rows]:
    """The joint states of a rosbag2 directory, or of a bare MCAP or sqlite3 file, not validated.

    Raises:
        QuadrupedError: if the bag is damaged.
        MissingExtraError: if rosbags is not installed.
    """
    return assembled(_joint_states(storage.messages(reading), reading), reading, is_text=False)


def read_ros1(reading: Reading) -> Iterator[Rows]:
    """The joint states of a ROS 1 bag, not validated. Raises as `read` does."""
    return assembled(_joint_states(_ros1_messages(reading), reading, ros1=True), reading, is_text=False)


def _joint_states(
    messages: Iterator[Message], reading: Reading, ros1: bool = False
) -> Iterator[tuple[int, list[RawJointState]]]:
    """Number in the bag, and joint states of the messages."""
    reading.row_name = "message"
    header, salvages = reading.options.stamps != "log", reading.repairs("salvage")
    number = 0
    for found in messages:
        try:
            states = read_recorded(_plain(found.data), found.message_type, found.time, header, ros1)
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


def _ros1_messages(reading: Reading) -> Iterator[Message]:
    """Every joint state, found by rosbags through the bag's index, which has to be intact."""
    try:
        from rosbags.rosbag1 import Reader
    except ImportError as error:
        raise MissingExtraError("reading bags", "ros") from error
    found = None
    try:
        with Reader(reading.path) as reader:
            topics = choose_topics({one.topic: one.msgtype for one in reader.connections}, reading)
            connections = [connection for connection in reader.connections if connection.topic in topics]
            for one in connections:
                if one.digest != ros1_digest(one.msgtype):
                    raise reading.error(None, f"{one.topic} has another definition of {one.msgtype}, {one.digest}")
            total = sum(connection.msgcount for connection in connections)
            found = 0
            for connection, time, data in reader.messages(connections):
                if found % _MESSAGES_PER_UPDATE == 0:
                    reading.report_progress(found / max(total, 1))
                yield Message(connection.topic, time, bytes(data), topics[connection.topic], checked=True)
                found += 1
            if found != total:
                raise ValueError(f"it says that there are {total} messages")
    except QuadrupedError:
        raise
    # On damaged bytes rosbags raises errors of many types, which are not documented.
    except Exception as error:
        reason = " ".join(str(error).split()).rstrip(".") or type(error).__name__
        raise reading.error(
            found,
            f"the bag is damaged, cut off, or was not closed: {reason}; repair it with ROS 1 (rosbag reindex "
            f"{reading.name}), and read it again, or record again",
        ) from error


def _plain(data: bytes) -> bytes:
    """A message, decompressed: only the metadata say that it is compressed, and they may be lost."""
    if not data.startswith(ZSTD_MAGIC):
        return data
    try:
        return bytes(zstd().decompress(data))
    except Exception as error:
        raise QuadrupedError(f"byte 0: a compressed message: {error}") from error
