"""Values that follow from random numbers, computed ahead for many envs at a time."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.task.randomization.draws import Keys
from quadruped_env.utils.arrays import NUMPY, Namespace

EnvIds = NDArray[np.intp]
Values = tuple[NDArray[Any], ...]


class Ahead:
    """Values that each env needs next, such as the command that it gets when the present one ends.

    They follow from the env's key (see `Draws.key`), which is known long before. NumPy computes them for many envs in
    little more time than for one. So when an env needs values that are missing, they are computed for all envs.

    Args:
        compute: function (env_ids (R,), keys (R,)) that returns arrays (R, ...), and changes nothing.
        num_envs: number of envs, N.
        xp: array functions. Others than NumPy's compute the values when an env needs them, as does a single env.
    """

    def __init__(self, compute: Callable[[EnvIds, Keys], Values], num_envs: int, xp: Namespace) -> None:
        self._compute = compute
        self._is_ahead = num_envs > 1 and xp is NUMPY
        self._keys: Keys = np.zeros(num_envs, np.uint64)
        """Keys of the values below, (N,); 0 for none."""
        self._values: Values = ()

    def forget(self) -> None:
        """Compute all values again before they are used."""
        self._keys[:] = 0

    def of(self, env_ids: EnvIds, keys: Keys, expected: Callable[[], Keys]) -> Values:
        """Values of some envs (R,).

        Args:
            env_ids: indices of the envs.
            keys: keys of the values that they need now, (R,).
            expected: returns the keys of the values that every env will need next, (N,).
        """
        if not self._is_ahead:
            return self._compute(env_ids, keys)
        if (self._keys[env_ids] != keys).any():
            wanted = expected()
            wanted[env_ids] = keys
            missing = np.flatnonzero(self._keys != wanted)
            computed = self._compute(missing, wanted[missing])
            if not self._values:
                self._values = tuple(np.empty((len(wanted), *new.shape[1:]), new.dtype) for new in computed)
            for values, new in zip(self._values, computed, strict=True):
                values[missing] = new
            self._keys[:] = wanted
        return tuple(values[env_ids] for values in self._values)
