"""Clearance and touchdowns of each foot in every stride of a robot that walks."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

_SWING_STEPS: Final = 3
"""Steps in the air that make a swing, as in the suite's measures."""


class Strides:
    """Largest height and touchdowns of each foot (N, 4) in its whole strides, as the steps come in.

    A stride starts with the swing, where the clock of the leg passes a multiple of 2 pi.
    """

    def __init__(self, n: int) -> None:
        self.count = np.zeros((n, 4))
        """Whole strides"""
        self.touchdowns = np.zeros((n, 4))
        """In whole strides"""
        self.apexes = np.zeros((n, 4))
        """Sum of the largest heights of all whole strides, m"""
        self.lowest_apex = np.full((n, 4), np.inf)
        """Largest height of the stride, or of the swing, in which it is smallest, m"""
        self._apex, self._landed = np.full((n, 4), -np.inf), np.zeros((n, 4))
        self._swing_apex, self._swing_steps = np.full((n, 4), -np.inf), np.zeros((n, 4))
        self._whole = np.zeros((n, 4), dtype=np.bool_)
        self._stride: NDArray[np.float64] | None = None

    def add(
        self,
        stride: NDArray[np.float64],
        height: NDArray[np.float64],
        contact: NDArray[np.bool_],
        before: NDArray[np.bool_],
    ) -> None:
        """One step: number of the stride, height of the soles in m, and contacts of this and the last step, (N, 4)."""
        landed = contact & ~before
        ended = np.zeros(stride.shape, dtype=np.bool_) if self._stride is None else stride > self._stride
        done = ended & self._whole  # the measurement starts within a stride
        self.count += done
        self.touchdowns += done * self._landed
        self.apexes += np.where(done, self._apex, 0.0)
        self.lowest_apex = np.where(done, np.minimum(self.lowest_apex, self._apex), self.lowest_apex)
        # A foot that bounces has a second, low swing in its stride.
        swung = landed & (self._swing_steps >= _SWING_STEPS) & self._whole
        self.lowest_apex = np.where(swung, np.minimum(self.lowest_apex, self._swing_apex), self.lowest_apex)
        self._swing_steps = np.where(contact, 0.0, self._swing_steps + 1.0)
        self._swing_apex = np.where(contact, -np.inf, np.maximum(self._swing_apex, height))
        self._whole |= ended
        self._apex = np.maximum(np.where(ended, -np.inf, self._apex), height)
        self._landed = np.where(ended, 0.0, self._landed) + landed
        self._stride = stride
