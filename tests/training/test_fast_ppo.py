"""PPO with less work around it: the same buffers and updates as those of Stable-Baselines3's own PPO."""

import math

import numpy as np
import pytest
import torch
from networks import perturb
from settings import settings
from stable_baselines3 import PPO
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.logger import configure

from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.training import TrainConfig
from quadruped_env.training.exploration import ClockNoise
from quadruped_env.training.fast_ppo import FastPPO
from quadruped_env.training.sb3_models import make_model

STEPS, ENVS = 30, 6
COLUMNS = ("observations", "actions", "rewards", "episode_starts", "values", "log_probs", "advantages", "returns")


def fresh(**changes):
    """A model with random weights, whose envs fall and run into their time limit within a rollout."""
    changes = {"num_envs": ENVS, "n_steps": STEPS, "batch_size": STEPS * ENVS, "n_epochs": 1} | changes
    env = make_sb3_vec_env(
        ENVS, seed=0, max_episode_steps=11, config=settings(max_tilt=0.17), privileged=changes.get("asymmetric_critic")
    )
    torch.manual_seed(1)
    model = make_model(TrainConfig(**changes), env)
    perturb(model)
    model.set_logger(configure(None, []))
    model._setup_learn(10**6)
    return model


class Silent(BaseCallback):
    """A callback that may end the training after some steps."""

    def __init__(self, last=10**9):
        super().__init__()
        self.left = last

    def _on_step(self):
        self.left -= 1
        return self.left > 0


def collected(model, collect, callback=None):
    callback = callback or Silent()
    callback.init_callback(model)
    going_on = collect(model, model.env, callback, model.rollout_buffer, STEPS)
    return going_on, {name: getattr(model.rollout_buffer, name).copy() for name in COLUMNS}


@pytest.mark.parametrize("asymmetric_critic", [False, True])
def test_rollouts_are_those_of_sb3(asymmetric_critic):
    """With next to no noise, because the random numbers are drawn in another order."""
    found = {}
    for collect in (FastPPO.collect_rollouts, PPO.collect_rollouts):
        model = fresh(asymmetric_critic=asymmetric_critic)
        model.policy.log_std.data.fill_(-30.0)
        found[collect], expected = collected(model, collect)[1], found.get(FastPPO.collect_rollouts)
    assert expected is not None
    actual, expected = found[FastPPO.collect_rollouts], found[PPO.collect_rollouts]
    for name in COLUMNS:
        if name != "log_probs":  # of noise that differs
            np.testing.assert_allclose(actual[name], expected[name], rtol=1e-3, atol=1e-3, err_msg=name)
    ends = expected["episode_starts"][1:].sum()
    assert ends > 2 * ENVS, "several episodes of each env, so that some were cut off by the time limit"


def test_log_probabilities_and_values_are_those_of_the_policy():
    model = fresh()
    _, buffer = collected(model, FastPPO.collect_rollouts)
    with torch.no_grad():
        values, log_probs, _ = model.policy.evaluate_actions(
            *(torch.from_numpy(buffer[name].reshape(STEPS * ENVS, -1)) for name in ("observations", "actions"))
        )
    np.testing.assert_allclose(buffer["values"].ravel(), values.ravel(), atol=1e-5)
    np.testing.assert_allclose(buffer["log_probs"].ravel(), log_probs, atol=1e-4)
    noise = buffer["actions"].reshape(STEPS * ENVS, -1)
    assert np.std(noise, axis=0).min() > 0.5 * model.policy.log_std.exp().min().item()


def test_rewards_have_the_value_of_what_a_time_limit_cut_off_and_of_nothing_else():
    model, seen = fresh(), []
    step = model.env.step

    def watched(actions):
        result = step(actions)
        seen.append((result[1].copy(), result[2].copy(), result[3]))
        return result

    model.env.step = watched
    _, buffer = collected(model, FastPPO.collect_rollouts)
    kinds = {False: 0, True: 0}
    for k, (rewards, dones, infos) in enumerate(seen):
        expected = rewards.copy()
        for i in np.flatnonzero(dones):
            cut_off = infos[i]["TimeLimit.truncated"]
            kinds[cut_off] += 1
            if cut_off:
                with torch.no_grad():
                    last = torch.from_numpy(infos[i]["terminal_observation"][None])
                    expected[i] += model.gamma * model.policy.predict_values(last).item()
        np.testing.assert_allclose(buffer["rewards"][k], expected, atol=1e-5)
    assert min(kinds.values()) > 0, kinds


def test_update_is_that_of_sb3():
    """One gradient step on the whole buffer, where the order of the samples does not matter."""
    models = []
    for update in (FastPPO.train, PPO.train):
        model = fresh(ent_coef=0.01)
        collected(model, FastPPO.collect_rollouts)
        # Beyond the clip range for some samples, and a gradient that is clipped.
        model.rollout_buffer.log_probs += np.linspace(-0.5, 0.5, STEPS * ENVS, dtype=np.float32).reshape(STEPS, ENVS)
        before = [parameter.detach().clone() for parameter in model.policy.parameters()]
        model._current_progress_remaining = 0.5
        update(model)
        models.append(model)
    actual, expected = ([*model.policy.parameters()] for model in models)
    moved = max((new.detach() - old).abs().max().item() for new, old in zip(expected, before, strict=True))
    assert moved > 1e-4
    differences = torch.cat([(one - two).detach().abs().flatten() for one, two in zip(actual, expected, strict=True)])
    # Adam divides a gradient by its size: of the few that are nearly 0, their rounding is left.
    assert (differences > 1e-2 * moved).float().mean() < 0.002
    assert differences.max() < 0.2 * moved
    records, names = [model.logger.name_to_value for model in models], []
    for name, value in records[1].items():
        if name.startswith("train/"):
            names.append(name)
            assert records[0][name] == pytest.approx(value, rel=1e-3, abs=1e-6), name
    assert len(names) == 11


