"""Steps of the velocity command that a key makes, in the viewer and in `teleop`."""

from typing import Final

FORWARD_STEP: Final = 0.1
"""Forward velocity, m/s per key press."""
TURN_STEP: Final = 0.2
"""Yaw rate, rad/s per key press."""


def next_step(value: float, size: float, steps: int) -> float:
    """A value changed by a number of steps, and rounded to a multiple of the step size."""
    return round((round(value / size) + steps) * size, 6) if steps else value
