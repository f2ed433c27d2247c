"""Exploration and stages of PPO: noise of the policy, its share of the gait clock, and the straight start."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from networks import perturb
from stable_baselines3 import PPO
from stable_baselines3.common.callbacks import BaseCallback

from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.training import TrainConfig
from quadruped_env.training.exploration import ClockNoise
from quadruped_env.training.sb3_models import make_model
from quadruped_env.training.schedules import Scheduled

STEPS, ENVS = 30, 6
STEP = 0.3
"""Advance of a gait clock per step, rad."""


def fresh(**changes):
    """A model with random weights, its callback."""
    config = TrainConfig(
        **{"num_envs": ENVS, "n_steps": STEPS, "batch_size": STEPS * ENVS, "n_epochs": 1, "timesteps": 10**6, **changes}
    )
    torch.manual_seed(1)
    model = make_model(config, make_sb3_vec_env(ENVS, seed=0, action_mode=config.action_mode, max_episode_steps=11))
    perturb(model)
    return model, Scheduled(config)


def test_training_is_sb3s_own_and_the_policys_actions_are_those_of_its_distribution():
    model, _ = fresh()
    assert type(model) is PPO
    seen = torch.rand(500, 34) - 0.5
    with torch.no_grad():
        actions, values, log_probs = model.policy(seen)
        found_values, found_log_probs, _ = model.policy.evaluate_actions(seen, actions)
        noise = (actions - model.policy.get_distribution(seen).distribution.mean) / model.policy.log_std.exp()
        means, *_ = model.policy(seen, deterministic=True)
    torch.testing.assert_close(log_probs, found_log_probs, atol=1e-4, rtol=1e-5)
    torch.testing.assert_close(values, found_values)
    torch.testing.assert_close(means, model.policy.mean_action(seen))
    assert noise.mean().item() == pytest.approx(0.0, abs=0.1)
    assert noise.std().item() == pytest.approx(1.0, abs=0.1)


def clock_noise(share, mean_actions, deviation, steps, moving=1.0, robots=4000, joints=2):
    """Noise (steps, N, J) of robots whose phases (N,) advance by `STEP` each step, and these phases."""
    torch.manual_seed(0)
    phase = np.linspace(0.0, 6.0, robots)
    control = SimpleNamespace(phase=phase.copy(), moving=np.full(robots, moving), action=np.zeros((robots, joints)))
    source = ClockNoise(share, control)
    for means in mean_actions:
        source.draw(means.expand(robots, joints) if len(means) == 1 else means)
    source.end_rollout(torch.full((joints,), deviation))
    noise = []
    for step in range(steps):
        control.phase = phase + STEP * step
        noise.append(source.draw(torch.zeros(robots, joints)).numpy())
    return np.array(noise), phase


def test_clock_noise_is_standard_normal_and_swings_with_each_clock():
    """Covariance c 0.98^k cos(k step) at lag k, of which the white part 1 - c has none; joints are independent."""
    noise, phase = clock_noise(0.8, torch.zeros(2, 1, 2), 0.1, steps=25)
    error = 5.0 / math.sqrt(noise[0].size)
    for row in noise:
        assert row.mean() == pytest.approx(0.0, abs=error)
        assert row.var() == pytest.approx(1.0, abs=error)
    for lag in (1, 5, 10, 21):
        expected = 0.8 * 0.98**lag * math.cos(lag * STEP)
        assert (noise[lag] * noise[0]).mean() == pytest.approx(expected, abs=error), lag
    assert (noise[..., 0] * noise[..., 1]).mean() == pytest.approx(0.0, abs=error)
    assert (noise[0] * np.cos(phase)[:, None]).mean() == pytest.approx(0.0, abs=error), "any phase of the stride"


def test_clock_noise_gives_way_to_the_actions_of_a_gait_and_leaves_standing_robots_alone():
    """Share c d^2 / (d^2 + v) with the noise's deviation d and the actions' variance v, of each joint by itself."""
    swing = torch.tensor([0.2, 0.0]) * torch.tensor([1.0, -1.0]).repeat(50)[:, None, None]
    noise, _ = clock_noise(0.8, swing, 0.1, steps=2)
    found = (noise[1] * noise[0]).mean(axis=0) / (0.98 * math.cos(STEP))
    assert found[0] == pytest.approx(0.8 * 0.01 / (0.01 + 0.04), abs=0.06)
    assert found[1] == pytest.approx(0.8, abs=0.06)
    standing, _ = clock_noise(0.8, swing, 0.1, steps=2, moving=0.0)
    assert (standing[1] * standing[0]).mean(axis=0) == pytest.approx([0.0, 0.0], abs=0.06)


def test_exploration_of_a_training_swings_with_the_clock_from_the_second_rollout_on():
    model, callback = fresh(clock_noise=0.9, action_mode="position", learning_rate=1e-9)
    model.policy.action_net.weight.data.mul_(0.01)  # no gait of its own yet
    correlations = []

    class Watch(BaseCallback):
        def _on_step(self):
            return True

        def _on_rollout_end(self):
            seen, done = map(torch.from_numpy, (model.rollout_buffer.observations, model.rollout_buffer.actions))
            with torch.no_grad():
                noise = (done - model.policy.mean_action(seen)) / model.policy.log_std.exp()
            correlations.append((noise[1:] * noise[:-1]).mean().item())

    model.learn(2 * STEPS * ENVS, [callback, Watch()])
    assert abs(correlations[0]) < 0.15
    assert correlations[1] > 0.4


def test_training_begins_straight_ahead_with_bolder_updates_and_goes_on_with_all_commands():
    steps = STEPS * ENVS
    model, callback = fresh(straight_steps=2 * steps, learning_rate=1e-3, timesteps=6 * steps)
    commands, rates = [], []
    step, update = model.env.step, model.train

    def watched(actions):
        commands.append((model.num_timesteps, model.env.task.command.copy()))
        return step(actions)

    def updated():
        update()
        rates.append(model.policy.optimizer.param_groups[0]["lr"])

    model.env.step, model.train = watched, updated
    model.learn(6 * steps, callback)
    straight = np.array([values for timesteps, values in commands if timesteps < 2 * steps])
    later = np.array([values for timesteps, values in commands if timesteps > 3 * steps])
    assert (straight[..., 1] == 0.0).all()
    assert straight[..., 0].min() >= 0.45
    assert (later[..., 1] != 0.0).any()
    assert (later[..., 0] < 0.3).any()
    left = 1.0 - np.arange(1, 7) / 6
    np.testing.assert_allclose(rates, 1e-3 * (0.1 + 0.9 * left) * np.array([2.5, 2.5, 1.0, 1.0, 1.0, 1.0]), rtol=1e-6)
