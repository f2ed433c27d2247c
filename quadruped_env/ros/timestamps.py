"""Timestamps: whole nanoseconds, as in ROS messages and recordings."""

from typing import Final

NS_PER_SECOND: Final = 1_000_000_000
