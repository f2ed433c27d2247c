"""Quantities that rewards and metrics share: functions of arrays (N, ...).

Reductions run along the last axis only, so that the value of an env does not depend on the number of envs.
"""

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.utils.arrays import dot, frozen

Floats = NDArray[np.float64]
Real = NDArray[np.floating]
"""Values that a metric may have in another precision."""

_SMALLEST_COMMAND: Final = frozen(np.array([0.1, 0.2]))
"""Command below which `progress` is reduced in proportion, m/s and rad/s."""


def tracking_kernel(error: Floats, std: Floats | float) -> Floats:
    """Score in (0, 1] of a tracking error: exp(-(error / std)^2). Elementwise, (N, 2)."""
    share = error / std
    return np.exp(-(share * share))


def progress_scale(command: Floats) -> tuple[Floats, Floats]:
    """Scale from velocity to share of the command, and the share that equals the whole command, for commands (N, 2).

    The whole is 1. Below `_SMALLEST_COMMAND` it is smaller, in proportion to the command.
    """
    size = np.maximum(np.abs(command), _SMALLEST_COMMAND)
    return np.sign(command) / size, np.abs(command) / size


def progress(share: Floats, whole: Floats) -> Floats:
    """Share of a commanded velocity that is reached, in [-1, 1]; 0 for a zero command. Elementwise, (N, 2).

    It is linear, so it has a gradient at standstill, where a tracking kernel is flat. Above the commanded velocity it
    decreases as steeply as it increased.
    """
    return np.maximum(share - 2.0 * np.maximum(share - whole, 0.0), -1.0)


def clock_agreement(lift: Real, clock_sine: Real) -> Floats:
    """Agreement between foot heights and the gait clock (N,), in [-1, 1].

    Args:
        lift: 1 for a foot in the air, -1 on the ground, or a value between (N, L).
        clock_sine: positive while the foot should swing (N, L).
    """
    return dot(clock_sine, lift) * (1.0 / clock_sine.shape[-1])


def foot_lift(sole_height: Floats, full: float) -> Floats:
    """Lift of each foot (N, L): -1 on the ground, 1 at the full height and above, 1 - 2 (1 - height / full)^2 between.

    Unlike contact it is continuous, so a small increase in height already increases the reward. The slope is largest
    at the ground, so it does not pay to drag one foot and lift the others higher.

    Args:
        sole_height: height of each foot over the ground (N, L), m.
        full: height of a full lift, m.
    """
    # Scaled so that the square of the missing height is 2 on the ground.
    root = math.sqrt(2.0)
    missing = np.maximum(root - sole_height * (root / full), 0.0)
    return 1.0 - missing * missing


def mechanical_power(torque: Real, velocity: Real) -> Floats:
    """Mechanical power of the motors (N,), W; negative power counts as zero."""
    power: Floats = np.add.reduce(np.maximum(torque * velocity, 0.0), axis=-1)
    return power


def electrical_power(torque: Real, velocity: Real, joule_coefficient: Floats) -> Floats:
    """Electrical power of the motors (N,), W: `mechanical_power`, and the heat in their windings.

    Args:
        torque: motor torques (N, J), N m.
        velocity: joint velocities (N, J), rad/s.
        joule_coefficient: heat per squared torque of each motor (J,), W/(N m)^2; `MotorConfig.joule_coefficients`.
    """
    return mechanical_power(torque, velocity) + dot(torque * torque, joule_coefficient)


def sliding_squared(foot_velocity: Floats, foot_angular_velocity: Floats, radius: float) -> Floats:
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
