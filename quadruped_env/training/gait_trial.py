"""Trials of open-loop gaits: what many of them reach on flat ground, in parallel."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import TaskConfig
from quadruped_env.task.quantities import FootLift, clock_agreement, mechanical_power, sliding_squared

ROBOT: Final = MINI_QUADRUPED
"""Robot whose gaits are searched."""
CONTROL_TIMESTEP: Final = TaskConfig().control_timestep
SUBSTEPS: Final = TaskConfig().decimation
WARM_UP: Final = 1.0
"""Time before measurement starts, s."""
SECONDS: Final = 3.0
FOOT_LIFT: Final = TaskConfig().reward.foot_lift
_RAMP: Final = 0.5
"""Time over which a candidate's amplitude grows from the stance, s."""
_MIDDLE: Final = 0.8
"""Threshold of the clock's sine above which a foot is in the middle of its swing."""


@dataclass(frozen=True)
class Achieved:
    """Results of gaits on flat ground, one value per candidate."""

    forward_velocity: NDArray[np.float64]
    """Mean velocity along the heading after the warm-up, m/s."""
    yaw_rate: NDArray[np.float64]
    """Mean yaw rate after the warm-up, rad/s."""
    lateral_velocity: NDArray[np.float64]
    """Mean sideways velocity after the warm-up, m/s."""
    tilt: NDArray[np.float64]
    """Root mean square of the horizontal part of the base's up axis"""
    power: NDArray[np.float64]
    """Positive mechanical power, W"""
    slip: NDArray[np.float64]
    """Mean sliding velocity of feet on the ground, root mean square, m/s"""
    lift: NDArray[np.float64]
    """Agreement of the feet's lift with a clock that swings each foot while the sine of its phase is positive, in
    [-1, 1]"""
    clock: NDArray[np.float64]
    """Agreement of the feet's contacts with that clock, in [-1, 1]"""
    touchdowns: NDArray[np.float64]
    """Touchdowns per stride, mean over the feet"""
    clearance: NDArray[np.float64]
    """Height of the soles in the middle of their swings, mean of the foot that is lifted least, m"""
    highest: NDArray[np.float64]
    """The same of the foot that is lifted most, m"""
    fallen: NDArray[np.bool_]


def measure(
    joint_targets: Callable[[float], NDArray[np.float64]],
    simulation: BatchSimulation,
    angular_frequency: float,
    turns: tuple[float, ...],
) -> Achieved:
    """Run joint targets, a function of time in s that gives (N, 8) in rad, from the stance.

    Frequency (rad/s) and leg phases (cycles, one per leg) are the clock's.
    """
    n = simulation.num_envs
    qpos = np.zeros((n, ROBOT.num_positions))
    qpos[:, 2], qpos[:, 3], qpos[:, 7:] = ROBOT.stance_height, 1.0, ROBOT.stance
    simulation.reset(np.arange(n), qpos, np.zeros((n, ROBOT.num_velocities)))
    state = simulation.readings
    fallen, foot_lift = np.zeros(n, dtype=np.bool_), FootLift(FOOT_LIFT)
    phases = np.array(turns) * 2.0 * np.pi
    sums, height_in_swing = np.zeros((9, n)), np.zeros((n, 4))
    steps, swings = 0, np.zeros(4)
    contact = np.ones((n, 4), dtype=np.bool_)
    for k in range(1, round(SECONDS / CONTROL_TIMESTEP) + 1):
        t = k * CONTROL_TIMESTEP
        ramp = min(1.0, t / _RAMP)
        simulation.step(ROBOT.stance + ramp * (joint_targets(t) - ROBOT.stance), SUBSTEPS)
        fallen |= (state.up_b[:, 2] < 0.5) | (state.trunk_force > 1.0).any(axis=1) | simulation.diverged()
        if t > WARM_UP:
            steps += 1
            sums[0] += state.linear_velocity_b[:, 0]
            sums[1] += state.angular_velocity_b[:, 2]
            sums[2] += state.linear_velocity_b[:, 1]
            sums[3] += (state.up_b[:, :2] ** 2).sum(axis=1)
            sums[4] += mechanical_power(state.joint_torque, state.joint_velocity)
            before, contact = contact, state.foot_force > 1.0
            sliding = sliding_squared(state.foot_velocity, state.foot_angular_velocity, ROBOT.foot_radius)
            sums[5] += (sliding * contact).sum(axis=1)
            height = state.foot_position[..., 2]
            sine = np.sin(angular_frequency * t + phases)
            sums[6] += clock_agreement(foot_lift(height - ROBOT.foot_radius), sine)
            sums[7] += clock_agreement(1.0 - 2.0 * contact, sine)
            sums[8] += (contact & ~before).mean(axis=1)
            height_in_swing += height * (sine > _MIDDLE)
            swings += sine > _MIDDLE
    vx, wz, vy, tilt, power, slip, lift, clock, landings = sums / steps
    touchdowns = landings / CONTROL_TIMESTEP * 2.0 * np.pi / angular_frequency
    lifted = height_in_swing / swings - ROBOT.foot_radius
    lifts = lifted.min(axis=1), lifted.max(axis=1)
    return Achieved(vx, wz, vy, np.sqrt(tilt), power, np.sqrt(0.25 * slip), lift, clock, touchdowns, *lifts, fallen)
