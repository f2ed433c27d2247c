"""`JointState`: the state of all joints at one time."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class JointState:
    """One row of a trajectory: in ROS, a `sensor_msgs/JointState`."""

    stamp: int
    """ns"""
    names: tuple[str, ...]
    """(J,)"""
    position: NDArray[np.float64]
    """rad (J,)"""
    velocity: NDArray[np.float64] | None
    """rad/s (J,)"""
    effort: NDArray[np.float64] | None
    """N m (J,); NaN where it was not measured"""
