"""Samples of a viewed robot for plots and recordings."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.evaluation.trace import CommandedTrace, PerTerm, PositionPerLeg, Scalar, Velocity, measured
from quadruped_env.robot import Robot
from quadruped_env.robot.readings import Readings
from quadruped_env.simulation import Terrain


@dataclass(frozen=True, kw_only=True, eq=False)
class ViewedTrace(CommandedTrace):
    """Trace of a viewed robot, arrays (T, ...), or one of its samples, arrays (...)."""

    time: Scalar
    """Time since the start of the episode, s (T,)"""
    smooth_velocity: Velocity
    """Velocity averaged over about one gait cycle, m/s and rad/s (T, 2)"""
    foot_position: PositionPerLeg
    """Centre of each foot's sphere in the world frame, m (T, L, 3)"""
    reward_terms: PerTerm
    """Weighted terms of the last step, in the task's order (T, K); zeros at the start"""


def sample(robot: Robot, timestep: float, terrain: Terrain, readings: Readings, **values: NDArray[Any]) -> ViewedTrace:
    """One sample of a robot, copied.

    Args:
        robot: the robot.
        timestep: time between samples, s.
        terrain: ground below it.
        readings: its readings, of one env.
        values: quantity of a `ViewedTrace` -> (1, ...), besides those that readings state, or in their place.
    """
    both = {**measured(readings), "foot_position": readings.foot_position, **values}
    copies: dict[str, Any] = {name: np.array(value[0]) for name, value in both.items()}
    return ViewedTrace(robot=robot, timestep=timestep, terrain=terrain, **copies)
