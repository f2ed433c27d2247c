"""Conditions of episodes as data: velocity commands, and the task in which a policy is evaluated."""

import dataclasses
from collections.abc import Sequence
from typing import Final

import numpy as np

from quadruped_env.control.control_config import velocity_commands
from quadruped_env.control.velocity_command import moving_threshold
from quadruped_env.robot import Robot
from quadruped_env.robot.units import scale_of, scaled
from quadruped_env.task import TaskConfig
from quadruped_env.utils.fields import Range

Command = tuple[float, ...]
"""Velocity command: a number for each of a robot's `velocity_commands`, in m/s and rad/s."""

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
SIDEWAYS: Final[tuple[Command, ...]] = ((0.0, 0.0, 0.15), (0.0, 0.0, -0.15), (0.3, 0.0, 0.15), (0.3, 0.0, -0.15))
"""Further commands for robots that move sideways, with the lateral velocity in m/s."""

MOTIONS: Final = {
    "forwards": "forward_velocity",
    "standing": "forward_velocity",
    "backwards": "forward_velocity",
    "turning": "yaw_rate",
    "sideways": "lateral_velocity",
}
"""Motion that commands ask for -> velocity by which it is judged, in the order of tables."""


def commands_for(robot: Robot, commands: Sequence[Command] | None = None) -> list[Command]:
    """Convert commands for the built-in robot to the size of another one, rounded to two digits.

    None: `COMMANDS`, and for robots that move sideways also `SIDEWAYS`.
    """
    if commands is None:
        commands = (*COMMANDS, *SIDEWAYS) if robot.moves_sideways else COMMANDS
    units = [scale_of(entry.unit, robot) for entry in velocity_commands(robot)]
    return [
        tuple(scaled(v, unit, 2) for v, unit in zip(full_command(command, robot), units, strict=True))
        for command in commands
    ]


def full_command(command: Command, robot: Robot) -> Command:
    """Return a command with a number for each of a robot's `velocity_commands`: those that are left out are 0."""
    return *command, *(0.0,) * (len(velocity_commands(robot)) - len(command))


def motion_of(command: Command, robot: Robot) -> str:
    """Return the motion that a command requests, one of `MOTIONS`; a curve is turning, and a diagonal sideways."""
    forward, yaw_rate, *lateral = np.abs(full_command(command, robot)) > moving_threshold(robot)
    if yaw_rate:
        return "turning"
    if any(lateral):
        return "sideways"
    if not forward:
        return "standing"
    return "forwards" if command[0] > 0 else "backwards"


def words(command: Command) -> str:
    """Return a velocity command in words, such as `0.4 m/s and 0.2 rad/s`."""
    forward, yaw_rate, lateral = (*command, 0.0)[:3]
    parts = [f"{forward:g} m/s"] if forward else []
    parts += [f"{yaw_rate:g} rad/s"] if yaw_rate else []
    parts += [f"{abs(lateral):g} m/s to the {'left' if lateral > 0 else 'right'}"] if lateral else []
    return " and ".join(parts) or "stand"


def evaluation_task(config: TaskConfig, commands: Sequence[Command], randomization: str) -> TaskConfig:
    """Return a policy's task for an evaluation, with a randomization preset and ranges that include the commands.

    There is no curriculum: on tiles, every episode starts on the tile that its seed gives.
    """
    columns = zip(*(full_command(command, config.robot) for command in commands), strict=True)
    named = zip(velocity_commands(config.robot), columns, strict=True)
    ranges = {entry.name: _covering(config.command[entry.name], values) for entry, values in named}
    command = config.command.replace(**ranges)
    return dataclasses.replace(without_curriculum(config).randomized(randomization), command=command)


def without_curriculum(config: TaskConfig) -> TaskConfig:
    """Return a task in which every episode starts on the tile that its seed gives."""
    if "curriculum" not in config.terrain:
        return config
    return dataclasses.replace(config, terrain=config.terrain.replace(curriculum=False))


def _covering(bounds: Range, values: Sequence[float]) -> Range:
    """Return the smallest range that includes `bounds` and the values."""
    return min(bounds[0], *values), max(bounds[1], *values)
