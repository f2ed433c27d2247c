"""Stand-up trajectory: slow joint targets from any pose, standing or lying, to the stance."""

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from quadruped_env.robot.corners import postures_with_feet_at
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats

UPRIGHT: Final = 0.6
"""Maximum angle between the trunk's vertical and a leg that can carry load, rad; larger angles are rare in walking."""


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
        """Trajectory from the current joint positions (J,) in rad.

        Between two waypoints the joint that moves farthest has a mean speed in rad/s, for a minimum time in s.
        """
        points = [start.copy()]
        legs = np.array(robot.leg_joints)
        hips, feet = robot.skeleton.joint_frames(start)[0][legs[:, -2]], robot.skeleton.foot_centres(start)
        down = hips[:, 2] - feet[:, 2]
        if np.arctan2(np.linalg.norm((feet - hips)[:, :2], axis=1), down).max() > UPRIGHT:
            ahead, behind = _along_the_trunk(robot)
            outward = np.where(robot.fore_legs[:, None], ahead[legs], behind[legs])
            folded = np.where((feet < hips)[:, :1], behind[legs], ahead[legs])
            for moved in (np.zeros(len(legs), dtype=np.bool_), robot.left_legs, ~robot.left_legs):
                folded = np.where(moved[:, None], outward, folded)
                point = start.copy()
                point[legs] = folded
                if not np.array_equal(point, points[-1]):
                    points.append(point)
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


def _along_the_trunk(robot: Robot) -> Floats:
    """Return joint positions (2, J) in rad with all legs along the trunk: the feet ahead of the hips, and behind."""
    stance, legs = robot.skeleton.foot_centres(robot.stance), np.array(robot.leg_joints)
    hips = robot.skeleton.joint_frames(robot.stance)[0][legs[:, -2]]
    feet = np.tile(np.stack([hips[:, 0], stance[:, 1], hips[:, 2]], axis=1), (2, 1, 1))
    feet[:, :, 0] += np.multiply.outer([1.0, -1.0], hips[:, 2] - stance[:, 2])
    return postures_with_feet_at(robot, feet)
