"""Steps of the velocity command that a key makes, in the viewer and in `teleop`."""

from typing import Final

from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of, scaled

Velocity = tuple[float, float]
"""Forward velocity in m/s and yaw rate in rad/s."""
FORWARD_STEP: Final = 0.1
"""Forward velocity for the built-in robot, m/s per key press."""
TURN_STEP: Final = 0.2
"""Yaw rate for the built-in robot, rad/s per key press."""


def key_steps(robot: Robot) -> tuple[float, float]:
    """Forward velocity (m/s) and yaw rate (rad/s) per key press for a robot, rounded to one digit."""
    return scaled(FORWARD_STEP, scale_of("m/s", robot), 1), scaled(TURN_STEP, scale_of("rad/s", robot), 1)


def next_step(value: float, size: float, steps: int) -> float:
    """A value changed by a number of steps, and rounded to a multiple of the step size."""
    return round((round(value / size) + steps) * size, 6) if steps else value
