"""Joint positions as waves, and their mapping from the robot on which the presets were tuned to another one.

A joint's wave at its leg's angle a is sine * sin(a) + cosine * cos(a) + offset.
"""

import math

import numpy as np
from numpy.typing import NDArray

from quadruped_env.gait.presets import LEG_PHASES, TUNED_ON
from quadruped_env.robot.corners import corners, leg_jacobians
from quadruped_env.robot.robot import Robot

Waves = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]
"""Sine part, cosine part and offset of joint positions (..., J), rad."""


def joint_phases(robot: Robot, gait: str = "trot") -> NDArray[np.float64]:
    """Phase of each joint's leg in a gait of `LEG_PHASES` (J,), rad."""
    phases = np.array([LEG_PHASES[gait][corner] for corner in corners(robot)])
    return np.repeat(phases * math.tau, 2)


def leg_maps(robot: Robot) -> NDArray[np.float64] | None:
    """Matrix (2, 2) of each leg from a change of hip and knee of the tuned robot to one of this robot (L, 2, 2).

    Both move the foot by the same distance forwards and upwards. None for the tuned robot itself.
    """
    if robot == TUNED_ON:
        return None
    own, tuned = leg_jacobians(robot), leg_jacobians(TUNED_ON)[list(corners(robot))]
    return np.array(np.linalg.solve(own, tuned), dtype=np.float64)


def map_waves(
    robot: Robot,
    maps: NDArray[np.float64] | None,
    sine: NDArray[np.float64],
    cosine: NDArray[np.float64],
    offset: NDArray[np.float64],
) -> Waves:
    """Waves of the tuned robot's joints (..., J), in the order of a robot's legs, mapped to that robot."""
    if maps is None:
        return sine, cosine, offset
    tuned_stance = TUNED_ON.stance.reshape(-1, 2)[list(corners(robot))].ravel()

    def apply(change: NDArray[np.float64]) -> NDArray[np.float64]:
        legs = change.reshape(*change.shape[:-1], robot.num_legs, 2)
        return np.einsum("lij,...lj->...li", maps, legs).reshape(change.shape)

    return apply(sine), apply(cosine), robot.stance + apply(offset - tuned_stance)


def wave_positions(
    phase: NDArray[np.float64],
    phases: NDArray[np.float64],
    sine: NDArray[np.float64],
    cosine: NDArray[np.float64],
    offset: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Joint positions (N, J) in rad at gait phases (N,) in rad.

    Args:
        phase: phase of the gait, (N,), rad.
        phases: result of `joint_phases`, (J,), rad.
        sine: sine part of each joint, as all three from `CommandedGait.waves`, (N, J), rad.
        cosine: cosine part, (N, J), rad.
        offset: offset, (N, J), rad.
    """
    angle = phase[:, None] + phases
    return sine * np.sin(angle) + cosine * np.cos(angle) + offset
