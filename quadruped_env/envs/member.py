"""View of one env in a native vector environment, for `call`, `get_attr` and `set_attr`."""

from typing import Any, Final, Protocol

import gymnasium
import mujoco
import numpy as np
from gymnasium.envs.registration import EnvSpec
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.task import Task

_OWN: Final = ("_env", "_index")


class UnknownAttributeError(QuadrupedError, AttributeError):
    """Raised if the envs of a native vector environment have no such attribute."""


class Members(Protocol):
    """Vector environment whose envs have a view each: the parts that the views use."""

    single_action_space: gymnasium.Space[NDArray[np.float32]]
    single_observation_space: gymnasium.Space[NDArray[np.float32]]
    render_mode: str | None
    task: Task

    @property
    def spec(self) -> EnvSpec | None:
        """Specification for creating it again."""
        ...

    def env_data(self, index: int) -> mujoco.MjData:
        """Copy of one env's MuJoCo data."""
        ...

    def render_one(self, index: int) -> NDArray[np.uint8]:
        """Image (height, width, 3) of one env."""
        ...


class MemberEnv:
    """Attributes of env `index` of a native vector environment, named as in the single environment.

    Other names refer to attributes of the vector environment, which all its envs share.
    """

    def __init__(self, env: Members, index: int) -> None:
        self._env = env
        self._index = index

    @property
    def action_space(self) -> gymnasium.Space[NDArray[np.float32]]:
        """Space of one env."""
        return self._env.single_action_space

    @property
    def observation_space(self) -> gymnasium.Space[NDArray[np.float32]]:
        """Space of one env."""
        return self._env.single_observation_space

    @property
    def spec(self) -> EnvSpec | None:
        """Specification of the vector environment."""
        return self._env.spec

    @property
    def dt(self) -> float:
        """Time between actions, s."""
        return self._env.task.config.control_timestep

    @property
    def model(self) -> mujoco.MjModel:
        """MuJoCo model that all envs share, without the values that differ between envs."""
        return self._env.task.simulation.model

    @property
    def data(self) -> mujoco.MjData:
        """Copy of the env's MuJoCo data."""
        return self._env.env_data(self._index)

    @property
    def np_random(self) -> np.random.Generator:
        """Random generator of the env."""
        return self._env.task.generators[self._index]

    @np_random.setter
    def np_random(self, generator: np.random.Generator) -> None:
        if not isinstance(generator, np.random.Generator):
            raise QuadrupedError(f"set_attr('np_random'): expected a numpy.random.Generator; found {generator!r}")
        self._env.task.generators[self._index] = generator
        self._env.task.seeds[self._index] = -1

    @property
    def np_random_seed(self) -> int:
        """Seed of the generator; -1 for a generator that the user assigned."""
        return self._env.task.seeds[self._index]

    def render(self) -> NDArray[np.uint8] | None:
        """Image (height, width, 3), or None without a render mode."""
        return None if self._env.render_mode is None else self._env.render_one(self._index)

    def get_state(self) -> dict[str, Any]:
        """Complete state of the env."""
        return self._env.task.get_state(self._index)

    def __getattr__(self, name: str) -> Any:
        value = getattr(self._env, name, None)
        if name.startswith("_") or not hasattr(self._env, name) or callable(value):
            raise UnknownAttributeError(
                f"{name!r}: the environments of a native vector environment have no such attribute of their own; each "
                "has np_random, np_random_seed, action_space, observation_space, spec, dt, model, data, render and "
                "get_state; with vectorization_mode='sync' they have all attributes"
            )
        return value

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in (*_OWN, "np_random"):
            raise UnknownAttributeError(
                f"set_attr({name!r}): the environments of a native vector environment share their attributes, and only "
                "'np_random' can be set; with vectorization_mode='sync' every attribute can"
            )
        super().__setattr__(name, value)
