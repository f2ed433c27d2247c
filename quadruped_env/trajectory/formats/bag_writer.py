"""rosbag2 bags for ROS 2 Humble and later: joint states, and the topics that RViz needs to show them.

    /joint_states        sensor_msgs/JointState, every row at its timestamp
    /robot_description   std_msgs/String, the URDF, latched, once
    /tf                  tf2_msgs/TFMessage of the rows, every 50 ms at most, as robot_state_publisher sends it
    /tf_static           tf2_msgs/TFMessage, latched, once

The last three are written if the joints are the robot's. Metadata have version 8: Humble cannot read the qualities of
service of the newer version (https://github.com/ros2/rosbag2/issues/2013). Messages are in the order of their times.
"""

import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.robot import Robot
from quadruped_env.ros import JOINT_STATES_QOS, LATCHED_QOS, TF_QOS, Qos, cdr
from quadruped_env.ros.message_types import typestore
from quadruped_env.ros.robot_messages import joint_state, transform_messages
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.rows import KINDS, Rows
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.files import unwritable, whole

STORAGES: Final = {"mcap": ".mcap", "sqlite3": ".db3"}
"""Storage -> suffix of its files."""
METADATA_VERSION: Final = 8
TF_PERIOD: Final = NS_PER_SECOND // 20
"""Shortest time between transforms, ns; the default of robot_state_publisher."""

_METADATA: Final = "metadata.yaml"
_ROWS_PER_PIECE: Final = 4096
_CHUNK_CRC_AT: Final = 9 + 24
"""Offset of the checksum in a chunk of MCAP, in bytes."""


def write(rows: Rows, path: Path, robot: Robot, storage: str, base_pose: Floats | None, overwrite: bool) -> None:
    """Write a bag, in full or not at all: a directory, or one bare storage file if the path ends in its suffix.

    Args:
        rows: rows to write.
        path: path of the bag.
        robot: robot that the bag describes, if the rows have its joints.
        storage: one of `STORAGES`.
        base_pose: position in m and quaternion wxyz of `base_link` in `odom` (T, 7), to be part of /tf.
        overwrite: True to replace an existing bag.

    Raises:
        QuadrupedError: if the bag exists and must not be overwritten, or cannot be written.
        MissingExtraError: if rosbags is not installed.
    """
    check_target(path, overwrite)
    bare = path.suffix == STORAGES[storage]
    with whole(path) as part:
        bag = part.with_suffix("") if bare else part
        try:
            with open_bag(bag, storage) as writer:
                _write_messages(rows, writer, robot, base_pose)
        except sqlite3.Error as error:
            raise unwritable(path, error) from error
        if bare:
            (bag / f"{bag.name}{path.suffix}").replace(part)


def check_target(path: Path, overwrite: bool) -> None:
    """Raise a QuadrupedError if something exists at the path that must not be replaced."""
    if not path.exists():
        return
    if not overwrite:
        raise QuadrupedError(f"{path}: exists already; name another place, or ask to overwrite it (--overwrite)")
    suffixes = (*STORAGES.values(), *(f"{suffix}.zstd" for suffix in STORAGES.values()))
    if path.is_dir() and not all(entry.name == _METADATA or entry.name.endswith(suffixes) for entry in path.iterdir()):
        raise QuadrupedError(f"{path}: is a directory that contains more than a bag; name another place")


@contextmanager
def open_bag(bag: Path, storage: str) -> Iterator[Any]:
    """Provide a writer of rosbags for a new bag; `connect` adds topics.

    Chunks of MCAP get checksums: without them, damage would be read as numbers.

    Raises:
        MissingExtraError: if rosbags is not installed.
    """
    try:
        from rosbags.rosbag2 import StoragePlugin, Writer
        from rosbags.rosbag2.storage_mcap import McapWriter
    except ImportError as error:
        raise MissingExtraError("writing bags", "ros") from error

    class ChecksummedMcapWriter(McapWriter):
        def close_chunk(self) -> None:
            checksum, start = crc32(self.chunk.bio.getbuffer()), self.bio.tell()
            super().close_chunk()
            end = self.bio.tell()
            self.bio.seek(start + _CHUNK_CRC_AT)
            self.bio.write(checksum.to_bytes(4, "little"))
            self.bio.seek(end)

    class ChecksummedWriter(Writer):
        STORAGE_PLUGINS = Writer.STORAGE_PLUGINS | {StoragePlugin.MCAP: ChecksummedMcapWriter}

    with ChecksummedWriter(bag, version=METADATA_VERSION, storage_plugin=StoragePlugin[storage.upper()]) as writer:
        yield writer


