"""Joint positions as waves, and their mapping from the robot on which the presets were tuned to another one.

A joint's wave at its leg's angle a is sine * sin(a) + cosine * cos(a) + offset.
"""

import math
from typing import Final

import numpy as np

from quadruped_env.gait.gait_presets import LEG_PHASES, TUNED_ON
from quadruped_env.robot.corners import check_bent_legs, corners, postures_with_feet_at
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.utils.arrays import Floats

Waves = tuple[Floats, Floats, Floats]
"""Sine part, cosine part and offset of joint positions (..., J), rad."""


_SAMPLES: Final = 12
"""Samples of a cycle."""


def joint_phases(robot: Robot, gait: str = "trot") -> Floats:
    """Phase of each joint's leg in a gait of `LEG_PHASES` (J,), rad."""
    phases = np.empty(robot.num_joints)
    for joints, phase in zip(robot.leg_joints, leg_phases(robot, gait), strict=True):
        phases[list(joints)] = phase
    return phases


def leg_phases(robot: Robot, gait: str = "trot") -> Floats:
    """Phase of each leg in a gait of `LEG_PHASES` (L,), rad."""
    return np.array([LEG_PHASES[gait][corner] for corner in corners(robot)]) * math.tau


def map_waves(robot: Robot, sine: Floats, cosine: Floats, offset: Floats) -> Waves:
    """Waves of the tuned robot's joints (..., J), in the order of a robot's legs, mapped to that robot.

    Its feet make the same motions about its stance, in proportion to its height and as nearly as sinusoids can: inverse
    kinematics gives the joint positions of a cycle, and projection their waves.

    Raises:
        QuadrupedError: if the robot has not one leg with hip and knee in each corner, or a straight one in the stance.
    """
    if robot == TUNED_ON:
        return sine, cosine, offset
    check_bent_legs(robot)
    legs = list(corners(robot))
    angle = math.tau * np.arange(_SAMPLES).reshape(-1, *(1,) * np.ndim(sine)) / _SAMPLES
    joints = (sine * np.sin(angle) + cosine * np.cos(angle) + offset).reshape(-1, robot.num_legs, 2)
    # The tuned robot's legs are in the order of the corners.
    feet = TUNED_ON.skeleton.foot_centres(joints[:, np.argsort(legs)].reshape(len(joints), -1))
    away = scale_of("m", robot) * (feet - TUNED_ON.skeleton.foot_centres(TUNED_ON.stance))[:, legs, ::2]
    mapped = postures_with_feet_at(robot, robot.skeleton.foot_centres(robot.stance)[:, ::2] + away)
    mapped = mapped.reshape(_SAMPLES, *np.shape(sine))
    wave = 2.0 / _SAMPLES
    return wave * (mapped * np.sin(angle)).sum(0), wave * (mapped * np.cos(angle)).sum(0), mapped.mean(0)


def wave_positions(phase: Floats, phases: Floats, sine: Floats, cosine: Floats, offset: Floats) -> Floats:
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
