"""Arrays with the lifetime of an episode: zero after a reset, and part of the state that `get_state` returns."""

from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from quadruped_env.errors import QuadrupedError

State = dict[str, Any]
"""Values of one env by name, from which it continues identically."""


class EpisodeMemory:
    """The episode arrays of N envs, each registered under a name when it is created."""

    def __init__(self, num_envs: int) -> None:
        self.num_envs = num_envs
        self._arrays: dict[str, NDArray[Any]] = {}

    def zeros(self, name: str, *shape: int, dtype: DTypeLike = np.float64) -> NDArray[Any]:
        """A new array (N, *shape) of zeros; write to it in place, never replace it.

        Raises:
            QuadrupedError: if the name is taken.
        """
        if name in self._arrays:
            raise QuadrupedError(
                f"episode memory: the name {name!r} is taken; choose another than {', '.join(self._arrays)}"
            )
        self._arrays[name] = np.zeros((self.num_envs, *shape), dtype)
        return self._arrays[name]

    def clear(self, env_ids: NDArray[np.intp]) -> None:
        """Set every array to zero for some envs (R,)."""
        for array in self._arrays.values():
            array[env_ids] = 0

    def get_state(self, env_id: int) -> State:
        """Copies of one env's values, by name."""
        return {name: array[env_id].copy() for name, array in self._arrays.items()}

    def set_state(self, env_id: int, state: State) -> None:
        """Restore a state from `get_state`."""
        for name, array in self._arrays.items():
            array[env_id] = state[name]
