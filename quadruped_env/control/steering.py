"""Steps of the velocity command that a key makes, in the viewer and in `teleop`."""

from typing import Final

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of, scaled

Velocity = tuple[float, ...]
"""Forward velocity in m/s, yaw rate in rad/s and, where it is known, lateral velocity in m/s."""
FORWARD_STEP: Final = 0.1
"""Forward velocity for the built-in robot, m/s per key press."""
TURN_STEP: Final = 0.2
"""Yaw rate for the built-in robot, rad/s per key press."""


def key_steps(robot: Robot) -> Velocity:
    """Return the change of each velocity of a robot's command per key press, rounded to one digit."""
    sizes = {"m/s": FORWARD_STEP, "rad/s": TURN_STEP}
    units = (entry.unit for entry in velocity_commands(robot))
    return tuple(scaled(sizes[unit], scale_of(unit, robot), 1) for unit in units)


def next_step(value: float, size: float, steps: int) -> float:
    """A value changed by a number of steps, and rounded to a multiple of the step size."""
    return round((round(value / size) + steps) * size, 6) if steps else value
