"""Getting up: joint targets over time, from wherever the joints are to the stance, slowly."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import JOINT_NAMES, STANCE

FAR = 0.5
"""rad from the stance; from further away the hips move before the knees"""
_KNEE = np.array(["knee" in name for name in JOINT_NAMES])


@dataclass(frozen=True)
class Rise:
    """The way of the joints to the stance; it begins and ends at rest.

    The legs swing fore and aft only. A robot that was let go lies with its feet far from under it, and would fall over
    them if it rose from there: so the hips bring the legs under it first, and then the knees lift it.
    """

    start: NDArray[np.float64]
    """rad (8,)"""
    time: float
    """s that a joint takes"""
    delay: NDArray[np.float64]
    """s after which each joint begins, (8,)"""

    @classmethod
    def plan(cls, start: NDArray[np.float64], speed: float, least: float) -> "Rise":
        """The way from joint positions (8,) in rad, at a mean speed in rad/s of the joint with the longest way.

        A joint takes `least` s at least.
        """
        way = float(np.abs(STANCE - start).max())
        time = max(least, way / speed)
        delay = np.zeros(len(JOINT_NAMES))
        if way > FAR:
            delay[_KNEE] = time
        return cls(start.copy(), time, delay)

    @property
    def duration(self) -> float:
        """Seconds until all joints are there."""
        return float(self.delay.max() + self.time)

    def positions(self, elapsed: float) -> NDArray[np.float64]:
        """Joint targets (8,) in rad, a time in s after the start."""
        share = np.clip((elapsed - self.delay) / self.time, 0.0, 1.0)
        return self.start + share * share * (3.0 - 2.0 * share) * (STANCE - self.start)
