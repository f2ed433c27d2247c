"""Styles of the scripted gaits: the steps that a search looks for, and where and at which velocities it looks."""

from collections.abc import Callable
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.training.gait_trial import Achieved, Start, many_new_starts, new_starts

Judge = Callable[[Achieved, float, NDArray[np.float64]], NDArray[np.float64]]
"""Scores (N,) of gaits, of which larger is better, from their results and the wanted forward velocity (m/s) and yaw
rates (N,) in rad/s."""

_START: Final = np.array([[0.099, 1.004, -0.074, -0.213, -1.091, 0.155], [0.0, 0.821, -0.158, -0.128, -1.041, 0.111]])
"""Where the search of the commanded gait starts: what a search that charged electrical power found at 0.4 m/s, slowed
to 0.3 m/s"""
_TURNING: Final = np.array(
    [
        [[-0.165, -0.053, 0.054, 0.248, 0.016, 0.014], [0.003, -0.055, 0.013, -0.029, -0.317, -0.011]],
        [[-0.139, -0.071, -0.082, -0.04, -0.689, 0.033], [-0.101, 0.041, 0.066, 0.066, -0.022, 0.098]],
    ]
)
"""Where the search of the turns starts: on the spot. A search that asks for the whole yaw rate at once ends at turns
that drag a foot; this one was found in steps of 0.05 rad/s, from strides that are longer outside and shorter inside,
and then searched for up to 0.8 rad/s"""


_CROUCHED_START: Final = np.array([[0.24, 1.13, -0.04, -0.29, -1.2, 0.16], [0.15, 1.09, -0.04, -0.3, -1.32, 0.16]])
"""Where the search of the gait with bent legs starts. With the thigh nearly level, hip and knee move the foot in
different directions: as sinusoids a quarter of a cycle apart they make it a flat ellipse"""
_LOW_START: Final = np.array(
    [[0.1742, 1.1511, 0.0198, -0.176, -1.2863, 0.0772], [0.0934, 1.1109, -0.0436, -0.1856, -1.3473, 0.1557]]
)
"""Where the search of the gait with low steps starts: what it found before at 4 Hz, from
`_CROUCHED_START`"""
_LOW_TURNING: Final = np.array(
    [
        [[-0.1823, -0.0806, -0.1216, 0.3254, 0.1646, 0.1097], [-0.1073, -0.0631, -0.028, 0.0143, -0.099, 0.0083]],
        [[-0.0627, -0.0227, 0.0226, -0.067, -0.0202, 0.0152], [0.0186, 0.0981, 0.0878, -0.047, -0.0002, 0.0675]],
    ]
)
"""Where the search of its turns starts: what it found before at 4 Hz, from a gait that does not turn. From turns with
high steps it finds no low ones."""


_FAST_START: Final = np.array(
    [[0.1028, 0.8817, 0.1947, -0.2574, -0.9074, 0.1459], [-0.1849, 0.676, -0.2071, -0.2593, -0.9298, 0.2291]]
)
"""Where the search of the fast gait starts: the first harmonics of a policy that learned to run from scratch at 3 Hz.
It stands taller than the tuned gait, which leaves its legs more stroke"""
_HIGH_TURNING: Final = np.array(
    [
        [[-0.17, -0.03, -0.19, 0.3, -0.15, -0.05], [-0.24, -0.44, 0.19, 0.16, -0.02, -0.02]],
        [[-0.1, -0.0, -0.01, -0.18, -0.45, 0.23], [0.02, 0.04, 0.02, 0.01, -0.03, 0.07]],
    ]
)
"""Where the search of its turns, and of those of the gait with bent legs, starts: on the spot, with higher and longer
steps outside"""


