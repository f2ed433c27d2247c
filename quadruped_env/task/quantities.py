"""Quantities that rewards and metrics share: pure functions of arrays (N, ...).

Reductions run along the last axis only, so that the value of an env does not depend on the number of envs.
"""

import math
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.utils.arrays import NUMPY, Namespace, frozen

_SMALLEST_COMMAND: Final = frozen(np.array([0.1, 0.2]))
"""Command below which `progress` is reduced in proportion, m/s and rad/s."""


def tracking_kernel(error: Any, std: Any, xp: Namespace = NUMPY) -> Any:
    """Score in (0, 1] of a tracking error: exp(-(error / std)^2). Elementwise, (N, 2)."""
    share = error / std
    return xp.exp(-(share * share))


def progress_scale(command: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Scale from velocity to share of the command, and the share that equals the whole command, for commands (N, 2).

    The whole is 1. Below `_SMALLEST_COMMAND` it is smaller, in proportion to the command.
    """
    size = np.maximum(np.abs(command), _SMALLEST_COMMAND)
    return np.sign(command) / size, np.abs(command) / size


def progress(share: Any, whole: Any, xp: Namespace = NUMPY) -> Any:
    """Share of a commanded velocity that is reached, in [-1, 1]; 0 for a zero command. Elementwise, (N, 2).

    It is linear, so it has a gradient at standstill, where a tracking kernel is flat. Above the commanded velocity it
    decreases as steeply as it increased.
    """
    return xp.maximum(share - xp.positive(share - whole) * 2.0, xp.minus_one)


def clock_agreement(lift: Any, clock_sine: Any, xp: Namespace = NUMPY) -> Any:
    """Agreement between foot heights and the gait clock (N,), in [-1, 1].

    Args:
        lift: 1 for a foot in the air, -1 on the ground, or a value between (N, L).
        clock_sine: positive while the foot should swing (N, L).
        xp: array functions.
    """
    return xp.dot(clock_sine, lift) * (1.0 / clock_sine.shape[-1])


class FootLift:
    """Lift of each foot (N, L): -1 on the ground, 1 at the full height and above, 1 - 2 (1 - height / full)^2 between.

    Unlike contact it is continuous, so a small increase in height already increases the reward. The slope is largest
    at the ground, so it does not pay to drag one foot and lift the others higher.

    Args:
        full: height of a full lift, m.
        xp: array functions.
    """

    def __init__(self, full: float, xp: Namespace = NUMPY) -> None:
        # Scaled so that the square of the missing height is 2 on the ground.
        self._top, self._scale = xp.constant(math.sqrt(2.0)), xp.constant(math.sqrt(2.0) / full)
        self._one = xp.constant(1.0)
        self._xp = xp

    def __call__(self, sole_height: Any) -> Any:
        """Lift (N, L) for heights (N, L) in m."""
        missing = self._xp.positive(self._top - sole_height * self._scale)
        return self._one - missing * missing


def mechanical_power(torque: Any, velocity: Any, xp: Namespace = NUMPY) -> Any:
    """Mechanical power of the motors (N,), W; negative power counts as zero."""
    return xp.sum(xp.positive(torque * velocity))


def electrical_power(torque: Any, velocity: Any, joule_coefficient: Any, xp: Namespace = NUMPY) -> Any:
    """Electrical power of the motors (N,), W: `mechanical_power`, and the heat in their windings.

    Args:
        torque: motor torques (N, J), N m.
        velocity: joint velocities (N, J), rad/s.
        joule_coefficient: heat per squared torque of each motor (J,), W/(N m)^2; `MotorConfig.joule_coefficients`.
        xp: array functions.
    """
    heat = xp.sum(torque * torque * joule_coefficient)
    return mechanical_power(torque, velocity, xp) + heat


def sliding_squared(foot_velocity: Any, foot_angular_velocity: Any, radius: Any) -> Any:
    """Squared horizontal velocity of each foot's lowest point (N, L), m^2/s^2.

    The lowest point of a ball that rolls without slipping is at rest: v + omega x (0, 0, -r).

    Args:
        foot_velocity: velocity of the ball's centre (N, L, 3), m/s.
        foot_angular_velocity: angular velocity of the foot (N, L, 3), rad/s.
        radius: r, m.
    """
    along_x = foot_velocity[..., 0] - foot_angular_velocity[..., 1] * radius
    along_y = foot_velocity[..., 1] + foot_angular_velocity[..., 0] * radius
    return along_x * along_x + along_y * along_y
