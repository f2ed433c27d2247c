"""The velocity command: forward velocity in m/s and yaw rate in rad/s."""

from collections.abc import Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.task.config import CommandConfig, Range

COMMAND_NAMES: Final = ("forward_velocity", "yaw_rate")
MOVING_THRESHOLD: Final = 0.02
"""A command below this in both m/s and rad/s asks the robot to stand."""

DRAWS: Final = 4
"""Uniform numbers in [0, 1) that one command takes."""


def sample_command(draws: NDArray[np.float64], config: CommandConfig) -> tuple[NDArray[Any], NDArray[Any]]:
    """Commands (R, 2) in m/s and rad/s, and seconds (R,) until the next one, from uniform draws (R, 4)."""
    kind = draws[:, 0]
    low, high = config.bounds
    command = low + (high - low) * draws[:, 1:3]
    np.copyto(command[:, 1], 0.0, where=kind < config.standing_fraction + config.straight_fraction)
    np.copyto(command[:, 0], 0.0, where=kind < config.standing_fraction)
    return command, between(config.resample_interval, draws[:, 3])


def between(bounds: Range, draw: NDArray[np.float64]) -> NDArray[np.float64]:
    """Uniform draws in [0, 1) stretched to [low, high)."""
    low, high = bounds
    return low + (high - low) * draw


def check_command(command: Sequence[float] | NDArray[np.float64], config: CommandConfig) -> NDArray[np.float64]:
    """A command (2,) that a user fixed, as an array.

    Raises:
        QuadrupedError: if it is not two finite numbers within the task's ranges.
    """
    try:
        value = np.asarray(command, dtype=np.float64)
    except (TypeError, ValueError):
        value = np.empty(0)
    if value.shape != (2,) or not np.isfinite(value).all():
        raise QuadrupedError(
            f"options['command']: expected two finite numbers, (forward velocity in m/s, yaw rate in rad/s); "
            f"found {command!r}"
        )
    for name, number, (low, high) in zip(COMMAND_NAMES, value, (config.forward_velocity, config.yaw_rate), strict=True):
        if not low <= number <= high:
            raise QuadrupedError(
                f"options['command']: {name} = {number:g} is outside {low:g} to {high:g}; "
                f"widen config['command'][{name!r}] to allow it"
            )
    return value
