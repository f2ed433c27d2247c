"""Validation of arguments, shared by the single, the vector and the Stable-Baselines3 environment."""

import dataclasses
import os
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, Final

import numpy as np
from gymnasium.vector import AutoresetMode
from numpy.typing import NDArray

from quadruped_env.control.velocity_command import check_command
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot import QuadrupedDesign, Robot
from quadruped_env.robot.description import check_no_description
from quadruped_env.task import TaskConfig
from quadruped_env.task.task_definition import BUILT_IN, TaskDefinition, load_task_file
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.fields import check, check_names, one_of
from quadruped_env.utils.plain import plain, whole_number

RENDER_MODES: Final = ("human", "rgb_array")

RESET_MASK: Final = "reset_mask"

ROUGH_CONFIG: Final[dict[str, Any]] = {"terrain": {"name": "tiles", "curriculum": True}}
"""Changes to the default config of `MiniQuadrupedRough-v0`."""


def task_config(
    action_mode: str | None = None,
    config: dict[str, Any] | TaskConfig | None = None,
    task_file: str | os.PathLike[str] | None = None,
    robot: Robot | QuadrupedDesign | dict[str, Any] | None = None,
    terrain: str | None = None,
    defaults: Mapping[str, Any] = MappingProxyType({}),
) -> TaskConfig:
    """The task's config from an environment's arguments.

    Args:
        action_mode: action mode that replaces the config's; None keeps it.
        config: changes to the default config, or a complete one; None: the defaults.
        task_file: user's file of terms, which is executed; None: the built-in terms, or a given TaskConfig's.
        robot: robot, its design, or the result of `Robot.to_dict`; None: that in the file or the TaskConfig.
        terrain: name of a terrain that replaces the config's; None keeps it.
        defaults: changes to the default config that apply where the given changes do not; a complete config has none.

    Raises:
        QuadrupedError: if the mode, the file, the robot, the terrain or a field of the config is not valid.
    """
    definition = config.definition if isinstance(config, TaskConfig) else BUILT_IN
    if task_file is not None:
        definition = load_task_file(task_file)
    if robot is not None:
        definition = definition.with_robot(as_robot(robot))
    if isinstance(config, TaskConfig):
        task = config if definition == config.definition else config.with_definition(definition)
    else:
        changes = {} if config is None else config
        task = TaskConfig.from_dict(changed(defaults, changes) if isinstance(changes, dict) else changes, definition)
    if action_mode is not None:
        mode: Any = action_mode  # checked by ActionConfig
        task = dataclasses.replace(task, action=dataclasses.replace(task.action, mode=mode))
    return task if terrain is None else task.on_terrain(terrain)


def arguments_of(definition: TaskDefinition) -> dict[str, Any]:
    """Return the arguments for the parts of a definition that its config names and does not hold."""
    robot = {} if definition.robot == BUILT_IN.robot else {"robot": definition.robot}
    return robot if definition.path is None else {**robot, "task_file": definition.path}


def changed(defaults: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Nested values with changes applied. A section that names another terrain replaces the one before."""
    result = dict(defaults)
    for name, value in changes.items():
        default = defaults.get(name)
        result[name] = value
        if isinstance(value, Mapping) and isinstance(default, Mapping):
            named = default.get("name")
            result[name] = changed(default, value) if value.get("name", named) == named else value
    return result


def as_robot(value: Any) -> Robot:
    """A robot from a `Robot`, a `QuadrupedDesign`, or the result of `Robot.to_dict`.

    Raises:
        QuadrupedError: if it is another value.
    """
    if isinstance(value, QuadrupedDesign):
        return value.robot()
    if isinstance(value, dict):
        return Robot.from_dict(value)
    if isinstance(value, (str, os.PathLike)):
        check_no_description(value)
    if not isinstance(value, Robot):
        raise QuadrupedError(f"robot: expected a Robot, a QuadrupedDesign, or Robot.to_dict(); found {short(value)}")
    return value


def rendering(render_mode: str | None, width: int, height: int) -> tuple[str | None, tuple[int, int]]:
    """Return the render mode, and width and height of an image in pixels; raise a QuadrupedError if one is invalid."""
    mode = None if render_mode is None else one_of(render_mode, RENDER_MODES, "render_mode")
    return mode, (whole_number("width", width, 1), whole_number("height", height, 1))


def autoreset_mode(mode: AutoresetMode | str) -> AutoresetMode:
    """Gymnasium's autoreset mode from an `AutoresetMode` or its value. Raises a QuadrupedError if there is none."""
    return AutoresetMode(one_of(plain(mode), [valid.value for valid in AutoresetMode], "autoreset_mode"))


def seed(value: int | None, name: str = "seed") -> int | None:
    """The seed of one environment. Raises a QuadrupedError if it is neither None nor a whole number, 0 or more."""
    return None if value is None else whole_number(name, value, 0, or_none=True)


def seeds(value: int | Sequence[int | None] | NDArray[np.integer] | None, num_envs: int) -> list[int | None]:
    """One seed per env; from a single number, env i has number + i.

    Raises:
        QuadrupedError: if it is not None, a whole number, or a sequence of `num_envs` of these.
    """
    if value is None:
        return [None] * num_envs
    if isinstance(value, (list, tuple)) or (isinstance(value, np.ndarray) and value.ndim == 1):
        if len(value) != num_envs:
            raise QuadrupedError(f"seed: expected one number, or {num_envs}, one per env; found {len(value)}")
        return [seed(entry, f"seed[{i}]") for i, entry in enumerate(value)]
    first = whole_number("seed", value, 0, or_none=True)
    return [first + i for i in range(num_envs)]


def reset_options(
    options: dict[str, Any] | None, config: TaskConfig, num_envs: int | None = None
) -> tuple[Floats | None, NDArray[np.bool_] | None]:
    """Command and mask from `reset(options=...)`.

    Args:
        options: options with `command` and, in a vector environment, `reset_mask`.
        config: config of the task.
        num_envs: number of envs; None for the single environment, which has no mask.

    Returns:
        Command (C,) that stays fixed for the episode, the velocities in m/s and rad/s first, or None; and mask
        (num_envs,) of the envs to reset, or None for all.

    Raises:
        QuadrupedError: if there is an unknown option, or a value is not valid.
    """
    if options is None:
        return None, None
    valid = ["command"] if num_envs is None else ["command", RESET_MASK]
    named = ", ".join(repr(name) for name in valid)
    if not isinstance(options, dict):
        raise QuadrupedError(f"options: expected a dict with {named}, or None; found {options!r}")
    check_names(options, valid, "options")
    command, mask = options.get("command"), options.get(RESET_MASK)
    if mask is not None:
        bools = isinstance(mask, np.ndarray) and mask.shape == (num_envs,) and mask.dtype == np.bool_
        rule = f"a bool array of shape ({num_envs},) with one True or more"
        check(bools and bool(mask.any()), f"options['{RESET_MASK}']", mask, rule)
    return None if command is None else check_command(command, config.commands), mask
