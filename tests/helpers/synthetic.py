"""Rollouts with known answers, made of arrays."""

import numpy as np

from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.robot import MINI_QUADRUPED

DT = 0.02


def synthetic_rollout(steps=250, envs=1, **changes):
    """Rollout of robots that stand still, with other values of some quantities (T, N, ...)."""
    shape = (steps, envs)
    values = {
        "base_pose": np.tile([0.0, 0.0, 0.184, 1.0, 0.0, 0.0, 0.0], (*shape, 1)),
        "joint_position": np.tile(MINI_QUADRUPED.stance, (*shape, 1)),
        "joint_velocity": np.zeros((*shape, 8)),
        "joint_torque": np.zeros((*shape, 8)),
        "velocity": np.zeros((*shape, 2)),
        "command": np.zeros((*shape, 2)),
        "contact": np.ones((*shape, 4), dtype=bool),
        "slip_speed": np.zeros((*shape, 4)),
        "foot_height": np.zeros((*shape, 4)),
        "valid": np.ones(shape, dtype=bool),
        "reward_terms": np.zeros((*shape, 1)),
        **changes,
    }
    return Rollout(
        robot=MINI_QUADRUPED,
        controller="synthetic",
        motors=MINI_QUADRUPED.motors,
        timestep=DT,
        seeds=np.arange(envs),
        term_names=("none",),
        **values,
    )
