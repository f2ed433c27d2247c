"""Conditions of episodes as data: velocity commands, and the task in which a policy is evaluated."""

import dataclasses
from collections.abc import Sequence
from typing import Final

import numpy as np

from quadruped_env.control.velocity_command import moving_threshold
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of, scaled
from quadruped_env.task import TaskConfig
from quadruped_env.utils.fields import Range

Command = tuple[float, float]
"""Forward velocity in m/s and yaw rate in rad/s."""

COMMANDS: Final[tuple[Command, ...]] = (
    (0.1, 0.0),
    (0.2, 0.0),
    (0.3, 0.0),
    (0.4, 0.0),
    (0.5, 0.0),
    (0.0, 0.0),
    (-0.2, 0.0),
    (0.0, 0.5),
    (0.0, -0.5),
    (0.3, 0.5),
    (0.3, -0.5),
)
"""Forward velocity in m/s and yaw rate in rad/s of every episode of the default evaluation, for the built-in robot."""

MOTIONS: Final = ("forwards", "standing", "backwards", "turning")
"""Motions that commands ask for, in the order of tables."""


def commands_for(robot: Robot, commands: Sequence[Command] = COMMANDS) -> list[Command]:
    """Convert commands for the built-in robot to the size of another one, rounded to two digits."""
    units = scale_of("m/s", robot), scale_of("rad/s", robot)
    return [(scaled(v, units[0], 2), scaled(w, units[1], 2)) for v, w in commands]


def motion_of(command: Command, robot: Robot) -> str:
    """Return the motion that a command (m/s, rad/s) requests, one of `MOTIONS`; a curve counts as turning."""
    forward, yaw_rate = np.abs(command) > moving_threshold(robot)
    if yaw_rate:
        return "turning"
    if not forward:
        return "standing"
    return "forwards" if command[0] > 0 else "backwards"


def words(command: Command) -> str:
    """Return a velocity command in words, such as `0.4 m/s and 0.2 rad/s`."""
    forward, yaw_rate = command
    if not forward and not yaw_rate:
        return "stand"
    parts = [f"{forward:g} m/s"] if forward else []
    return " and ".join(parts + ([f"{yaw_rate:g} rad/s"] if yaw_rate else []))


def evaluation_task(config: TaskConfig, commands: Sequence[Command], randomization: str) -> TaskConfig:
    """Return a policy's task for an evaluation, with a randomization preset and ranges that include the commands.

    There is no curriculum: on tiles, every episode starts on the tile that its seed gives.
    """
    ranges = config.command.replace(
        forward_velocity=_covering(config.command.forward_velocity, [v for v, _ in commands]),
        yaw_rate=_covering(config.command.yaw_rate, [w for _, w in commands]),
    )
    return dataclasses.replace(without_curriculum(config).randomized(randomization), command=ranges)


def without_curriculum(config: TaskConfig) -> TaskConfig:
    """Return a task in which every episode starts on the tile that its seed gives."""
    if "curriculum" not in config.terrain:
        return config
    return dataclasses.replace(config, terrain=config.terrain.replace(curriculum=False))


def _covering(bounds: Range, values: Sequence[float]) -> Range:
    """Return the smallest range that includes `bounds` and the values."""
    return min(bounds[0], *values), max(bounds[1], *values)
