"""Times in messages."""

from typing import Any, Final

NANOSECONDS: Final = 1_000_000_000
"""in a second"""


def write_stamp(time: Any, stamp: int) -> None:
    """Write ns into a `builtin_interfaces/msg/Time`."""
    time.sec, time.nanosec = divmod(stamp, NANOSECONDS)


def read_stamp(time: Any) -> int:
    """The ns that a `builtin_interfaces/msg/Time` holds."""
    return int(time.sec) * NANOSECONDS + int(time.nanosec)
