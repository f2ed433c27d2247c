"""One moment of a robot, as plots and recordings keep it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quadruped_env.task import Task, Transition

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Sample:
    """The readings at the end of a control step; copies."""

    time: float
    """s since the episode began"""
    command: Floats
    """Forward velocity in m/s and yaw rate in rad/s (2,)"""
    velocity: Floats
    """What they are (2,)"""
    smooth_velocity: Floats
    """What they are over about a gait cycle (2,)"""
    base_pose: Floats
    """Position in m and quaternion wxyz in the world (7,)"""
    joint_position: Floats
    """rad (8,)"""
    joint_velocity: Floats
    """rad/s (8,)"""
    joint_torque: Floats
    """N m (8,)"""
    foot_position: Floats
    """Centre of each foot's ball in the world, m (4, 3)"""
    contact: NDArray[np.bool_]
    """Whether each foot is on the ground (4,)"""
    reward_terms: Floats
    """Weighted terms of the last step, in the task's order (T,); zeros at the start"""


def sample(task: Task, transition: Transition | None = None) -> Sample:
    """The present moment of a task with one row.

    Args:
        task: the task.
        transition: what its last step gave; None at the start of an episode.
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
