"""Styles of the scripted gaits: the steps that a search looks for, and at which velocities it looks.

Numbers hold for the robot on which the presets were tuned; `Scale` converts them for another.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np

from gait_search.trial import Achieved
from quadruped_env.utils.arrays import Floats


@dataclass(frozen=True)
class Steps:
    """Steps that a search looks for, and their costs."""

    least_lift: float
    """Height that every sole must reach in every stride, m."""
    most_lift: float
    """Height that no sole needs to reach, m. High steps are fast and clean, but a robot that hops falls."""
    excess_cost: float
    """Of the mean height of the highest sole beyond that, 1/m."""
    cost_per_foot: float = 0.0
    """Of the height that each sole misses, 1/m, in the mean over the starts. The least of all soles, strides and
    starts does not tell the search which change lifts the others a little."""
    tilt_cost: float = 15.0
    """Of the body's tilt. A body that leans far lifts its feet without effort."""
    lift_cost: float = 600.0
    """Of the height that the lowest of all soles, strides and starts misses, 1/m."""
    electrical_cost: float = 0.0
    """Of electrical power, 1/W."""
    speed_cost: float = 150.0
    """Of the difference from the wanted forward velocity, 1/(m/s)."""
    yaw_rate_cost: float = 60.0
    """Of the difference from the wanted yaw rate, 1/(rad/s). 0.1 rad/s moves a foot as fast as 0.02 m/s, and counts as
    0.04 m/s: not to turn is cheap."""
    sensitivity_cost: float = 0.0
    """Of the largest difference that starts and soft contacts make to the forward velocity, 1/(m/s). A gait whose
    speed depends on how the feet land walks at another speed in another engine."""
    touchdown_cost: float = 30.0
    """Of the difference of each foot's touchdowns per stride from one: feet that bounce, and feet that never land."""
    more_generations: int = 0
    """Seeds of the search, beyond the program's option."""
    spread: float = 0.04
    """Standard deviation of the search's first generation, rad; in turns at the largest yaw rate."""
    draws: int = 0
    """Number of times that `draw_starts` gives new starts in each generation; 0: always the same starts."""

    def score(self, got: Achieved, speed: float, yaw_rate: Floats) -> Floats:
        """Scores (N,) of gaits, of which larger is better, for a forward velocity (m/s) and yaw rates (N,) in rad/s."""
        least = self.least_lift
        # A fifth more in the mean stride than in the lowest.
        missing = np.maximum(0.0, least - got.lowest_apex) + np.maximum(0.0, 1.2 * least - got.mean_apex)
        score: Floats = (
            -self.speed_cost * np.abs(got.forward_velocity - speed)
            - self.yaw_rate_cost * np.abs(got.yaw_rate - yaw_rate)
            - self.sensitivity_cost * (got.forward_velocity_spread + 0.4 * got.yaw_rate_spread)
            - 4.0 * np.abs(got.lateral_velocity)
            - self.tilt_cost * got.tilt
            - 0.1 * got.power
            - self.electrical_cost * got.electrical_power
            - 2.0 * got.slip
            # Without the clock slow gaits shuffle on all four feet, and the two sides of a turn fall out of step.
            + 5.0 * got.clock
            + 2.0 * got.lift
            - self.touchdown_cost * got.touchdown_error
            - self.lift_cost * np.maximum(0.0, least - got.clearance)
            - self.cost_per_foot * missing.sum(axis=2).mean(axis=1)
            - self.excess_cost * np.maximum(0.0, got.highest - self.most_lift)
            - 10.0 * got.fallen
        )
        return score


@dataclass(frozen=True)
class Style:
    """Searches for a gait that follows a velocity command."""

    straight: Steps
    turns: Steps
    speeds: tuple[float, ...]
    """Forward velocities of the straight gaits, m/s."""
    turning_speeds: tuple[float, ...] = (-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5)
    """Forward velocities of the turns, m/s."""
    yaw_rates: tuple[float, ...] = (0.25, 0.5, 0.8)
    """Of the turns, rad/s."""


_BACK: Final = (-0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2)
HIGH_STEPS: Final = Steps(0.015, 0.035, 100.0)
STYLES: Final = {
    # Between gaits with equally clean steps electrical power decides. Near the motors' top speed a few starts lead a
    # gait astray that walks well from others, so there are many.
    "tuned": Style(
        Steps(
            0.012,
            0.020,
            2000.0,
            lift_cost=8000.0,
            electrical_cost=6.0,
            speed_cost=1000.0,
            sensitivity_cost=300.0,
            touchdown_cost=300.0,
            more_generations=20,
            draws=3,
        ),
        Steps(
            0.010,
            0.025,
            400.0,
            cost_per_foot=800.0,
            tilt_cost=30.0,
            speed_cost=300.0,
            yaw_rate_cost=180.0,
            sensitivity_cost=150.0,
            touchdown_cost=120.0,
            spread=0.05,
            draws=1,
        ),
        (*_BACK, 0.3, 0.4, 0.5, 0.6),
    ),
    # Turns need higher steps.
    "crouched": Style(
        Steps(0.014, 0.016, 2000.0), Steps(0.015, 0.035, 100.0, spread=0.1), (*_BACK, 0.3, 0.4, 0.5, 0.58, 0.65)
    ),
    # A push that catches the robot with two feet in the air tips it over the more easily, the higher they are. To turn,
    # the outer feet have to be higher.
    "low": Style(
        Steps(0.004, 0.006, 4000.0), Steps(0.004, 0.009, 2000.0, spread=0.1), (*_BACK, 0.3, 0.4, 0.5, 0.58, 0.65)
    ),
    "fast": Style(
        Steps(0.008, 0.05, 50.0),
        Steps(0.008, 0.05, 100.0, spread=0.1),
        (*_BACK, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8),
        (-0.2, 0.0, 0.2, 0.4, 0.6),
        (0.4, 0.8, 1.2),
    ),
}
"""By name of the gait that is searched."""
