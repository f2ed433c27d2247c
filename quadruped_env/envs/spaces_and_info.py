"""Spaces, metadata, specification and `info`, shared by the single and the vector environment."""

import copy
import os
from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Final

import gymnasium
import mujoco
import numpy as np
from gymnasium.envs.registration import EnvSpec
from numpy.typing import NDArray

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.envs.arguments import RENDER_MODES, arguments_of
from quadruped_env.robot import QuadrupedDesign, Robot
from quadruped_env.task import Task, TaskConfig
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.plain import plain

if TYPE_CHECKING:
    from quadruped_env.envs.rendering import SceneRenderer

_READINGS: Final = {
    "base_position": "base_position",
    "base_linear_velocity": "linear_velocity_b",
    "base_angular_velocity": "angular_velocity_b",
    "joint_position": "joint_position",
    "joint_velocity": "joint_velocity",
    "joint_torque": "joint_torque",
    "foot_force": "foot_force",
}
"""Entries of `info`, and the field of `Readings` that each one holds."""


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


class BaseEnv:
    """What both envs share: their renderer, and a specification that supports JSON.

    In it NumPy values, paths, enums, configs and robots become plain.
    """

    default_config: Mapping[str, Any] = MappingProxyType({})
    """Changes to the default config that the argument `config` may change again."""
    render_mode: str | None
    _frame_size: tuple[int, int]
    _spec: EnvSpec | None = None
    # A class attribute, because Gymnasium 1.2 closes an env even if `__init__` raised an error.
    _renderer: "SceneRenderer | None" = None

    def _make_renderer(self, model: mujoco.MjModel, data: mujoco.MjData) -> "SceneRenderer":
        """Return the renderer, which is made once."""
        if self._renderer is None:
            from quadruped_env.envs.rendering import SceneRenderer

            assert self.render_mode is not None
            self._renderer = SceneRenderer(model, data, self.render_mode, *self._frame_size)
        return self._renderer

    def _close_renderer(self) -> None:
        if self._renderer is not None:
            self._renderer.close()
            self._renderer = None

    def __getstate__(self) -> dict[str, Any]:
        # A renderer holds OpenGL contexts, so a copy creates its own.
        return {**self.__dict__, "_renderer": None}

    @property
    def spec(self) -> EnvSpec | None:
        """Specification for creating this environment again, with plain arguments."""
        return self._spec

    @spec.setter
    def spec(self, value: EnvSpec | None) -> None:
        self._spec = copy.copy(value)
        if self._spec is not None:
            config = self._spec.kwargs.get("config")
            own = arguments_of(config.definition) if isinstance(config, TaskConfig) else {}
            kwargs = own | {name: value for name, value in self._spec.kwargs.items() if value is not None}
            self._spec.kwargs = {name: _plain_argument(value) for name, value in kwargs.items()}


def _plain_argument(value: Any) -> Any:
    if isinstance(value, TaskConfig):
        return plain(value.to_dict())
    if isinstance(value, QuadrupedDesign):
        value = value.robot()
    if isinstance(value, Robot):
        return value.to_dict()
    return os.fspath(value) if isinstance(value, os.PathLike) else plain(value)


class Info:
    """Entries of `info` for the robots of a task."""

    def __init__(self, task: Task) -> None:
        self._task = task
        self._columns = {entry: task.simulation.sensor_columns[field] for entry, field in _READINGS.items()}
        self._width = max(columns.stop for columns in self._columns.values())

    def readings(
        self, env: int | slice = slice(None), only: NDArray[np.bool_] | None = None
    ) -> dict[str, NDArray[Any]]:
        """Entries that describe the state of one env, or with entries (N, ...) of all, as views of copies.

        With a mask `only` (N,) the entries of the other envs are zero.
        """
        task, tiles = self._task, self._task.tiles
        # One copy, with a view per reading, is cheaper than a copy per reading.
        values = task.simulation.sensordata[env, : self._width].copy()
        info: dict[str, NDArray[Any]] = {"command": task.control.command[env].copy()}
        if tiles is not None:
            info |= {"terrain_kind": tiles.kind[env].copy(), "terrain_level": tiles.level[env].copy()}
        if only is not None:
            for entry in (values, *info.values()):
                entry[~only] = 0
        for name, columns in self._columns.items():
            info[name] = values[..., columns]
        info["foot_contact"] = info["foot_force"] > task.context.contact_threshold
        return info

    def step_results(self, diverged: NDArray[np.bool_], terms: Floats) -> dict[str, NDArray[Any]]:
        """Entries that only a step has, (N,) each: `diverged`, and the weighted reward terms (N, T)."""
        return {"diverged": diverged, **dict(zip(self._task.reward_keys, terms.T, strict=True))}
