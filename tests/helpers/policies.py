"""Small policies with random weights, and observations for them."""

import itertools

import numpy as np
from tasks import OBSERVATION_WIDTH

from quadruped_env.control.task_file import KEPT_FILE
from quadruped_env.policies import Policy
from quadruped_env.task import TaskConfig, load_task_file

TASK = TaskConfig.from_dict({"action": {"mode": "residual"}, "decimation": 5})


def make_policy(activation="elu", hidden=(16, 12), seed=0, config=TASK):
    """A policy with random weights for a task."""
    rng = np.random.default_rng(seed)
    columns = sum(field.width(config.robot) for field in config.definition.observations)
    widths = (config.observation_history * columns, *hidden, config.robot.num_joints)
    return Policy.for_task(
        weights=tuple(
            rng.standard_normal((a, b)).astype(np.float32) / np.float32(a**0.5) for a, b in itertools.pairwise(widths)
        ),
        biases=tuple(0.1 * rng.standard_normal(b).astype(np.float32) for b in widths[1:]),
        activation=activation,
        config=config,
        card={"command": "python train/ppo.py", "seed": 3, "metrics": {"return": 1.5}},
    )


def observations(shape=(), seed=0):
    return np.random.default_rng(seed).uniform(-1, 1, (*shape, OBSERVATION_WIDTH)).astype(np.float32)


def save_policy(directory, file, changes=None):
    """A policy of a user's file with random weights, in a directory that keeps the file, as a training's run does."""
    make_policy(config=TaskConfig.from_dict(changes or {}, load_task_file(file))).save(directory)
    (directory / KEPT_FILE).write_bytes(file.read_bytes())
    return directory
