"""Trials of open-loop gaits: what many of them reach on flat ground, in parallel."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.simulation import BatchSimulation, build_model
from quadruped_env.task import TaskConfig
from quadruped_env.task.quantities import (
    clock_agreement,
    electrical_power,
    foot_lift,
    mechanical_power,
    sliding_squared,
)
from quadruped_env.training.strides import Strides

ROBOT: Final = MINI_QUADRUPED
"""Robot whose gaits are searched."""
CONTROL_TIMESTEP: Final = TaskConfig().control_timestep
SUBSTEPS: Final = TaskConfig().decimation
WARM_UP: Final = 1.0
"""Time before measurement starts, s."""
SECONDS: Final = 3.0
FOOT_LIFT: Final = TaskConfig().reward.foot_lift
_HEAT: Final = ROBOT.motors.joule_coefficients(ROBOT.joint_names)


class Start(NamedTuple):
    """State in which a trial starts."""

    clock: float
    """Gait clock, rad."""
    friction: float
    """Coefficient of sliding friction of the ground and the robot"""
    velocity: tuple[float, ...] = (0.0,) * ROBOT.num_velocities
    """Of the base, linear in m/s (world frame) and angular in rad/s (body frame), and of the joints, rad/s."""
    joint_offset: tuple[float, ...] = (0.0,) * ROBOT.num_joints
    """Joint positions relative to the stance, rad."""
    softness: float = 1.0
    """Time constant of the contacts, as a multiple of the robot's."""
    target_offset: tuple[float, ...] = (0.0,) * ROBOT.num_joints
    """Added to the joint targets of the whole trial, rad."""


def draw_starts(seed: int, target_offset: float = 0.0) -> tuple[Start, ...]:
    """Starts that are spread over the gait's cycle, with velocities and joint positions as in episodes, or more.

    The last two are two of the others once more, with soft contacts.

    Args:
        seed: of the draws.
        target_offset: largest offset of each joint target, rad.
    """
    rng = np.random.default_rng(seed)
    velocity = np.repeat([0.3, 0.5], [6, ROBOT.num_joints])
    starts = tuple(
        Start(
            math.tau * k / 6,
            (0.7, 0.8, 0.9)[k % 3],
            tuple(rng.uniform(-velocity, velocity).tolist()),
            tuple(rng.uniform(-0.1, 0.1, ROBOT.num_joints).tolist()),
        )
        for k in range(6)
    )
    offsets = rng.uniform(-target_offset, target_offset, (6, ROBOT.num_joints))
    starts = tuple(
        start._replace(target_offset=tuple(row)) for start, row in zip(starts, offsets.tolist(), strict=True)
    )
    return (*starts, *(start._replace(softness=2.0) for start in starts[1::3]))


STARTS: Final = draw_starts(0)
"""Every gait is tried from these: from one start alone, the search finds gaits that other starts do not lead to. What
soft contacts change is about what stiffer ones, and another engine's, change in the other direction."""
TARGET_OFFSET: Final = 0.01
"""As large as the encoders' offsets in the preset `moderate`, rad."""


def new_starts(generation: int, draws: int = 1) -> tuple[Start, ...]:
    """Starts that no other generation of a search has, with offsets of the joint targets; `draws` times `draw_starts`.

    From the same ones again and again, a search finds gaits that need these starts and their own numbers exactly: one
    walked well from 24 starts, and with 0.003 rad more or less in its numbers no longer from all of them.
    """
    seeds = range(1000 + draws * generation, 1000 + draws * (generation + 1))
    return tuple(start for seed in seeds for start in draw_starts(seed, TARGET_OFFSET))


def many_new_starts(generation: int) -> tuple[Start, ...]:
    """Three times as many: near the motors' top speed a few starts lead a gait astray that walks well from others."""
    return new_starts(generation, 3)


@dataclass(frozen=True)
class Achieved:
    """Results of gaits on flat ground, the first axis over candidates.

    They are means over those of the starts that have the robot's own contacts, unless said.
    """

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
    electrical_power: NDArray[np.float64]
    """Positive mechanical power and heat in the windings, W"""
    slip: NDArray[np.float64]
    """Mean sliding velocity of feet on the ground, root mean square, m/s"""
    lift: NDArray[np.float64]
    """Agreement of the feet's lift with a clock that swings each foot while the sine of its phase is positive, in
    [-1, 1]"""
    clock: NDArray[np.float64]
    """Agreement of the feet's contacts with that clock, in [-1, 1]"""
    touchdown_error: NDArray[np.float64]
    """Difference of each foot's touchdowns per stride from one, mean over the feet"""
    clearance: NDArray[np.float64]
    """Largest height of a sole in a stride or in a swing, m: the smallest of all strides, swings, feet and starts"""
    lowest_apex: NDArray[np.float64]
    """The same of each foot from each start, (N, S, 4) for N candidates and S starts, m"""
    mean_apex: NDArray[np.float64]
    """Largest height of each sole in a stride, mean over the whole strides, (N, S, 4), m"""
    highest: NDArray[np.float64]
    """The same, mean over the whole strides of the foot that is lifted most, m"""
    fallen: NDArray[np.bool_]
    """From any of the starts."""
    forward_velocity_spread: NDArray[np.float64]
    """Largest difference from the mean forward velocity, from any start and with soft contacts too, m/s"""
    yaw_rate_spread: NDArray[np.float64]
    """The same of the yaw rate, rad/s"""


