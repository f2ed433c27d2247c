"""Timestamps in ROS messages."""

from typing import Any

from quadruped_env.ros.timestamps import NS_PER_SECOND


def write_stamp(time: Any, stamp: int) -> None:
    """Write a timestamp in ns into a `builtin_interfaces/msg/Time`."""
    time.sec, time.nanosec = divmod(stamp, NS_PER_SECOND)


def read_stamp(time: Any) -> int:
    """The timestamp of a `builtin_interfaces/msg/Time`, ns."""
    return int(time.sec) * NS_PER_SECOND + int(time.nanosec)
