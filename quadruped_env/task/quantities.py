"""Quantities that rewards and metrics share: pure functions of arrays (N, ...).

Reductions run along the last axis only, so that an env's value does not depend on how many envs there are.
"""

import math
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.arrays import NUMPY, Namespace

_SMALLEST_COMMAND: Final = np.array([0.1, 0.2])
"""m/s and rad/s below which `progress` no longer pays in full."""


def tracking_kernel(error: Any, std: Any, xp: Namespace = NUMPY) -> Any:
    """Score in (0, 1] of a tracking error: 1 without one, 1/e at an error of std. Elementwise, (N, 2)."""
    share = error / std
    return xp.exp(-(share * share))


def progress_scale(command: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Share of the command per velocity, and the share that is the whole command, for commands (N, 2).

    The whole is 1, and less below `_SMALLEST_COMMAND`, where a command counts in proportion.
    """
    size = np.maximum(np.abs(command), _SMALLEST_COMMAND)
    return np.sign(command) / size, np.abs(command) / size


def progress(share: Any, whole: Any, overshoot: Any, xp: Namespace = NUMPY) -> Any:
    """Share of a commanded velocity that is reached, in [-1, 1]; 0 where none is commanded. Elementwise, (N, 2).

    Linear, so it shows the way from standing, where a tracking kernel is flat. `overshoot` is the slope of the penalty
    beyond the whole, relative to the slope below: 1 stays at the whole, 2 makes the penalty as steep as the reward.
    """
    return xp.maximum(share - overshoot * xp.positive(share - whole), xp.minus_one)


def clock_agreement(lift: Any, clock_sine: Any, xp: Namespace = NUMPY) -> Any:
    """Agreement of the feet with the gait clock, in [-1, 1], shape (N,).

    Args:
        lift: 1 for a foot in the air, -1 on the ground, or anything between (N, L).
        clock_sine: positive while the foot should swing (N, L).
        xp: the arrays' functions.
    """
    return xp.dot(clock_sine, lift) * (1.0 / clock_sine.shape[-1])


class FootLift:
    """Height of each sole over the ground: -1 on the ground to 1 at a full lift and above, shape (N, L).

    Smooth where contact is a switch, so that a little more lift already pays; and bent, 1 - 2 (1 - height / full)^2, so
    that the first millimetres pay most and no foot is left dragging for the sake of the others.

    Args:
        full: m.
        xp: the arrays' functions.
    """

    def __init__(self, full: float, xp: Namespace = NUMPY) -> None:
        # Such that the square of what is missing is 2 on the ground.
        self._top, self._scale = xp.constant(math.sqrt(2.0)), xp.constant(math.sqrt(2.0) / full)
        self._one = xp.constant(1.0)
        self._xp = xp

    def __call__(self, sole_height: Any) -> Any:
        """For heights (N, L) in m."""
        missing = self._xp.positive(self._top - sole_height * self._scale)
        return self._one - missing * missing


def mechanical_power(torque: Any, velocity: Any, xp: Namespace = NUMPY) -> Any:
    """Power that the motors put in, W, shape (N,); braking gives nothing back."""
    return xp.sum(xp.positive(torque * velocity))


def sliding_squared(foot_velocity: Any, foot_angular_velocity: Any, sole: Any, xp: Namespace = NUMPY) -> Any:
    """Squared horizontal velocity of each foot's lowest point, m^2/s^2, shape (N, L).

    The lowest point of a ball that rolls without slipping is at rest: v + omega x (0, 0, -r).

    Args:
        foot_velocity: of the ball's centre, m/s (N, L, 3).
        foot_angular_velocity: rad/s (N, L, 3).
        sole: (-r, r) in m, which turns angular velocity about (y, x) into velocity along (x, y).
        xp: the arrays' functions.
    """
    sliding = foot_velocity[..., :2] + xp.reverse(foot_angular_velocity[..., :2]) * sole
    return xp.dot(sliding, sliding)
