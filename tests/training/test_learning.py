"""Training improves a policy: every other test of training would also pass with an optimizer that goes uphill."""

import gymnasium
import numpy as np
import pytest
from settings import settings

from quadruped_env.envs import ENV_ID
from quadruped_env.policies import load_policy
from quadruped_env.training import train
from quadruped_env.training.train_config import TrainConfig

SPEED = 0.4
TASK = settings(forward_velocity=(0.3, 0.5), shares=(0.0, 1.0))
"""Straight ahead only, which takes fewer samples than the whole task."""
BUDGET = {"timesteps": 122_880, "num_envs": 64, "n_steps": 16, "batch_size": 256, "n_epochs": 6, "learning_rate": 5e-3}
"""Many small updates, with which few steps are enough."""


def evaluate(act):
    """Mean reward per second and forward velocity (m/s) over the first 4 s of eight episodes, without exploration."""
    env = gymnasium.make_vec(ENV_ID, num_envs=8, action_mode="position", config=settings(never_ends=True))
    observation, _ = env.reset(seed=100, options={"command": (SPEED, 0.0)})
    rewards, velocities = [], []
    for _ in range(200):
        observation, reward, _, _, info = env.step(act(observation))
        rewards.append(reward)
        velocities.append(info["base_linear_velocity"][:, 0])
    return 50.0 * np.mean(rewards), np.mean(velocities)


@pytest.mark.slow
def test_ppo_with_a_small_budget_learns_to_walk_forward(tmp_path):
    found = []
    for seed in range(3):
        config = TrainConfig(action_mode="position", task=TASK, seed=seed, **BUDGET)
        directory, finished = train.train(config, tmp_path / str(seed), "a test")
        assert finished
        found.append(evaluate(load_policy(directory).predict))
    # A fresh policy does what the zero action does, and stands: 8.8 per second at 0.00 m/s.
    before, standing = evaluate(lambda observation: np.zeros((8, 8), dtype=np.float32))
    after, walking = np.median(found, axis=0)
    assert abs(standing) < 0.02
    # The median of three seeds reaches 1.7 times the reward; processors round differently.
    assert walking > 0.2
    assert after > 1.4 * before
