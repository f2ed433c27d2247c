"""Joint states of ROS bags: rosbag2 (MCAP and sqlite3, compressed or not), and ROS 1 through `rosbags`.

A rosbag2 bag is a directory, or one bare storage file. Messages come in the order of the file. Their timestamps come
from the headers unless the options say otherwise, so they may decrease.
"""

import tempfile
from collections.abc import Iterator
from pathlib import Path

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.ros.message_types import typestore
from quadruped_env.ros.robot_messages import RECORDED_TYPES, RawJointState, read_recorded
from quadruped_env.trajectory.formats import storage
from quadruped_env.trajectory.formats.bag_writer import METADATA_VERSION
from quadruped_env.trajectory.formats.message_rows import assembled
from quadruped_env.trajectory.formats.storage.records import ZSTD_MAGIC, Message, zstd, zstd_has_checksum
from quadruped_env.trajectory.reading import Reading
from quadruped_env.trajectory.rows import Rows


def read(reading: Reading) -> Rows | None:
    """Return the joint states of a rosbag2 directory, or of a bare MCAP or sqlite3 file, not validated.

    Raises:
        QuadrupedError: if the bag is damaged.
        MissingExtraError: if rosbags is not installed.
    """
    return assembled(_joint_states(storage.messages(reading), reading), reading, is_text=False)


def _joint_states(messages: Iterator[Message], reading: Reading) -> Iterator[tuple[int, list[RawJointState]]]:
    """Yield the number in the bag, and joint states of the messages."""
    reading.row_name = "message"
    header, salvages = reading.options.stamps != "log", reading.repairs("salvage")
    number = 0
    for found in messages:
        try:
            states = read_recorded(_plain(found.data), found.message_type, found.time, header)
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


def read_ros1(reading: Reading) -> Rows | None:
    """Return the joint states of a ROS 1 bag, not validated.

    rosbags converts it to a temporary rosbag2 bag, for which its index has to be intact. Raises as `read` does.
    """
    try:
        from rosbags.convert import convert
        from rosbags.typesys import Stores, get_typestore
    except ImportError as error:
        raise MissingExtraError("reading bags", "ros") from error
    given = reading.path
    with tempfile.TemporaryDirectory() as directory:
        reading.path = Path(directory) / "bag"
        types = get_typestore(Stores.ROS1_NOETIC), typestore()
        try:
            convert([given], reading.path, "sqlite3", METADATA_VERSION, None, "", *types, (), (), (), RECORDED_TYPES)
        # On damaged bytes rosbags raises errors of many types, which are not documented.
        except Exception as error:
            reason = " ".join(str(error).split()).rstrip(".") or type(error).__name__
            raise reading.error(
                None,
                f"the bag is damaged, cut off, was not closed, or has no joint states: {reason}; repair it with ROS 1 "
                f"(rosbag reindex {reading.name}), and read it again, or record again",
            ) from error
        return read(reading)


def _plain(data: bytes) -> bytes:
    """Return a message, decompressed: only the metadata say that it is compressed, and they may be lost."""
    if not data.startswith(ZSTD_MAGIC):
        return data
    try:
        return bytes(zstd().decompress(data))
    except Exception as error:
        raise QuadrupedError(f"byte 0: a compressed message: {error}") from error
