"""Counter-based random numbers: each is a hash of an env's key, its episode, the step, a purpose and a column.

All envs are drawn in one call, an added draw does not change the others, and the state is two integers per env. The
hash chains SplitMix64's mixing function (Steele et al. 2014, https://doi.org/10.1145/2660193.2660195).
"""

import hashlib
from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.episode_memory import EpisodeMemory
from quadruped_env.utils.arrays import Floats

Keys = NDArray[np.uint64]

_GOLDEN: Final = np.uint64(0x9E3779B97F4A7C15)
_MIX_1: Final = np.uint64(0xBF58476D1CE4E5B9)
_MIX_2: Final = np.uint64(0x94D049BB133111EB)
_SHIFTS: Final = (np.uint64(30), np.uint64(27), np.uint64(31))
_TOP: Final = np.uint64(11)
_ONE_STEP: Final = 2.0**-53


class Purposes:
    """Groups of columns that are drawn together: `widths` gives the number of columns per purpose."""

    def __init__(self, widths: Mapping[str, int]) -> None:
        self.widths = widths
        columns = [f"{name}/{i}".encode() for name, width in widths.items() for i in range(width)]
        digests = [hashlib.blake2b(column, digest_size=8).digest() for column in columns]
        self.constants: Keys = np.frombuffer(b"".join(digests), dtype="<u8").astype(np.uint64)
        ends = np.cumsum(list(widths.values()), dtype=int).tolist()
        self.slices = {name: slice(end - width, end) for (name, width), end in zip(widths.items(), ends, strict=True)}


class Draws:
    """Uniform random numbers for N envs."""

    def __init__(self, num_envs: int) -> None:
        # Not cleared at a reset, because it holds the number of the episode.
        self.memory = memory = EpisodeMemory(num_envs)
        """State from which the future draws follow."""
        self._key: Keys = memory.zeros("key", dtype=np.uint64)
        self._episode: Keys = memory.zeros("episode", dtype=np.uint64)
        self._episode_key: Keys = memory.zeros("episode_key", dtype=np.uint64)

    def set_key(self, env_id: int, generator: np.random.Generator) -> None:
        """Set an env's key from a generator, and restart its episode count at 0."""
        self._key[env_id] = generator.integers(0, 2**64, dtype=np.uint64)
        self._episode[env_id] = 0

    def begin_episode(self, env_ids: NDArray[np.intp]) -> None:
        """Begin new episodes in some envs (R,)."""
        self._episode[env_ids] += np.uint64(1)
        self._episode_key[env_ids] = _mix(self._key[env_ids] + self._episode[env_ids] * _GOLDEN)

    def uniform(self, purposes: Purposes, env_ids: NDArray[np.intp] | slice, step: NDArray[np.int64]) -> Floats:
        """Return numbers (R, columns) in [0, 1) for some envs (R,) at a control step of each of their episodes (R,).

        The same step always gives the same numbers.
        """
        key = self._episode_key[env_ids] + (step.astype(np.uint64) + np.uint64(1)) * _GOLDEN
        mixed = _mix(_mix(key)[:, None] ^ purposes.constants)
        # A double from the top 53 bits, as in NumPy's generators.
        return (mixed >> _TOP).astype(np.float64) * _ONE_STEP


def _mix(z: Keys) -> Keys:
    z = (z ^ (z >> _SHIFTS[0])) * _MIX_1
    z = (z ^ (z >> _SHIFTS[1])) * _MIX_2
    return z ^ (z >> _SHIFTS[2])
