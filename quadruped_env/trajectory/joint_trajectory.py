"""The one trajectory type: joint states over time."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class JointState:
    """One row of a trajectory."""

    stamp: int
    names: tuple[str, ...]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64] | None
    effort: NDArray[np.float64] | None


class JointTrajectory:
    """Joint states over time."""

    def positions_at(self, seconds: ArrayLike) -> NDArray[np.float64]:
        """Joint positions (..., 8) in rad, in the order of `JOINT_NAMES`, at times (...,) in s from the first stamp."""
        raise NotImplementedError
