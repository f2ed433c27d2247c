"""Stand-up trajectory: slow joint targets from any pose, standing or lying, to the stance."""

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats

UPRIGHT: Final = 0.6
"""Maximum angle between the trunk's vertical and a leg that can carry load, rad; larger angles are rare in walking."""
_FORWARD: Final = (-0.5, -1.1)
_BACK: Final = (1.5, 0.0)
"""Hip and knee positions of a leg that lies along the trunk, with the foot ahead or behind, rad."""


@dataclass(frozen=True)
class StandUp:
    """Joint trajectory to the stance, at rest at each of its waypoints.

    From upright legs it goes straight to the stance. A robot that went limp in mid-step lies on its front or on a
    side with feet under the trunk, and would roll over if it stood up from there. Therefore the legs first fold, each
    in the direction in which it points, which lowers the trunk onto the ground. Then the legs that point inward swing
    outward, first on one side and then on the other, while the other side prevents tipping. With the feet wide apart,
    the trunk stays level as it goes up.
    """

    points: Floats
    """Joint positions at the waypoints (K, J), rad."""
    times: Floats
    """Times of the waypoints (K,), s."""

    @classmethod
    def plan(cls, robot: Robot, start: Floats, speed: float, min_time: float) -> Self:
        """Trajectory from the current joint positions.

        Args:
            robot: robot that stands up; each of its legs has a hip and a knee.
            start: joint positions (J,), rad.
            speed: mean speed of the joint that moves farthest between two waypoints, rad/s.
            min_time: minimum time between two waypoints, s.
        """
        points = [start.copy()]
        lean = start.reshape(robot.num_legs, 2).sum(axis=1)
        if np.abs(lean).max() > UPRIGHT:
            outward = np.where(robot.fore_legs[:, None], _FORWARD, _BACK)
            legs = np.where(lean[:, None] > 0.0, _BACK, _FORWARD)
            points.append(legs.ravel())
            for side in (robot.left_legs, ~robot.left_legs):
                legs = np.where(side[:, None], outward, legs)
                if not np.array_equal(legs.ravel(), points[-1]):
                    points.append(legs.ravel())
            points[1:] = [np.clip(point, robot.joint_position_low, robot.joint_position_high) for point in points[1:]]
        points.append(robot.stance)
        distances = np.abs(np.diff(points, axis=0)).max(axis=1)
        return cls(np.array(points), np.concatenate([[0.0], np.cumsum(np.maximum(min_time, distances / speed))]))

    @property
    def duration(self) -> float:
        """Time until the stance is reached, s."""
        return float(self.times[-1])

    def positions(self, elapsed: float) -> Floats:
        """Joint targets (J,) in rad at a time in s after the start."""
        now = min(max(elapsed, 0.0), self.duration)
        after = max(1, int(np.searchsorted(self.times, now)))
        share = (now - self.times[after - 1]) / (self.times[after] - self.times[after - 1])
        before = self.points[after - 1]
        return before + share * share * (3.0 - 2.0 * share) * (self.points[after] - before)
