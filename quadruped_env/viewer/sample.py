"""Samples of a robot's state for plots and recordings."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quadruped_env.task import Task, Transition

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Sample:
    """Readings of a robot with J joints and L legs at the end of a control step, copied."""

    time: float
    """Time since the start of the episode, s."""
    command: Floats
    """Commanded forward velocity in m/s and yaw rate in rad/s (2,)."""
    velocity: Floats
    """Measured forward velocity and yaw rate (2,), same units."""
    smooth_velocity: Floats
    """Forward velocity and yaw rate averaged over about one gait cycle (2,), same units."""
    base_pose: Floats
    """Position in m and quaternion wxyz in the world (7,)"""
    joint_position: Floats
    """Joint positions (J,), rad."""
    joint_velocity: Floats
    """Joint velocities (J,), rad/s."""
    joint_torque: Floats
    """Joint torques (J,), N m."""
    foot_position: Floats
    """Centre of each foot's sphere in the world frame (L, 3), m."""
    contact: NDArray[np.bool_]
    """True for each foot on the ground (L,)."""
    reward_terms: Floats
    """Weighted terms of the last step, in the task's order (T,); zeros at the start"""


def sample(task: Task, transition: Transition | None = None) -> Sample:
    """The current sample of a task with a single env.

    Args:
        task: the task.
        transition: result of its last step; None at the start of an episode.
    """
    state = task.simulation.readings
    terms = np.zeros(len(task.term_names)) if transition is None else transition.terms[0].copy()
    return Sample(
        time=float(task.steps[0] * task.config.control_timestep),
        command=task.command[0].copy(),
        velocity=np.array([state.linear_velocity_b[0, 0], state.angular_velocity_b[0, 2]]),
        smooth_velocity=task.smooth_velocity[0].copy(),
        base_pose=np.concatenate([state.base_position[0], state.orientation[0]]),
        joint_position=state.joint_position[0].copy(),
        joint_velocity=state.joint_velocity[0].copy(),
        joint_torque=state.joint_torque[0].copy(),
        foot_position=state.foot_position[0].copy(),
        contact=state.foot_force[0] > task.config.reward.contact_threshold,
        reward_terms=terms,
    )


def over_time(samples: Sequence[Sample], name: str) -> NDArray[np.float64]:
    """One field of samples as an array (N, ...)."""
    return np.array([getattr(moment, name) for moment in samples])
