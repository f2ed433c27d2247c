"""Times in messages."""

from typing import Any

from quadruped_env.ros.joint_state import NANOSECONDS

__all__ = ["NANOSECONDS", "read_stamp", "write_stamp"]


def write_stamp(time: Any, stamp: int) -> None:
    """Write ns into a `builtin_interfaces/msg/Time`."""
    time.sec, time.nanosec = divmod(stamp, NANOSECONDS)


def read_stamp(time: Any) -> int:
    """The ns that a `builtin_interfaces/msg/Time` holds."""
    return int(time.sec) * NANOSECONDS + int(time.nanosec)
