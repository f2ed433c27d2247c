"""Statistics of a training's steps, over the envs of all its ranks."""

from typing import cast

import numpy as np
import torch
from numpy.typing import NDArray

from quadruped_env.envs.sb3 import MiniQuadrupedSB3VecEnv
from quadruped_env.training.group import ALONE, Group
from quadruped_env.training.schedules import Scheduled

Floats = NDArray[np.float64]

_ERRORS = 2
"""Number of velocity errors: forward and yaw."""


class StepStatistics(Scheduled):
    """Sums over the steps since `_clear`. With several ranks each runs one, and they exchange it after each rollout.

    They then agree on what must be equal on all: the end of the training, and the place in the schedules.

    Args:
        group: this rank.
    """

    def __init__(self, group: Group = ALONE) -> None:
        super().__init__()
        self._group = group
        self.stopped = False
        """True if a signal asked to stop, after a rollout also if it asked another rank"""
        self.signal = "SIGTERM"
        """Name of the signal that asked to stop, if one did; on other ranks, that of a cluster"""
        self.ended = False
        """True if the ranks agreed to end the training"""

    def _on_training_start(self) -> None:
        super()._on_training_start()
        self._env = cast(MiniQuadrupedSB3VecEnv, self.training_env)
        self._task = self._env.task
        self._levels: Floats | None = None
        self._clear()

    def _clear(self) -> None:
        self._sums = np.zeros(_ERRORS + len(self._task.term_names) + 1)
        self._own = self._sums if self._group.ranks == 1 else np.zeros_like(self._sums)
        self._steps = 0

    @property
    def sums(self) -> tuple[Floats, Floats, float]:
        """Mean over envs of the squared errors (2,) and of each term (T,), and falls, each summed over steps."""
        return self._sums[:_ERRORS], self._sums[_ERRORS:-1], float(self._sums[-1])

    def mean_levels(self) -> dict[str, float]:
        """Mean levels of the terrain's curriculum over all ranks; empty on a plane."""
        return {} if self._task.tiles is None else self._task.tiles.mean_levels(self._levels)

    def _over(self) -> bool:
        """True if this rank has a reason to end the training."""
        return self.stopped

    def _on_step(self) -> bool:
        error = self._task.tracking_error
        self._own[:_ERRORS] += (error * error).mean(axis=0)
        self._own[_ERRORS:-1] += self._env.last_terms.mean(axis=0)
        self._steps += 1
        if self.locals["dones"].any():
            self._own[-1] += sum(
                not self.locals["infos"][row]["TimeLimit.truncated"] for row in np.flatnonzero(self.locals["dones"])
            )
        if self._group.ranks == 1:
            return not self._over()
        # SB3 has counted the envs of this rank. A rank that ends within a rollout would leave the others waiting.
        self.model.num_timesteps += (self._group.ranks - 1) * self._env.num_envs
        self.num_timesteps = self.model.num_timesteps
        return True

    def _on_rollout_end(self) -> None:
        super()._on_rollout_end()
        if self._group.ranks > 1:
            self._exchange()

    def _exchange(self) -> None:
        tiles, schedule = self._task.tiles, self.schedule
        levels = np.zeros((0, 2)) if tiles is None else tiles.level_sums()
        # Clocks of ranks differ, and that of rank 0 counts.
        agreed = np.array([self.stopped, self._over(), schedule.left if self._group.rank == 0 else 0.0])
        shared = np.concatenate([agreed, self._own, levels.ravel()])
        self._group.sum(torch.from_numpy(shared))
        agreed, own, levels = np.split(shared, [len(agreed), len(agreed) + len(self._own)])
        self.stopped, self.ended, schedule.left = bool(agreed[0]), bool(agreed[1]), float(agreed[2])
        own[:-1] /= self._group.ranks
        self._sums += own
        self._own[:] = 0.0
        self._levels = levels.reshape(-1, 2)
