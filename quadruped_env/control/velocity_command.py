"""Commands: the velocities of a robot, and any further components of a task."""

from collections.abc import Iterable, Sequence
from typing import Final

import numpy as np

from quadruped_env.control.control_config import Command, velocity_commands
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of, scaled
from quadruped_env.utils.arrays import Floats

_MOVING_THRESHOLD: Final = 0.02
"""Maximum of all velocities of a command that means standing, in m/s and rad/s, for the built-in robot."""


def moving_threshold(robot: Robot) -> Floats:
    """Return the maximum of each velocity of a command that means standing (V,), in m/s and rad/s."""
    return np.array([scaled(_MOVING_THRESHOLD, scale_of(entry.unit, robot)) for entry in velocity_commands(robot)])


def check_command(command: Sequence[float] | Floats, commands: Sequence[Command]) -> Floats:
    """Convert a fixed command to an array (C,); components from the third on have their defaults if they are left out.

    Raises:
        QuadrupedError: if it is not two to C finite numbers within the ranges.
    """
    try:
        value = np.asarray(command, dtype=np.float64)
    except (TypeError, ValueError):
        value = np.empty(0)
    counts = range(2, len(commands) + 1)
    if value.ndim != 1 or len(value) not in counts or not np.isfinite(value).all():
        names = ", ".join(f"{entry.name.replace('_', ' ')} in {entry.unit}" for entry in commands)
        count = "two" if len(commands) == 2 else " or ".join(map(str, counts))
        raise QuadrupedError(f"options['command']: expected {count} finite numbers, ({names}); found {command!r}")
    full = np.array([entry.default for entry in commands])
    full[: len(value)] = value
    if outside := out_of_range(full, commands):
        name = outside.split()[0]
        raise QuadrupedError(f"options['command']: {outside}; widen config['command'][{name!r}] to allow it")
    return full


def out_of_range(command: Iterable[float], commands: Sequence[Command]) -> str:
    """The first number of a command that is not in the range of its component, in words; empty if all are."""
    for number, entry in zip(command, commands, strict=False):
        low, high = entry.range
        if not low <= number <= high:
            return f"{entry.name} = {number:g} is outside {low:g} to {high:g} {entry.unit}"
    return ""
