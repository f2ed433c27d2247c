"""Timestamps: whole nanoseconds, as in ROS messages and recordings."""

from typing import Any, Final

NS_PER_SECOND: Final = 1_000_000_000


def read_stamp(time: Any) -> int:
    """Return the timestamp of a `builtin_interfaces/msg/Time`, ns."""
    return int(time.sec) * NS_PER_SECOND + int(time.nanosec)