def save_progress(writer: Any) -> None:
    """Write pending messages to the file, so that a killed process keeps them; MCAP writes each MB by itself."""
    connection = getattr(writer.storage, "conn", None)
    if connection is not None:
        connection.commit()


def _write_messages(rows: Rows, writer: Any, robot: Robot, base_pose: Floats | None) -> None:
    joints = connect(writer, "/joint_states", "sensor_msgs/msg/JointState", JOINT_STATES_QOS)
    due = np.zeros(len(rows), np.bool_)
    transforms: Iterator[bytes] = iter(())
    tf = None
    if set(robot.joint_names) <= set(rows.names):
        _write_description(writer, robot, int(rows.stamps[0]))
        tf = connect(writer, "/tf", "tf2_msgs/msg/TFMessage", TF_QOS)
        due = np.diff(rows.stamps // TF_PERIOD, prepend=-1) > 0
        columns = [rows.names.index(name) for name in robot.joint_names]
        positions, poses = rows.values["position"][due][:, columns], None if base_pose is None else base_pose[due]
        transforms = _transforms(rows.stamps[due], positions, poses, robot)
    arrays = [rows.values.get(kind, np.empty((len(rows), 0))) for kind in KINDS]
    for row, stamp in enumerate(rows.stamps.tolist()):
        writer.write(joints, stamp, joint_state(stamp, rows.names, *(array[row] for array in arrays)))
        if due[row]:
            writer.write(tf, stamp, next(transforms))


def _transforms(stamps: NDArray[np.int64], positions: Floats, poses: Floats | None, robot: Robot) -> Iterator[bytes]:
    """Yield the messages of /tf at timestamps (T,), in pieces: as Python objects, all would take gigabytes."""
    for start in range(0, len(stamps), _ROWS_PER_PIECE):
        part = slice(start, start + _ROWS_PER_PIECE)
        moved = robot.skeleton.joint_transforms(positions[part], None if poses is None else poses[part])
        yield from transform_messages(stamps[part].tolist(), moved)


def _write_description(writer: Any, robot: Robot, stamp: int) -> None:
    """Write the robot's description and its fixed transforms."""
    description = connect(writer, "/robot_description", "std_msgs/msg/String", LATCHED_QOS)
    writer.write(description, stamp, cdr.serialize(cdr.message("std_msgs/msg/String", data=robot.description)))
    message = next(transform_messages([stamp], robot.skeleton.fixed_transforms()))
    writer.write(connect(writer, "/tf_static", "tf2_msgs/msg/TFMessage", LATCHED_QOS), stamp, message)


def connect(writer: Any, topic: str, message_type: str, qos: Qos) -> Any:
    """Return a new topic of a bag, with the offered quality of service; the writer's `write` takes it."""
    from rosbags.interfaces import Qos as BagQos
    from rosbags.interfaces import QosDurability, QosHistory, QosLiveliness, QosReliability, QosTime

    # To rmw, zeros mean its defaults, which are unlimited; the spelling of "unlimited" differs between distributions.
    unlimited = QosTime(0, 0)
    profile = BagQos(
        QosHistory.KEEP_LAST,
        qos.depth,
        QosReliability.RELIABLE if qos.reliable else QosReliability.BEST_EFFORT,
        QosDurability.TRANSIENT_LOCAL if qos.transient_local else QosDurability.VOLATILE,
        unlimited,
        unlimited,
        QosLiveliness.AUTOMATIC,
        unlimited,
        False,
    )
    return writer.add_connection(topic, message_type, typestore=typestore(), offered_qos_profiles=[profile])
