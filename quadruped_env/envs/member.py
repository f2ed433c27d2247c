"""One of the environments in a native vector environment, as `call`, `get_attr` and `set_attr` see it."""

from typing import TYPE_CHECKING, Any, Final

import gymnasium
import mujoco
import numpy as np
from gymnasium.envs.registration import EnvSpec
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError

if TYPE_CHECKING:
    from quadruped_env.envs.vector import MiniQuadrupedVectorEnv

_OWN: Final = ("_env", "_index")


class UnknownAttributeError(QuadrupedError, AttributeError):
    """The environments of a native vector environment have no such attribute."""


class MemberEnv:
    """The attributes that a single environment has too, for environment `index` of a native vector environment.

    Other names give the vector environment's own attribute, which all its environments share.
    """

    def __init__(self, env: "MiniQuadrupedVectorEnv", index: int) -> None:
        self._env = env
        self._index = index

    @property
    def action_space(self) -> gymnasium.Space[NDArray[np.float32]]:
        """Of one environment."""
        return self._env.single_action_space

    @property
    def observation_space(self) -> gymnasium.Space[NDArray[np.float32]]:
        """Of one environment."""
        return self._env.single_observation_space

    @property
    def spec(self) -> EnvSpec | None:
        """The vector environment's."""
        return self._env.spec

    @property
    def dt(self) -> float:
        """Time between actions, s."""
        return self._env.task.config.control_timestep

    @property
    def model(self) -> mujoco.MjModel:
        """MuJoCo's model; shared, without the values that differ from environment to environment."""
        return self._env.task.simulation.model

    @property
    def data(self) -> mujoco.MjData:
        """A copy of the environment's MuJoCo data."""
        return self._env.env_data(self._index)

    @property
    def np_random(self) -> np.random.Generator:
        """The environment's random generator."""
        return self._env.task.generators[self._index]

    @np_random.setter
    def np_random(self, generator: np.random.Generator) -> None:
        if not isinstance(generator, np.random.Generator):
            raise QuadrupedError(f"set_attr('np_random'): expected a numpy.random.Generator; found {generator!r}")
        self._env.task.generators[self._index] = generator
        self._env.task.seeds[self._index] = -1

    @property
    def np_random_seed(self) -> int:
        """The generator's seed; -1 for a generator that was put in from outside."""
        return self._env.task.seeds[self._index]

    def render(self) -> NDArray[np.uint8] | None:
        """A picture (height, width, 3), or None without a render mode."""
        return None if self._env.render_mode is None else self._env.render_one(self._index)

    def get_state(self) -> dict[str, Any]:
        """Everything that the environment's future depends on."""
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
