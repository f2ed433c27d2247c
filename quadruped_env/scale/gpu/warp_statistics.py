"""Statistics of a training on a GPU, which stay there until they are logged or ranks exchange them."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.training.step_statistics import StepStatistics


class WarpStatistics(StepStatistics):
    """`StepStatistics` of a `WarpVecEnv`; between rollouts nothing is copied to the host."""

    _env: Any

    def _clear(self) -> None:
        super()._clear()
        self._clear_device()

    def _clear_device(self) -> None:
        like = self._task.simulation.sensordata
        self._squares: Any = np.zeros(2, like=like)
        self._terms: Any = np.zeros(len(self._task.term_names), like=like)
        self._falls_before = float(self._env.falls[0])

    def _on_step(self) -> bool:
        error = self._task.tracking_error
        self._squares += (error * error).mean(axis=0)
        self._terms += self._env.last_terms.mean(axis=0)
        self._steps += 1
        # A rank that ends within a rollout would leave the others waiting.
        return self._group.ranks > 1 or not self._over()

    def _exchange(self) -> None:
        self._own[:] = np.concatenate([np.ravel(part) for part in self._device_sums()])
        self._clear_device()
        super()._exchange()

    @property
    def sums(self) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
        """See `StepStatistics.sums`."""
        return self._device_sums() if self._group.ranks == 1 else super().sums

    def _device_sums(self) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
        return self._squares.numpy(), self._terms.numpy(), float(self._env.falls[0]) - self._falls_before
