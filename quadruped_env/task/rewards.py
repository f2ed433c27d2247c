"""The reward: named terms, each a pure batched function of arrays.

NumPy arrays and torch tensors go in, and the same kind comes out. Reductions run along the last axis only, so that
a row's value does not depend on how many rows there are.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from quadruped_env.robot import FOOT_RADIUS, JOINT_POSITION_HIGH, JOINT_POSITION_LOW
from quadruped_env.simulation import State
from quadruped_env.task.config import RewardConfig


def _exp(x: Any) -> Any:
    return np.exp(x) if isinstance(x, np.ndarray) else x.exp()


def _like(constant: np.ndarray, x: Any) -> Any:
    return constant if isinstance(x, np.ndarray) else x.new_tensor(constant)


def tracking_kernel(value: Any, target: Any, std: float) -> Any:
    """Score in (0, 1], shape (N,): how close a velocity is to its command; 1/e at an error of std."""
    error = (value - target) * (1.0 / std)
    return _exp(-(error * error))


def progress(value: Any, target: Any, smallest: float) -> Any:
    """Share of a commanded velocity that is reached, in [-1, 1], shape (N,); 0 where none is commanded.

    Linear, so it shows the way from standing, where a tracking kernel is flat. Commands under `smallest` count
    in proportion.
    """
    size = abs(target).clip(smallest, None)
    return (value / size).clip(-1.0, 1.0) * (target / size)


def gait_clock(lift: Any, clock_sine: Any, moving: Any) -> Any:
    """Agreement of the feet with the trot's clock, in [-1, 1], shape (N,).

    Args:
        lift: 1.0 for a foot in the air, 0.0 on the ground, or anything between (N, 4).
        clock_sine: positive while the foot should swing (N, 4).
        moving: 1.0 where a motion is commanded (N,).
    """
    return (clock_sine * (2.0 * lift - 1.0)).sum(axis=-1) * moving * 0.25


def foot_lift(foot_height: Any, full: float) -> Any:
    """Height of each foot's sole over flat ground as a share of a full lift (m), in [0, 1], shape (N, 4).

    Smooth where contact is a switch, so that a little more lift already pays.
    """
    return ((foot_height - FOOT_RADIUS) * (1.0 / full)).clip(0.0, 1.0)


def sum_of_squares(x: Any) -> Any:
    """Sum over the last axis of x^2, shape (N,)."""
    return (x * x).sum(axis=-1)


def base_height_error(height: Any, target: float) -> Any:
    """Square of the missing height in m^2, shape (N,); standing taller is free."""
    missing = (target - height).clip(0.0, None)
    return missing * missing


def mechanical_power(torque: Any, velocity: Any) -> Any:
    """Power that the motors put in, W, shape (N,); braking gives nothing back."""
    return (torque * velocity).clip(0.0, None).sum(axis=-1)


def foot_slip(contact: Any, foot_velocity: Any, foot_angular_velocity: Any) -> Any:
    """Sum over feet on the ground of the squared sliding velocity of their lowest point, m^2/s^2, shape (N,).

    The lowest point of a ball that rolls without slipping is at rest: v + omega x (0, 0, -r).
    """
    x = foot_velocity[..., 0] - FOOT_RADIUS * foot_angular_velocity[..., 1]
    y = foot_velocity[..., 1] + FOOT_RADIUS * foot_angular_velocity[..., 0]
    return ((x * x + y * y) * contact).sum(axis=-1)


def joint_limit_excess(position: Any, margin: float) -> Any:
    """How far the joints are inside a margin (rad) of their limits, summed, rad, shape (N,)."""
    low, high = _like(JOINT_POSITION_LOW + margin, position), _like(JOINT_POSITION_HIGH - margin, position)
    return ((low - position).clip(0.0, None) + (position - high).clip(0.0, None)).sum(axis=-1)


@dataclass(slots=True)
class Memory:
    """What a reward may know beside the simulation's state."""

    action: Any
    """(N, 8)"""
    last_action: Any
    """(N, 8)"""
    joint_offset: Any
    """Joint positions relative to the stance, rad (N, 8)"""
    command: Any
    """m/s and rad/s (N, 2)"""
    smooth_velocity: Any
    """Forward velocity and yaw rate, averaged over about a gait cycle, m/s and rad/s (N, 2)"""
    moving: Any
    """1.0 where a motion is commanded (N,)"""
    clock_sine: Any
    """Positive while a foot should swing (N, 4)"""
    fallen: Any
    """1.0 where the episode ends in a fall (N,)"""


def reward_terms(state: State, memory: Memory, config: RewardConfig) -> dict[str, Any]:
    """Every term, unweighted, shape (N,) each, in the order in which they are added."""
    contact = (state.foot_force > config.contact_threshold) * 1.0
    velocity = state.linear_velocity_b
    smooth, command = memory.smooth_velocity, memory.command
    standing = 1.0 - memory.moving
    return {
        "track_forward_velocity": tracking_kernel(smooth[:, 0], command[:, 0], config.forward_velocity_std),
        "track_yaw_rate": tracking_kernel(smooth[:, 1], command[:, 1], config.yaw_rate_std),
        "forward_progress": progress(velocity[:, 0], command[:, 0], 0.1),
        "turn_progress": progress(state.angular_velocity_b[:, 2], command[:, 1], 0.2),
        "gait_clock": gait_clock(
            foot_lift(state.foot_position[..., 2], config.foot_lift), memory.clock_sine, memory.moving
        ),
        "upright": sum_of_squares(state.up_b[:, :2]),
        "base_height": base_height_error(state.base_position[:, 2], config.base_height),
        "vertical_velocity": velocity[:, 2] * velocity[:, 2],
        "roll_pitch_rate": sum_of_squares(state.angular_velocity_b[:, :2]),
        "lateral_velocity": velocity[:, 1] * velocity[:, 1],
        "action_rate": sum_of_squares(memory.action - memory.last_action),
        "mechanical_power": mechanical_power(state.joint_torque, state.joint_velocity),
        "foot_slip": foot_slip(contact, state.foot_velocity, state.foot_angular_velocity),
        "stand_still": sum_of_squares(memory.joint_offset) * standing,
        "joint_limits": joint_limit_excess(state.joint_position, config.joint_limit_margin),
        "fall": memory.fallen,
    }
