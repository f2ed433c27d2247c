"""Spaces, metadata, specification and contents of `info`, shared by the single and the vector environment."""

import copy
import os
from typing import Any

import gymnasium
import numpy as np
from gymnasium.envs.registration import EnvSpec
from numpy.typing import NDArray

from quadruped_env._plain import plain
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.envs.arguments import RENDER_MODES
from quadruped_env.robot import QuadrupedDesign, Robot
from quadruped_env.task import BUILT_IN, Task, TaskConfig, TaskDefinition


def action_space(robot: Robot) -> gymnasium.Space[NDArray[np.float32]]:
    """Action space: one joint target per joint, in [-1, 1]."""
    return gymnasium.spaces.Box(-1.0, 1.0, (robot.num_joints,), np.float32)


def observation_space(layout: ObservationLayout) -> gymnasium.Space[NDArray[np.float32]]:
    """Observation space with the bounds of the layout, for each step of its history."""
    low, high = (np.tile(bound.astype(np.float32), layout.history) for bound in (layout.low, layout.high))
    return gymnasium.spaces.Box(low, high)


def metadata(config: TaskConfig) -> dict[str, Any]:
    """Metadata of an environment; the frame rate is its control rate."""
    return {"render_modes": list(RENDER_MODES), "render_fps": round(1.0 / config.control_timestep)}


class PlainSpec:
    """Base of envs whose specification supports JSON: NumPy values, paths, enums, configs and robots become plain."""

    _spec: EnvSpec | None = None

    @property
    def spec(self) -> EnvSpec | None:
        """Specification for creating this environment again, with plain arguments."""
        return self._spec

    @spec.setter
    def spec(self, value: EnvSpec | None) -> None:
        self._spec = copy.copy(value)
        if self._spec is not None:
            config = self._spec.kwargs.get("config")
            own = _of_definition(config.definition) if isinstance(config, TaskConfig) else {}
            kwargs = own | {name: value for name, value in self._spec.kwargs.items() if value is not None}
            self._spec.kwargs = {name: _plain_argument(value) for name, value in kwargs.items()}


def _of_definition(definition: TaskDefinition) -> dict[str, Any]:
    """Arguments for the parts of a definition that its config names and does not hold."""
    robot = {} if definition.robot == BUILT_IN.robot else {"robot": definition.robot}
    return robot if definition.path is None else {**robot, "task_file": definition.path}


def _plain_argument(value: Any) -> Any:
    if isinstance(value, TaskConfig):
        return plain(value.to_dict())
    if isinstance(value, QuadrupedDesign):
        value = value.robot()
    if isinstance(value, Robot):
        return value.to_dict()
    return os.fspath(value) if isinstance(value, os.PathLike) else plain(value)


def state(task: Task) -> dict[str, NDArray[Any]]:
    """The live arrays (N, ...) that `readings` describes."""
    tiles = task.tiles
    return {
        **({} if tiles is None else {"terrain_kind": tiles.kind, "terrain_level": tiles.level}),
        "command": task.command,
        "sensordata": task.simulation.sensordata,
    }


def readings(task: Task, state: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """Entries of `info` that describe the state of the robots, as views where possible.

    Args:
        task: the task.
        state: copies of the arrays of `state(task)`, of all envs, with entries (N, ...), or of one.
    """
    # One copy, with a view per reading, is cheaper than a copy per reading.
    columns, entries = task.simulation.sensor_columns, dict(state)
    values = entries.pop("sensordata")
    foot_force = values[..., columns["foot_force"]]
    return {
        **entries,
        "base_position": values[..., columns["base_position"]],
        "base_linear_velocity": values[..., columns["linear_velocity_b"]],
        "base_angular_velocity": values[..., columns["angular_velocity_b"]],
        "joint_position": values[..., columns["joint_position"]],
        "joint_velocity": values[..., columns["joint_velocity"]],
        "joint_torque": values[..., columns["joint_torque"]],
        "foot_force": foot_force,
        "foot_contact": foot_force > task.context.contact_threshold,
    }


def step_results(task: Task, diverged: NDArray[np.bool_], terms: NDArray[np.float64]) -> dict[str, NDArray[Any]]:
    """Entries of `info` that only a step has, (N,) each: `diverged`, and the weighted reward terms (N, T)."""
    return {"diverged": diverged, **dict(zip(task.reward_keys, terms.T, strict=True))}
