"""Commands: forward velocity in m/s, yaw rate in rad/s, and any further components of a task."""

from collections.abc import Iterable, Sequence
from typing import Final

import numpy as np

from quadruped_env.control.control_config import Command
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of, scaled
from quadruped_env.utils.arrays import Floats

VELOCITY: Final = 2
"""Number of components of the velocity command, which come first in every command."""

_MOVING_THRESHOLD: Final = 0.02
"""Maximum of both velocities of a command that means standing, in m/s and rad/s, for the built-in robot."""


def moving_threshold(robot: Robot) -> Floats:
    """Maximum of both velocities of a command that means standing (2,), in m/s and rad/s."""
    return np.array([scaled(_MOVING_THRESHOLD, scale_of(unit, robot)) for unit in ("m/s", "rad/s")])


def check_command(command: Sequence[float] | Floats, commands: Sequence[Command]) -> Floats:
    """Convert a fixed command to an array (C,).

    Args:
        command: forward velocity and yaw rate, or one number per entry of `commands`. Components that are left out have
            their defaults.
        commands: components of the command (C,), the velocities first.

    Raises:
        QuadrupedError: if it is not two (or C) finite numbers within the ranges.
    """
    try:
        value = np.asarray(command, dtype=np.float64)
    except (TypeError, ValueError):
        value = np.empty(0)
    if value.shape not in ((VELOCITY,), (len(commands),)) or not np.isfinite(value).all():
        names = ", ".join(f"{entry.name.replace('_', ' ')} in {entry.unit}" for entry in commands)
        count = "two" if len(commands) == VELOCITY else f"{VELOCITY} or {len(commands)}"
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
