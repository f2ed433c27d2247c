"""Rollouts with known answers, made of arrays."""

import numpy as np

from quadruped_env.evaluation.rollout import Rollout
from quadruped_env.robot import MINI_QUADRUPED

DT = 0.02


def falls(valid):
    """Samples in which robots fall (T, N), from those before a fall, in which they are valid."""
    fell = ~valid
    fell[1:] &= valid[:-1]
    return fell


def synthetic_rollout(steps=250, envs=1, robot=MINI_QUADRUPED, **changes):
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
        "fell": np.zeros(shape, dtype=bool),
        "electrical_power": np.zeros(shape),
        "mechanical_power": np.zeros(shape),
        "base_height": np.full(shape, 0.184),
        "reward_terms": np.zeros((*shape, 1)),
        **changes,
    }
    return Rollout(
        robot=robot,
        controller="synthetic",
        timestep=DT,
        seeds=tuple(range(envs)),
        term_names=("none",),
        **values,
    )
