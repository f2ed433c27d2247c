"""rosbag2 bags for ROS 2 Humble and later: joint states, and the topics that RViz needs to show them.

    /joint_states        sensor_msgs/JointState, every row at its timestamp
    /robot_description   std_msgs/String, the URDF, latched, once
    /tf                  tf2_msgs/TFMessage, as robot_state_publisher computes it from the rows
    /tf_static           tf2_msgs/TFMessage, latched, once

The last three are written if the joints are the robot's. Metadata have version 8: Humble cannot read the qualities of
service of the newer version (https://github.com/ros2/rosbag2/issues/2013). Messages are in the order of their times.
"""

import shutil
import sqlite3
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from heapq import merge
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
from quadruped_env.trajectory.formats.salvage.records import zstd
from quadruped_env.trajectory.interpolation import interpolate
from quadruped_env.trajectory.rows import KINDS, Rows
from quadruped_env.utils.files import PART, unwritable, whole

STORAGES: Final = {"mcap": ".mcap", "sqlite3": ".db3"}
"""Storage -> suffix of its files."""
METADATA_VERSION: Final = 8
TF_RATE: Final = 20.0
"""Hz; the default of robot_state_publisher."""

_METADATA: Final = "metadata.yaml"
_CHUNK_CRC_AT: Final = 9 + 24
"""Offset of the checksum in a chunk of MCAP, in bytes."""


def write(
    pieces: Iterable[Rows], path: Path, robot: Robot, storage: str, tf_rate: float, compress: bool, overwrite: bool
) -> None:
    """Write a bag, in full or not at all: a directory, or one bare storage file if the path ends in its suffix.

    Args:
        pieces: rows to write.
        path: path of the bag.
        robot: robot that the bag describes, if the rows have its joints.
        storage: one of `STORAGES`.
        tf_rate: rate of /tf in Hz, at multiples of its period; 0 writes no /tf.
        compress: compress with zstd; readers of sqlite3 then need rosbag2_compression_zstd.
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
            with open_bag(bag, storage, compress) as writer:
                _write_messages(pieces, writer, robot, tf_rate)
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
def open_bag(bag: Path, storage: str, compress: bool = False) -> Iterator[Any]:
    """A writer of rosbags for a new bag; `connect` adds topics.

    Chunks of MCAP and compressed files get checksums: without them, damage would be read as numbers.

    Raises:
        MissingExtraError: if rosbags is not installed.
    """
    try:
        from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer
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

        def close(self) -> None:
            super().close()
            if self.compression_mode is CompressionMode.FILE:
                for file in self.path.glob("*.zstd"):
                    _compress_with_checksum(file)

    plugin = StoragePlugin[storage.upper()]
    writer = ChecksummedWriter(bag, version=METADATA_VERSION, storage_plugin=plugin)
    if compress:
        mode = CompressionMode.STORAGE if plugin is StoragePlugin.MCAP else CompressionMode.FILE
        writer.set_compression(mode, CompressionFormat.ZSTD)
    with writer:
        yield writer


def save_progress(writer: Any) -> None:
    """Write pending messages to the file, so that a killed process keeps them; MCAP writes each MB by itself."""
    connection = getattr(writer.storage, "conn", None)
    if connection is not None:
        connection.commit()


def _compress_with_checksum(file: Path) -> None:
    """Compress a zstd file again, with a checksum of its content, which rosbags leaves out."""
    module, part = zstd(), file.with_name(f"{file.name}{PART}")
    options = {module.CompressionParameter.checksum_flag: 1}
    with module.open(file) as source, module.open(part, "wb", options=options) as target:
        shutil.copyfileobj(source, target)
    part.replace(file)


def _write_messages(pieces: Iterable[Rows], writer: Any, robot: Robot, tf_rate: float) -> None:
    joints, tf = None, None
    for piece in pieces:
        if joints is None:
            joints = connect(writer, "/joint_states", "sensor_msgs/msg/JointState", JOINT_STATES_QOS)
            if set(robot.joint_names) <= set(piece.names):
                tf = _TfWriter(writer, robot, tf_rate, int(piece.stamps[0]))
        arrays = [piece.values.get(kind, np.empty((len(piece), 0))) for kind in KINDS]
        states = (
            (stamp, 1, joints, joint_state(stamp, piece.names, *(array[row] for array in arrays)))
            for row, stamp in enumerate(piece.stamps.tolist())
        )
        # Of equal timestamps, the joint state comes first.
        transforms = iter(()) if tf is None else ((stamp, 2, tf.topic, data) for stamp, data in tf.messages(piece))
        for stamp, _, topic, data in merge(states, transforms, key=lambda message: message[:2]):
            writer.write(topic, stamp, data)


class _TfWriter:
    """Writes the robot's description and transforms next to its joint states."""

    def __init__(self, writer: Any, robot: Robot, rate: float, start: int) -> None:
        self._robot = robot
        self._period = round(NS_PER_SECOND / rate) if rate else 0
        self._last: tuple[int, NDArray[np.float64]] | None = None
        description = connect(writer, "/robot_description", "std_msgs/msg/String", LATCHED_QOS)
        writer.write(description, start, cdr.serialize(cdr.message("std_msgs/msg/String", data=robot.urdf)))
        message = next(transform_messages([start], robot.fixed_transforms()))
        writer.write(connect(writer, "/tf_static", "tf2_msgs/msg/TFMessage", LATCHED_QOS), start, message)
        self.topic = connect(writer, "/tf", "tf2_msgs/msg/TFMessage", TF_QOS) if rate else None

    def messages(self, piece: Rows) -> Iterator[tuple[int, bytes]]:
        """Timestamp and bytes of the messages due up to the end of a piece."""
        if self.topic is None:
            return
        base = piece.base_pose
        columns = [piece.names.index(name) for name in self._robot.joint_names]
        stamps, rows = piece.stamps, piece.values["position"][:, columns]
        if base is not None:
            rows = np.concatenate([rows, base], axis=1)
        first = -(-int(stamps[0]) // self._period) * self._period
        if self._last is not None:
            # Also between the previous piece and this one.
            first = (self._last[0] // self._period + 1) * self._period
            stamps = np.concatenate([[self._last[0]], stamps])
            rows = np.concatenate([self._last[1][None], rows])
        self._last = int(stamps[-1]), rows[-1]
        due = np.arange(first, int(stamps[-1]) + 1, self._period)
        if not len(due):
            return
        if base is not None:
            rows = _continuous(rows)
        values = interpolate((stamps - stamps[0]).astype(np.float64), rows, (due - stamps[0]).astype(np.float64))
        joints, poses = values[:, : len(columns)], None if base is None else values[:, len(columns) :]
        if poses is not None:
            poses[:, 3:] /= np.linalg.norm(poses[:, 3:], axis=1, keepdims=True)
        transforms = self._robot.joint_transforms(joints, poses)
        yield from zip(due.tolist(), transform_messages(due.tolist(), transforms), strict=True)


def _continuous(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rows of joints and base pose, quaternions signed for the shorter rotation: q and -q are the same orientation."""
    quaternions = rows[:, -4:]
    same = np.sum(quaternions[1:] * quaternions[:-1], axis=1) >= 0.0
    signs = np.cumprod(np.concatenate([[1.0], np.where(same, 1.0, -1.0)]))
    return np.concatenate([rows[:, :-4], quaternions * signs[:, None]], axis=1)


def connect(writer: Any, topic: str, message_type: str, qos: Qos) -> Any:
    """A new topic of a bag, with the offered quality of service; the writer's `write` takes it."""
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
