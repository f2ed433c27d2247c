"""What differs from episode to episode, and the noise on what the robot measures."""

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import STANCE, STANCE_HEIGHT
from quadruped_env.simulation import Simulation
from quadruped_env.task.commands import between
from quadruped_env.task.config import RandomizationConfig

START_DRAWS: Final = 8 + 8 + 6 + 3 + 2
"""Uniform numbers in [0, 1) that one start takes: joints, joint velocities, base velocity, attitude, model."""

_SIGNED: Final = (-1.0, 1.0)
_START_CLEARANCE: Final = 0.01
"""m between the ground and the stance at the start, so that bent legs do not begin inside the ground."""


def start_states(
    draws: NDArray[np.float64], config: RandomizationConfig
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions (R, 15) and velocities (R, 14) to start episodes from, from uniform draws (R, START_DRAWS)."""
    offset = between(_SIGNED, draws[:, :25]) * config.start_scale
    qpos = np.zeros((len(draws), 15))
    qvel = np.empty((len(draws), 14))
    qpos[:, 2] = STANCE_HEIGHT + (_START_CLEARANCE if config.start_joint_position or config.start_tilt else 0.0)
    qpos[:, 3:7] = _quaternion(offset[:, 22:25])
    qpos[:, 7:] = STANCE + offset[:, 0:8]
    qvel[:, :6] = offset[:, 16:22]
    qvel[:, 6:] = offset[:, 8:16]
    return qpos, qvel


# Columns of (cos roll, cos pitch, cos yaw, sin roll, sin pitch, sin yaw), of half the angles: w, x, y and z are each
# the product of the first three factors, and plus or minus the product of the last three.
_FACTORS: Final = np.array(
    [[0, 3, 0, 0], [1, 1, 4, 1], [2, 2, 2, 5], [3, 0, 3, 3], [4, 4, 1, 4], [5, 5, 5, 2]], dtype=np.intp
)
_SIGNS: Final = np.array([1.0, -1.0, 1.0, -1.0])


def _quaternion(angles: NDArray[np.float64]) -> NDArray[np.float64]:
    """Quaternions wxyz (R, 4) of roll, pitch and yaw (R, 3) in rad, turned by yaw, then pitch, then roll."""
    half = angles / 2
    factors = np.concatenate([np.cos(half), np.sin(half)], axis=1)[:, _FACTORS]
    return factors[:, 0] * factors[:, 1] * factors[:, 2] + factors[:, 3] * factors[:, 4] * factors[:, 5] * _SIGNS


class ModelRandomizer:
    """Writes each row's own friction and payload into its model; does nothing where neither is randomized."""

    def __init__(self, simulation: Simulation, config: RandomizationConfig) -> None:
        self._config = config
        model = simulation.model
        self._simulation = simulation
        self._ground = model.geom("ground").id
        self._base = model.body("base_link").id
        self._mass = model.body_mass[self._base]
        self._inertia = model.body_inertia[self._base].copy()

    def apply(self, rows: NDArray[np.intp], draws: NDArray[np.float64]) -> None:
        """Draw the models of some rows (R,) from uniform draws (R, START_DRAWS)."""
        if self._config.friction is not None:
            # A contact takes the larger friction of its two geoms, so both sides are set.
            friction = self._simulation.model_field("geom_friction")
            friction[rows, :, 0] = between(self._config.friction, draws[:, 25])[:, None]
        if self._config.payload is not None:
            mass = self._mass + between(self._config.payload, draws[:, 26])
            self._simulation.model_field("body_mass")[rows, self._base] = mass
            self._simulation.model_field("body_inertia")[rows, self._base] = (mass / self._mass)[
                :, None
            ] * self._inertia


_GOLDEN: Final = np.uint64(0x9E3779B97F4A7C15)
_MIX_1: Final = np.uint64(0xBF58476D1CE4E5B9)
_MIX_2: Final = np.uint64(0x94D049BB133111EB)


def counter_noise(key: NDArray[Any], step: NDArray[np.int64], width: int) -> NDArray[np.float64]:
    """Uniform noise in [-1, 1), shape (N, width), that depends on each row's key (N,) and step (N,) alone.

    A hash of a counter (SplitMix64, Steele et al. 2014, https://doi.org/10.1145/2660193.2660195) in place of one
    generator call a row: it is drawn for all rows at once and has no state beyond the counter.
    """
    index = step.astype(np.uint64)[:, None] * np.uint64(width) + np.arange(1, width + 1, dtype=np.uint64)
    z: NDArray[Any] = key[:, None] + index * _GOLDEN
    z = (z ^ (z >> np.uint64(30))) * _MIX_1
    z = (z ^ (z >> np.uint64(27))) * _MIX_2
    z = z ^ (z >> np.uint64(31))
    # The top 53 bits, as NumPy's own generators make a double.
    return (z >> np.uint64(11)).astype(np.float64) * (2.0**-52) - 1.0
