"""Getting up: joint targets over time, from however the robot stands or lies to the stance, slowly."""

from dataclasses import dataclass
from typing import Final, Self

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import LEG_NAMES, STANCE

UPRIGHT: Final = 0.6
"""rad between a leg and the trunk's vertical within which it carries; a walking robot's legs seldom lean more"""
_FORWARD: Final = (-0.5, -1.1)
_BACK: Final = (1.5, 0.0)
"""Hip and knee in rad of a leg that lies along the trunk, foot ahead or behind"""
_OUTWARD: Final = np.array([_FORWARD if leg.endswith("F") else _BACK for leg in LEG_NAMES])
_SIDES: Final = [np.array([leg.startswith(side) for leg in LEG_NAMES]) for side in "LR"]


@dataclass(frozen=True)
class StandUp:
    """The way of the joints to the stance, from rest to rest at each point of it.

    From upright legs it leads straight there. A robot that was let go in mid-step lies as it fell, on its nose or a
    flank and with feet under the trunk, and would roll over them if it rose from there. So its legs first fold, each
    the way that it points, which lays the trunk on the ground; then those that point inward swing outward, on one side
    and then on the other, while the other side keeps it from tipping; and from feet wide apart it rises level.
    """

    points: NDArray[np.float64]
    """Joint positions, rad (K, 8)"""
    times: NDArray[np.float64]
    """s at which it is there, (K,)"""

    @classmethod
    def plan(cls, start: NDArray[np.float64], speed: float, least: float) -> Self:
        """The way from joint positions (8,) in rad, at a mean speed in rad/s of the joint with the longest way.

        From point to point it takes `least` s at least.
        """
        points = [start.copy()]
        lean = start.reshape(len(LEG_NAMES), 2).sum(axis=1)
        if np.abs(lean).max() > UPRIGHT:
            legs = np.where(lean[:, None] > 0.0, _BACK, _FORWARD)
            points.append(legs.ravel())
            for side in _SIDES:
                legs = np.where(side[:, None], _OUTWARD, legs)
                if not np.array_equal(legs.ravel(), points[-1]):
                    points.append(legs.ravel())
        points.append(STANCE)
        ways = np.abs(np.diff(points, axis=0)).max(axis=1)
        return cls(np.array(points), np.concatenate([[0.0], np.cumsum(np.maximum(least, ways / speed))]))

    @property
    def duration(self) -> float:
        """Seconds until all joints are there."""
        return float(self.times[-1])

    def positions(self, elapsed: float) -> NDArray[np.float64]:
        """Joint targets (8,) in rad, a time in s after the start."""
        now = min(max(elapsed, 0.0), self.duration)
        after = max(1, int(np.searchsorted(self.times, now)))
        share = (now - self.times[after - 1]) / (self.times[after] - self.times[after - 1])
        before = self.points[after - 1]
        return before + share * share * (3.0 - 2.0 * share) * (self.points[after] - before)
