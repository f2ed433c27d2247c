"""Spaces, metadata and specification, shared by the single and the vector environment."""

import copy
import os
from typing import Any

import gymnasium
import numpy as np
from gymnasium.envs.registration import EnvSpec
from numpy.typing import NDArray

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.envs.arguments import RENDER_MODES
from quadruped_env.robot import QuadrupedDesign, Robot
from quadruped_env.task import BUILT_IN, TaskConfig, TaskDefinition
from quadruped_env.utils.plain import plain


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
