"""Stand-up trajectory: slow joint targets from any pose, standing or lying, to the stance."""

from dataclasses import dataclass
from typing import Final, Self

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import LEG_NAMES, STANCE

UPRIGHT: Final = 0.6
"""Maximum angle between the trunk's vertical and a leg that can carry load, rad; larger angles are rare in walking."""
_FORWARD: Final = (-0.5, -1.1)
_BACK: Final = (1.5, 0.0)
"""Hip and knee positions of a leg that lies along the trunk, with the foot ahead or behind, rad."""
_OUTWARD: Final = np.array([_FORWARD if leg.endswith("F") else _BACK for leg in LEG_NAMES])
_SIDES: Final = [np.array([leg.startswith(side) for leg in LEG_NAMES]) for side in "LR"]


@dataclass(frozen=True)
class StandUp:
    """Joint trajectory to the stance, at rest at each of its waypoints.

    From upright legs it goes straight to the stance. A robot that went limp in mid-step lies on its front or on a
    side with feet under the trunk, and would roll over if it stood up from there. Therefore the legs first fold, each
    in the direction in which it points, which lowers the trunk onto the ground. Then the legs that point inward swing
    outward, first on one side and then on the other, while the other side prevents tipping. With the feet wide apart,
    the trunk stays level as it goes up.
    """

    points: NDArray[np.float64]
    """Joint positions at the waypoints (K, 8), rad."""
    times: NDArray[np.float64]
    """Times of the waypoints (K,), s."""

    @classmethod
    def plan(cls, start: NDArray[np.float64], speed: float, min_time: float) -> Self:
        """Trajectory from the current joint positions.

        Args:
            start: joint positions (8,), rad.
            speed: mean speed of the joint that moves farthest between two waypoints, rad/s.
            min_time: minimum time between two waypoints, s.
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
        distances = np.abs(np.diff(points, axis=0)).max(axis=1)
        return cls(np.array(points), np.concatenate([[0.0], np.cumsum(np.maximum(min_time, distances / speed))]))

    @property
    def duration(self) -> float:
        """Time until the stance is reached, s."""
        return float(self.times[-1])

    def positions(self, elapsed: float) -> NDArray[np.float64]:
        """Joint targets (8,) in rad at a time in s after the start."""
        now = min(max(elapsed, 0.0), self.duration)
        after = max(1, int(np.searchsorted(self.times, now)))
        share = (now - self.times[after - 1]) / (self.times[after] - self.times[after - 1])
        before = self.points[after - 1]
        return before + share * share * (3.0 - 2.0 * share) * (self.points[after] - before)
