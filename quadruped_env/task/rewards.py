"""The reward: named terms, each a pure batched function of arrays.

NumPy arrays and torch tensors go in, and the same kind comes out. Reductions run along the last axis only, so that
a row's value does not depend on how many rows there are.
"""

import functools
import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot import FOOT_RADIUS, VELOCITY_LIMIT
from quadruped_env.simulation import State
from quadruped_env.task.arrays import ONE, as_number, dot, exp, like, over_minus_one, positive, reverse, total
from quadruped_env.task.config import RewardConfig

_SMALLEST_COMMAND: Final = np.array([0.1, 0.2])
"""m/s and rad/s under which `progress` no longer pays in full."""

_OVERSHOOT: Final = np.array([2.0, 1.0])
"""How often `progress` takes off what is beyond the command: twice, because going too fast does not pay. The yaw rate
sways by more than its command, and a peak there would hardly be felt."""

_SOLE: Final = np.array([-FOOT_RADIUS, FOOT_RADIUS])
"""m; turns angular velocity about (y, x) into velocity of a foot's lowest point along (x, y)"""


def tracking_kernel(value: Any, target: Any, std: Any) -> Any:
    """Score in (0, 1]: how close a velocity is to its command; 1/e at an error of std. Elementwise, (N, 2)."""
    error = (value - target) / std
    return exp(-(error * error))


def progress_scale(command: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """What `progress` needs of a command (N, 2): share per velocity, and the share that is the whole command.

    The whole is 1, and less under `_SMALLEST_COMMAND`, where a command counts in proportion.
    """
    size = np.maximum(np.abs(command), _SMALLEST_COMMAND)
    return np.sign(command) / size, np.abs(command) / size


def progress(share: Any, whole: Any, overshoot: Any) -> Any:
    """Share of a commanded velocity that is reached, in [-1, 1]; 0 where none is commanded. Elementwise, (N, 2).

    Linear, so it shows the way from standing, where a tracking kernel is flat. What is beyond the whole is taken off
    `overshoot` times: 1 stays there, 2 falls as it rose.
    """
    return over_minus_one(share - overshoot * positive(share - whole))


def gait_clock(lift: Any, clock_sine: Any, moving: Any) -> Any:
    """Agreement of the feet with the trot's clock, in [-1, 1], shape (N,).

    Args:
        lift: 1 for a foot in the air, -1 on the ground, or anything between (N, 4).
        clock_sine: positive while the foot should swing (N, 4).
        moving: 1.0 where a motion is commanded (N,).
    """
    return dot(clock_sine, lift) * moving * 0.25


def foot_lift(foot_height: Any, full: float) -> Any:
    """Height of each foot's sole over flat ground: -1 on the ground to 1 at a full lift (m) and above, shape (N, 4).

    Smooth where contact is a switch, so that a little more lift already pays; and bent, 1 - 2 (1 - height / full)^2, so
    that the first millimetres pay most and no foot is left dragging for the sake of the others.
    """
    top, scale = _lift_scale(full)
    missing = positive(like(top, foot_height) - foot_height * like(scale, foot_height))
    return like(ONE, foot_height) - missing * missing


@functools.cache
def _lift_scale(full: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Height of a full lift and the scale of heights, such that the square of what is missing is 2 on the ground."""
    scale = math.sqrt(2.0) / full
    return np.array(scale * (FOOT_RADIUS + full)), np.array(scale)


def sum_of_squares(x: Any) -> Any:
    """Sum over the last axis of x^2, shape (N,)."""
    return dot(x, x)


def base_height_error(height: Any, target: float) -> Any:
    """Square of the missing height in m^2, shape (N,); standing taller is free."""
    missing = positive(target - height)
    return missing * missing


def mechanical_power(torque: Any, velocity: Any) -> Any:
    """Power that the motors put in, W, shape (N,); braking gives nothing back."""
    return total(positive(torque * velocity))


def foot_slip(contact: Any, foot_velocity: Any, foot_angular_velocity: Any) -> Any:
    """Sum over feet on the ground of the squared sliding velocity of their lowest point, m^2/s^2, shape (N,).

    The lowest point of a ball that rolls without slipping is at rest: v + omega x (0, 0, -r).
    """
    spin = reverse(foot_angular_velocity[..., :2])
    sliding = foot_velocity[..., :2] + spin * like(_SOLE, spin)
    return dot(dot(sliding, sliding), contact)


def joint_speed_excess(velocity: Any, margin: float) -> Any:
    """How far the joints are inside a margin (rad/s) of the motors' top speed, squared and summed, (rad/s)^2, (N,)."""
    return sum_of_squares(positive(abs(velocity) - like(_free_speed(margin), velocity)))


@functools.cache
def _free_speed(margin: float) -> NDArray[np.float64]:
    return np.array(VELOCITY_LIMIT - margin)


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
    progress_scale: Any
    """`progress_scale` of that command: shares per m/s and rad/s (N, 2)"""
    progress_whole: Any
    """And what the whole command is as a share (N, 2)"""
    velocity: Any
    """Forward velocity and yaw rate, m/s and rad/s (N, 2)"""
    smooth_velocity: Any
    """`velocity`, averaged over about a gait cycle, m/s and rad/s (N, 2)"""
    moving: Any
    """1.0 where a motion is commanded (N,)"""
    clock_sine: Any
    """Positive while a foot should swing (N, 4)"""
    fallen: Any
    """1.0 where the episode ends in a fall (N,)"""


def reward_terms(state: State, memory: Memory, config: RewardConfig) -> dict[str, Any]:
    """Every term, unweighted, shape (N,) each, in the order in which they are added."""
    contact = as_number(state.foot_force > config.contact_threshold, state.foot_force)
    command = memory.command
    std = like(config.velocity_std, command)
    tracked = tracking_kernel(memory.smooth_velocity, command, std)
    reached = progress(memory.velocity * memory.progress_scale, memory.progress_whole, like(_OVERSHOOT, command))
    velocity_squared = state.linear_velocity_b * state.linear_velocity_b
    return {
        "track_forward_velocity": tracked[:, 0],
        "track_yaw_rate": tracked[:, 1],
        "forward_progress": reached[:, 0],
        "turn_progress": reached[:, 1],
        "gait_clock": gait_clock(
            foot_lift(state.foot_position[..., 2], config.foot_lift), memory.clock_sine, memory.moving
        ),
        "upright": sum_of_squares(state.up_b[:, :2]),
        "base_height": base_height_error(state.base_position[:, 2], config.base_height),
        "vertical_velocity": velocity_squared[:, 2],
        "roll_pitch_rate": sum_of_squares(state.angular_velocity_b[:, :2]),
        "lateral_velocity": velocity_squared[:, 1],
        "action_rate": sum_of_squares(memory.action - memory.last_action),
        "mechanical_power": mechanical_power(state.joint_torque, state.joint_velocity),
        "foot_slip": foot_slip(contact, state.foot_velocity, state.foot_angular_velocity),
        "stand_still": sum_of_squares(memory.joint_offset) * (1.0 - memory.moving),
        "joint_speed": joint_speed_excess(state.joint_velocity, config.joint_speed_margin),
        "fall": memory.fallen,
    }
