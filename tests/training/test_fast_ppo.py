"""PPO with less work around it: the same buffers and updates as those of Stable-Baselines3's own PPO."""

import itertools

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
from quadruped_env.training.fast_ppo import FastPPO
from quadruped_env.training.models import make_model

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
    for one, two in zip(actual, expected, strict=True):
        np.testing.assert_allclose(one.detach(), two.detach(), atol=1e-2 * moved)
    records, names = [model.logger.name_to_value for model in models], []
    for name, value in records[1].items():
        if name.startswith("train/"):
            names.append(name)
            assert records[0][name] == pytest.approx(value, rel=1e-3, abs=1e-6), name
    assert len(names) == 11


def test_noise_is_standard_normal_and_correlated_over_steps_and_rollouts_as_asked():
    """An AR(1) process: correlation rho^k at lag k, also across the end of a rollout, and none between joints."""
    model = fresh(noise_correlation=0.8)
    rollouts = [model._noise(40, 50, 8).numpy().copy() for _ in range(10)]
    noise = np.concatenate(rollouts)
    # 160,000 values, of which each is worth about a ninth of an independent one.
    assert noise.mean() == pytest.approx(0.0, abs=0.03)
    assert noise.var() == pytest.approx(1.0, abs=0.04)
    for lag in (1, 3):
        assert (noise[lag:] * noise[:-lag]).mean() == pytest.approx(0.8**lag, abs=0.04)
    across = np.mean([(one[-1] * two[0]).mean() for one, two in itertools.pairwise(rollouts)])
    assert across == pytest.approx(0.8, abs=0.08)
    assert (noise[..., 0] * noise[..., 1]).mean() == pytest.approx(0.0, abs=0.05)
    white = fresh()._noise(40, 50, 8).numpy()
    assert (white[1:] * white[:-1]).mean() == pytest.approx(0.0, abs=0.04)


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