def trials(count: int, starts: tuple[Start, ...] | None = None) -> BatchSimulation:
    """Simulation of so many gaits from each of the starts, `STARTS` if None: all from the first, then from the next."""
    starts = starts or STARTS
    simulation = BatchSimulation(build_model(robot=ROBOT), count * len(starts), robot=ROBOT)
    # As in the task's randomization, all geoms are set: the larger friction of the two in contact counts.
    simulation.model_field("geom_friction")[..., 0] = np.repeat([start.friction for start in starts], count)[:, None]
    simulation.model_field("geom_solref")[..., 0] *= np.repeat([start.softness for start in starts], count)[:, None]
    return simulation


def measure(
    joint_targets: Callable[[float], NDArray[np.float64]],
    simulation: BatchSimulation,
    angular_frequency: float,
    turns: tuple[float, ...],
    starts: tuple[Start, ...] | None = None,
) -> Achieved:
    """Run joint targets, a function of the gait clock in rad that gives (N, 8) in rad, from the stance.

    Simulation and starts are those of `trials`. Frequency (rad/s) and leg phases (cycles, one per leg) are the clock's.
    """
    n, starts = simulation.num_envs, starts or STARTS
    start_clock = np.repeat([start.clock for start in starts], n // len(starts))[:, None]
    qpos = np.zeros((n, ROBOT.num_positions))
    qpos[:, 2], qpos[:, 3] = ROBOT.stance_height, 1.0
    qpos[:, 7:] = ROBOT.stance + np.repeat([start.joint_offset for start in starts], n // len(starts), axis=0)
    qvel = np.repeat([start.velocity for start in starts], n // len(starts), axis=0)
    simulation.reset(np.arange(n), qpos, qvel)
    state = simulation.readings
    fallen = np.zeros(n, dtype=np.bool_)
    phases = np.array(turns) * 2.0 * np.pi
    sums, strides = np.zeros((9, n)), Strides(n)
    steps = 0
    contact = np.ones((n, 4), dtype=np.bool_)
    for k in range(1, round(SECONDS / CONTROL_TIMESTEP) + 1):
        t = k * CONTROL_TIMESTEP
        # The gait starts with its whole amplitude, as in the env.
        targets = [joint_targets(angular_frequency * t + start.clock) + start.target_offset for start in starts]
        simulation.step(np.concatenate(targets), SUBSTEPS)
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
            height = state.foot_position[..., 2] - ROBOT.foot_radius
            angle = angular_frequency * t + start_clock + phases
            sine = np.sin(angle)
            strides.add(np.floor(angle / (2.0 * np.pi)), height, contact, before)
            sums[6] += clock_agreement(foot_lift(height, FOOT_LIFT), sine)
            sums[7] += clock_agreement(1.0 - 2.0 * contact, sine)
            sums[8] += electrical_power(state.joint_torque, state.joint_velocity, _HEAT)
    vx, wz, vy, tilt, power, slip, lift, clock, electrical = sums / steps
    mean_apex = strides.apexes / strides.count
    each = {
        "forward_velocity": vx,
        "yaw_rate": wz,
        "lateral_velocity": vy,
        "tilt": np.sqrt(tilt),
        "power": power,
        "electrical_power": electrical,
        "slip": np.sqrt(0.25 * slip),
        "lift": lift,
        "clock": clock,
        "touchdown_error": np.abs(strides.touchdowns / strides.count - 1.0).mean(axis=1),
        "clearance": strides.lowest_apex.min(axis=1),
        "lowest_apex": strides.lowest_apex,
        "mean_apex": mean_apex,
        "highest": mean_apex.max(axis=1),
        "fallen": fallen,
    }
    return _over_starts(each, starts)


def _over_starts(each: dict[str, NDArray[np.generic]], starts: tuple[Start, ...]) -> Achieved:
    """The results of each gait, from those of each gait and start."""
    by_start = {name: value.reshape(len(starts), -1, *value.shape[1:]) for name, value in each.items()}
    own = [start.softness == 1.0 for start in starts]
    values = {name: value[own] for name, value in by_start.items()}
    unlike_the_mean = {
        **{name: values.pop(name).swapaxes(0, 1) for name in ("lowest_apex", "mean_apex")},
        "clearance": values.pop("clearance").min(axis=0),
        "fallen": by_start["fallen"].any(axis=0),
    }
    del values["fallen"]
    means = {name: value.mean(axis=0) for name, value in values.items()}
    spreads = {
        f"{name}_spread": np.abs(by_start[name] - means[name]).max(axis=0) for name in ("forward_velocity", "yaw_rate")
    }
    return Achieved(**means, **spreads, **unlike_the_mean)