def clock_noise(share, mean_actions, deviation, steps, moving=1.0, robots=4000, joints=2):
    """Noise (steps, N, J) of robots whose phases (N,) advance by `STEP` each step, and these phases."""
    torch.manual_seed(0)
    source = ClockNoise(share, robots, joints)
    source.set_share(mean_actions, torch.full((joints,), deviation))
    phase = torch.linspace(0.0, 6.0, robots)
    noise = torch.randn(steps, robots, joints)
    for step, row in enumerate(noise):
        source.mix_into(row, phase + STEP * step, torch.full((robots,), moving))
    return noise.numpy(), phase.numpy()


STEP = 0.3
"""Advance of a gait clock per step, rad."""


def test_clock_noise_is_standard_normal_and_swings_with_each_clock():
    """Covariance c 0.98^k cos(k step) at lag k, of which the white part 1 - c has none; joints are independent."""
    noise, phase = clock_noise(0.8, torch.zeros(2, 3, 2), 0.1, steps=25)
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
    swing = torch.stack(
        [torch.full((100, 4), 0.2) * torch.tensor([1.0, -1.0]).repeat(50)[:, None], torch.zeros(100, 4)], -1
    )
    noise, _ = clock_noise(0.8, swing, 0.1, steps=2)
    found = (noise[1] * noise[0]).mean(axis=0) / (0.98 * math.cos(STEP))
    assert found[0] == pytest.approx(0.8 * 0.01 / (0.01 + 0.04), abs=0.06)
    assert found[1] == pytest.approx(0.8, abs=0.06)
    standing, _ = clock_noise(0.8, swing, 0.1, steps=2, moving=0.0)
    assert (standing[1] * standing[0]).mean(axis=0) == pytest.approx([0.0, 0.0], abs=0.06)


def test_exploration_of_a_rollout_swings_with_the_clock_from_the_second_one_on():
    """And its log probabilities are the policy's."""
    model = fresh(clock_noise=0.9, action_mode="position")
    model.policy.action_net.weight.data.mul_(0.01)  # no gait of its own yet
    correlations = []
    for _ in range(2):
        _, buffer = collected(model, FastPPO.collect_rollouts)
        seen, done = (torch.from_numpy(buffer[name].reshape(STEPS * ENVS, -1)) for name in ("observations", "actions"))
        with torch.no_grad():
            noise = (done - model.mean_action(seen)).reshape(STEPS, ENVS, -1) / model.policy.log_std.exp()
            _, log_probs, _ = model.policy.evaluate_actions(seen, done)
        np.testing.assert_allclose(buffer["log_probs"].ravel(), log_probs, atol=1e-4)
        correlations.append((noise[1:] * noise[:-1]).mean().item())
    assert abs(correlations[0]) < 0.15
    assert correlations[1] > 0.4


def test_training_begins_straight_ahead_with_bolder_updates_and_goes_on_with_all_commands():
    steps = STEPS * ENVS
    model = fresh(straight_steps=2 * steps, learning_rate=1e-3)
    commands, rates = [], []
    step, update = model.env.step, model.train

    def watched(actions):
        commands.append((model.num_timesteps, model.env.task.command.copy()))
        return step(actions)

    def updated():
        update()
        rates.append(model.policy.optimizer.param_groups[0]["lr"])

    model.env.step, model.train = watched, updated
    model.learn(6 * steps)
    straight = np.array([values for timesteps, values in commands if timesteps < 2 * steps])
    later = np.array([values for timesteps, values in commands if timesteps > 3 * steps])
    assert (straight[..., 1] == 0.0).all()
    assert straight[..., 0].min() >= 0.45
    assert (later[..., 1] != 0.0).any()
    assert (later[..., 0] < 0.3).any()
    left = 1.0 - np.arange(1, 7) / 6
    np.testing.assert_allclose(rates, 1e-3 * (0.1 + 0.9 * left) * np.array([2.5, 2.5, 1.0, 1.0, 1.0, 1.0]), rtol=1e-6)


def test_every_sample_is_used_once_in_each_epoch(monkeypatch):
    model = fresh(batch_size=60, n_epochs=3)
    collected(model, FastPPO.collect_rollouts)
    model.rollout_buffer.returns[:] = np.arange(STEPS * ENVS).reshape(STEPS, ENVS)
    seen = []
    monkeypatch.setattr(model, "_gradient_step", lambda *batch: seen.append(batch[4].numpy().copy()) or torch.zeros(6))
    model.train()
    sizes = [len(batch) for batch in seen]
    assert sizes == [60, 60, 60] * 3
    epochs = [np.concatenate(seen[i : i + 3]) for i in (0, 3, 6)]
    for epoch in epochs:
        np.testing.assert_array_equal(np.sort(epoch), np.arange(STEPS * ENVS))
    assert not np.array_equal(epochs[0], epochs[1])


def test_rollout_that_the_callback_ends_is_not_learned_from():
    model = fresh()
    going_on, _ = collected(model, FastPPO.collect_rollouts, Silent(last=5))
    assert going_on is False
    assert model.num_timesteps == 5 * ENVS


def test_same_seed_gives_the_same_bits():
    weights = []
    for _ in range(2):
        model = fresh(batch_size=45)
        model.set_random_seed(3)
        model.learn(4 * STEPS * ENVS)
        weights.append([parameter.detach().numpy().copy() for parameter in model.policy.parameters()])
    for one, two in zip(*weights, strict=True):
        np.testing.assert_array_equal(one, two)