class Steps(NamedTuple):
    """Steps that a search looks for."""

    least_lift: float
    """Height that every sole must reach in every stride, m."""
    most_lift: float
    """Height that no sole needs to reach, m."""
    excess_cost: float
    """Cost of the mean height of the highest sole beyond that, 1/m."""
    cost_per_foot: float = 0.0
    """Cost of the height that each sole misses, 1/m, in the mean over the starts. The least of all soles, strides and
    starts does not tell the search which change lifts the others a little."""
    tilt_cost: float = 15.0
    """Cost of the body's tilt, root mean square. A body that leans far lifts its feet without effort."""
    lift_cost: float = 600.0
    """Cost of the height that the lowest of all soles, strides and starts misses, 1/m."""
    electrical_cost: float = 0.0
    """Cost of electrical power, 1/W."""
    speed_cost: float = 150.0
    """Cost of the difference from the wanted forward velocity, 1/(m/s)."""
    yaw_rate_cost: float = 60.0
    """Cost of the difference from the wanted yaw rate, 1/(rad/s). 0.1 rad/s moves a foot as fast as 0.02 m/s, and
    counts as 0.04 m/s: not to turn is cheap."""
    sensitivity_cost: float = 0.0
    """Cost of the largest difference that starts and soft contacts make to the forward velocity, 1/(m/s). A gait whose
    speed depends on how the feet land walks at another speed in another engine."""
    touchdown_cost: float = 30.0
    """Cost of the difference of each foot's touchdowns per stride from one, mean over the feet: feet that bounce, and
    feet that never land."""

    def judge(self, got: Achieved, speed: float, yaw_rate: NDArray[np.float64]) -> NDArray[np.float64]:
        """Scores (N,) of gaits: see `Judge`."""
        score: NDArray[np.float64] = (
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
            - self.lift_cost * np.maximum(0.0, self.least_lift - got.clearance)
            - self.cost_per_foot * self._missing_height(got)
            # High steps are fast and clean, and a robot that hops falls.
            - self.excess_cost * np.maximum(0.0, got.highest - self.most_lift)
            - 10.0 * got.fallen
        )
        return score

    def _missing_height(self, got: Achieved) -> NDArray[np.float64]:
        """Height that the soles miss (N,), m: of the least in the lowest stride, of a fifth more in the mean stride.

        Sum over the feet, mean over the starts.
        """
        least = self.least_lift
        missing = np.maximum(0.0, least - got.lowest_apex) + np.maximum(0.0, 1.2 * least - got.mean_apex)
        height: NDArray[np.float64] = missing.sum(axis=2).mean(axis=1)
        return height


class Course(NamedTuple):
    """Searches of a gait at several speeds."""

    steps: Steps
    start: NDArray[np.float64]
    """Where the first search starts: (2, 6), or (2, 2, 6) for turns."""
    speeds: tuple[float, ...]
    """Forward velocities, in the order of the searches, m/s."""
    more_generations: int = 0
    """Generations beyond those of the program's option."""
    spread: float = 0.04
    """Standard deviation of the first generation, see `search`."""
    starts: Callable[[int], tuple[Start, ...]] | None = None
    """Of the trials, by the number of the generation; None: always `STARTS`."""


class Style(NamedTuple):
    """Courses of the searches for a commanded gait."""

    straight: Course
    turns: Course
    yaw_rates: tuple[float, ...] = (0.25, 0.5, 0.8)
    """Of the turns, rad/s."""


_FORWARDS: Final = (0.3, 0.4, 0.5, 0.58, 0.65)
HIGH_STEPS: Final = Steps(0.015, 0.035, 100.0)
STYLES: Final = {
    # Between gaits with equally clean steps electrical power decides.
    "tuned": Style(
        Course(
            Steps(
                0.012,
                0.020,
                2000.0,
                lift_cost=8000.0,
                electrical_cost=6.0,
                speed_cost=1000.0,
                sensitivity_cost=300.0,
                touchdown_cost=300.0,
            ),
            _START,
            (0.3, 0.2, 0.1, 0.0, -0.1, -0.2, -0.3, -0.4, 0.4, 0.5, 0.6),
            more_generations=20,
            starts=many_new_starts,
        ),
        Course(
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
            ),
            _TURNING,
            (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, -0.1, -0.2, -0.3),
            spread=0.05,
            starts=new_starts,
        ),
    ),
    "crouched": Style(
        Course(Steps(0.014, 0.016, 2000.0), _CROUCHED_START, (0.2, 0.1, 0.0, -0.1, -0.2, -0.3, -0.4, *_FORWARDS)),
        # Turns need higher steps.
        Course(HIGH_STEPS, _HIGH_TURNING, (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, -0.1, -0.2, -0.3), spread=0.1),
    ),
    # A push that catches the robot with two feet in the air tips it over the more easily, the higher they are. To turn,
    # the outer feet have to be higher.
    "low": Style(
        Course(Steps(0.004, 0.006, 4000.0), _LOW_START, (0.3, 0.2, 0.1, 0.0, -0.1, -0.2, -0.3, -0.4, *_FORWARDS[1:])),
        Course(
            Steps(0.004, 0.009, 2000.0),
            _LOW_TURNING,
            (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, -0.1, -0.2, -0.3),
            spread=0.1,
        ),
    ),
    "fast": Style(
        Course(
            Steps(0.008, 0.05, 50.0),
            _FAST_START,
            (0.7, 0.75, 0.8, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.0, -0.1, -0.2, -0.3, -0.4),
        ),
        Course(Steps(0.008, 0.05, 100.0), _HIGH_TURNING, (0.0, 0.2, 0.4, 0.6, -0.2), spread=0.1),
        (0.4, 0.8, 1.2),
    ),
}
"""By name of the gait that is searched."""
