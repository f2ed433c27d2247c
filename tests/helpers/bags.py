"""Bags for tests: of every storage kind, and with messages that this package does not write itself."""

import itertools

import numpy as np
import pytest

from quadruped_env.ros import cdr

pytest.importorskip("rosbags")
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

JOINT_STATE = "sensor_msgs/msg/JointState"
KINDS = ("mcap", "sqlite3", "bare.mcap", "bare.db3", "mcap zstd", "sqlite3 zstd")


def save(trajectory, directory, kind, **options):
    """Save a bag of one of `KINDS`; returns its path."""
    name, _, compressed = kind.partition(" ")
    path = directory / (name if "." in name else "bag")
    if compressed:
        path.parent.mkdir(exist_ok=True)
        return write_bag(path, messages_of(trajectory), name, "storage" if name == "mcap" else "file")
    trajectory.save(path, storage=None if "." in name else name, **options)
    return path


def write_bag(path, messages, storage="mcap", compression=None, topics=("/joint_states",)):
    """Write a bag of messages (time of recording in ns, fields) with rosbags only; returns its path."""
    writer = Writer(path, version=8, storage_plugin=StoragePlugin[storage.upper()])
    if compression:
        writer.set_compression(CompressionMode[compression.upper()], CompressionFormat.ZSTD)
    with writer:
        connections = [writer.add_connection(topic, JOINT_STATE, typestore=cdr.typestore()) for topic in topics]
        for (time, fields), connection in zip(messages, itertools.cycle(connections), strict=False):
            writer.write(connection, time, cdr.serialize(cdr.message(JOINT_STATE, **fields)))
    return path


def messages_of(trajectory):
    for state in trajectory:
        arrays = {"position": state.position, "velocity": state.velocity, "effort": state.effort}
        yield state.stamp, {"header": cdr.header(state.stamp), "name": state.names, **arrays}


def fields(stamp=0, names=("a", "b"), position=(0.1, 0.2), **others):
    return {"header": cdr.header(stamp), "name": names, "position": position, **others}


def write_ros1(path, trajectory, compression=None):
    store = get_typestore(Stores.ROS1_NOETIC)
    writer = Writer1(path)
    if compression:
        writer.set_compression(Writer1.CompressionFormat[compression])
    with writer:
        connection = writer.add_connection("/joint_states", JOINT_STATE, typestore=store)
        for number, state in enumerate(trajectory):
            time = store.types["builtin_interfaces/msg/Time"](*divmod(state.stamp, 10**9))
            header = store.types["std_msgs/msg/Header"](number, time, "")
            none = np.empty(0)
            message = store.types[JOINT_STATE](
                header,
                list(state.names),
                state.position,
                none if state.velocity is None else state.velocity,
                none if state.effort is None else state.effort,
            )
            writer.write(connection, state.stamp, store.serialize_ros1(message, JOINT_STATE))
    return path
