"""Small policies with random weights, and observations for them."""

import itertools

import numpy as np
from tasks import ACTION_WIDTH, OBSERVATION_WIDTH

from quadruped_env.policies import Policy
from quadruped_env.task import TaskConfig

TASK = TaskConfig.from_dict({"action": {"mode": "residual"}, "decimation": 5})


def make_policy(activation="elu", hidden=(16, 12), seed=0):
    """A policy with random weights for `TASK`."""
    rng = np.random.default_rng(seed)
    widths = (OBSERVATION_WIDTH, *hidden, ACTION_WIDTH)
    return Policy.for_task(
        weights=tuple(
            rng.standard_normal((a, b)).astype(np.float32) / np.float32(a**0.5) for a, b in itertools.pairwise(widths)
        ),
        biases=tuple(0.1 * rng.standard_normal(b).astype(np.float32) for b in widths[1:]),
        activation=activation,
        config=TASK,
        card={"command": "python train/ppo.py", "seed": 3, "metrics": {"return": 1.5}},
    )


def observations(shape=(), seed=0):
    return np.random.default_rng(seed).uniform(-1, 1, (*shape, OBSERVATION_WIDTH)).astype(np.float32)
