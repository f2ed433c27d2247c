"""Quantities that rewards and metrics share: functions of arrays (N, ...).

Reductions run along the last axis only, so that the value of an env does not depend on the number of envs. Sums of
products are written as such: `np.vecdot`, `np.einsum` and `@` round as each processor does.
"""

import math

import numpy as np
from numpy.typing import NDArray

from quadruped_env.utils.arrays import Floats

Real = NDArray[np.floating]
"""Values that a metric may have in another precision."""


def clock_agreement(lift: Real, clock_sine: Real) -> Floats:
    """Return the agreement between foot heights and the gait clock (N,), in [-1, 1].

    The lift (N, L) is 1 for a foot in the air, -1 on the ground, or a value between; the sine of the clock (N, L) is
    positive while the foot should swing.
    """
    return np.add.reduce(clock_sine * lift, axis=-1) / clock_sine.shape[-1]


def foot_lift(sole_height: Floats, full: float | Floats) -> Floats:
    """Return the lift of each foot (N, L): 1 - 2 (1 - height / full)^2, at least -1; 1 at the full height.

    Unlike contact it is continuous, so a small increase in height already increases the reward. The slope is largest
    at the ground, so it does not pay to drag one foot and lift the others higher. Beyond the full height it falls
    again: a foot that is thrown up gains nothing. Heights over the ground are in m.
    """
    # Scaled so that the square of the missing height is 2 on the ground.
    root = math.sqrt(2.0)
    missing = root - sole_height * (root / full)
    return np.maximum(1.0 - missing**2, -1.0)


def mechanical_power(torque: Real, velocity: Real) -> Floats:
    """Return the power (...,), W, of torques in N m and velocities in rad/s (..., J); negative power is zero."""
    return np.add.reduce(np.maximum(torque * velocity, 0.0), axis=-1)


def electrical_power(torque: Real, velocity: Real, joule_coefficient: Floats) -> Floats:
    """Return the electrical power of the motors (...,), W: `mechanical_power`, and the heat in their windings.

    The heat per squared torque of each motor (J,) is in W/(N m)^2, as in `MotorConfig.joule_coefficients`.
    """
    return mechanical_power(torque, velocity) + np.add.reduce(torque**2 * joule_coefficient, axis=-1)


def mean_over_steps(values: Floats) -> Floats:
    """Return the mean (N, ...) over physics steps of values (S, N, ...)."""
    # One by one, as `accumulate` adds: `sum` adds the values of a single env in pairs.
    return np.add.accumulate(values, axis=0)[-1] / len(values)


def sliding_squared(foot_velocity: Floats, foot_angular_velocity: Floats, radius: float) -> Floats:
    """Return the squared horizontal velocity of each foot's lowest point (..., L), m^2/s^2.

    The lowest point of a ball that rolls without slipping is at rest: v + omega x (0, 0, -r), with the velocity v of
    its centre in m/s and the angular velocity omega in rad/s (..., L, 3), and the radius r in m.
    """
    along_x = foot_velocity[..., 0] - foot_angular_velocity[..., 1] * radius
    along_y = foot_velocity[..., 1] + foot_angular_velocity[..., 0] * radius
    return along_x**2 + along_y**2
