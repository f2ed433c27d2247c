"""A training on several ranks: gradients, advantages, envs, statistics and settings, with threads in place of gloo."""

import argparse
import dataclasses

import numpy as np
import pytest
import torch
from rank_threads import on_ranks
from stable_baselines3.common.logger import configure
from trainings import SMALL, STEPS

from quadruped_env import QuadrupedError
from quadruped_env.cli import train
from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.scale.ranks.job import Job
from quadruped_env.scale.ranks.rank_model import normalized_over_ranks
from quadruped_env.scale.ranks.torch_group import RankGroup
from quadruped_env.scale.ranks.training_launch import Place, launch, torchrun_place
from quadruped_env.training import TrainConfig
from quadruped_env.training import train as training
from quadruped_env.training.group import DifferentWeightsError, checksum, flat, unflatten
from quadruped_env.training.resume import Parent
from quadruped_env.training.sb3_models import make_model
from quadruped_env.training.step_statistics import StepStatistics

RANKS = 2
BUFFERS = ("observations", "actions", "rewards", "returns", "values", "log_probs", "advantages", "episode_starts")


def weights(model):
    return flat(model.policy.parameters())


def collected(config):
    """A plain model after a rollout."""
    model = make_model(config, make_sb3_vec_env(config.num_envs, seed=config.seed, privileged=True))
    _, callback = model._setup_learn(STEPS)
    model.set_logger(configure(None, []))
    model.collect_rollouts(model.env, callback, model.rollout_buffer, model.n_steps)
    return model


def share_of(model, config, group):
    """A rank's model with the weights of a plain model, and its share of that one's rollout."""
    own = training.prepare(config, None, None, group)[3]
    own._setup_learn(STEPS)
    own.set_logger(configure(None, []))
    unflatten(weights(model), own.policy.parameters())
    envs = slice(group.rank * own.n_envs, (group.rank + 1) * own.n_envs)
    for name in BUFFERS:
        getattr(own.rollout_buffer, name)[:] = getattr(model.rollout_buffer, name)[:, envs]
    own.rollout_buffer.full = True
    return own


@pytest.mark.parametrize("max_grad_norm", [1e3, 1e-3])
@pytest.mark.parametrize("ranks", [2, 4])
def test_shares_of_a_batch_give_the_gradient_and_the_step_of_the_whole_batch(ranks, max_grad_norm):
    # One batch, so the order of the samples does not matter.
    config = TrainConfig(**SMALL | {"batch_size": STEPS, "n_epochs": 2, "max_grad_norm": max_grad_norm})
    whole = collected(config)
    # Shares that differ in their mean and spread.
    whole.rollout_buffer.advantages *= np.arange(1.0, 1.0 + config.num_envs, dtype=np.float32)
    whole.rollout_buffer.advantages += np.arange(config.num_envs, dtype=np.float32)
    shared = dataclasses.replace(config, ranks=ranks)
    before = weights(whole)

    def update(group):
        model = share_of(whole, shared, group)
        model.train()
        return flat(parameter.grad for parameter in model.policy.parameters()), weights(model)

    results = on_ranks(ranks, update)
    whole.train()
    gradient = flat(parameter.grad for parameter in whole.policy.parameters())
    assert gradient.norm() > 0.9e-3
    assert (weights(whole) - before).abs().max() > 1e-4, "a step that can be compared"
    for own_gradient, own_weights in results:
        torch.testing.assert_close(own_gradient, gradient, rtol=1e-4, atol=1e-6 * float(gradient.norm()))
        torch.testing.assert_close(own_weights, weights(whole), rtol=0.0, atol=4e-6)
    assert len({checksum([own_weights]) for _, own_weights in results}) == 1


def test_advantages_are_normalized_over_the_shares_of_all_ranks():
    values = torch.randn(30, generator=torch.Generator().manual_seed(0)) * 3.0 + 7.0
    found = on_ranks(3, lambda group: normalized_over_ranks([values.split(10)[group.rank]], group)[0])
    torch.testing.assert_close(torch.cat(found), (values - values.mean()) / values.std())


def test_one_rank_gives_the_bits_of_plain_training(run, tmp_path):
    config = Parent.load(run).config
    asked = launch(Job(dataclasses.replace(config, ranks=1, task={}), tmp_path / "asked", "test"))[0]
    forced = training.train(dataclasses.replace(config, task={}), tmp_path / "forced", "test", group=RankGroup())[0]
    expected = (run / "policy.safetensors").read_bytes()
    assert (asked / "policy.safetensors").read_bytes() == expected
    assert (forced / "policy.safetensors").read_bytes() == expected, "also by the model for several ranks"


def test_envs_of_the_ranks_are_those_of_one_rank():
    config = TrainConfig(**SMALL | {"seed": 5, "ranks": 2})
    whole = make_model(config, make_sb3_vec_env(config.num_envs, seed=config.seed, privileged=True)).env.reset()
    shares = on_ranks(2, lambda group: training.prepare(config, None, None, group)[3].env.reset())
    np.testing.assert_array_equal(np.concatenate(shares), whole)
    assert len(np.unique(whole, axis=0)) == len(whole)


def test_ranks_begin_with_the_same_weights_also_if_they_draw_different_ones():
    def begin(group):
        # As CPUs of two types do, whose linear algebra rounds differently.
        config = TrainConfig(**SMALL | {"seed": group.rank, "ranks": 2})
        return weights(training.prepare(config, None, None, group)[3])

    one, other = on_ranks(2, begin)
    assert torch.equal(one, other)


def test_broadcast_gives_the_tensors_of_rank_0():
    def run(group):
        tensors = [torch.full((2, 3), 1.0 + group.rank), torch.tensor([float("nan"), 7.0])[group.rank :]]
        if group.rank:
            tensors[1] = torch.zeros(2)
        group.broadcast(tensors)
        return tensors

    for matrix, vector in on_ranks(3, run):
        assert torch.equal(matrix, torch.ones(2, 3))
        assert torch.isnan(vector[0])
        assert vector[1] == 7.0


def test_different_weights_are_an_error_on_every_rank_that_names_them():
    def run(group):
        values = torch.ones(5)
        group.check_same([values], "at first")
        if group.rank == 1:
            values[3] += 1e-7
        with pytest.raises(DifferentWeightsError, match=r"weights of 1 differ from those of rank 0 after 96 steps"):
            group.check_same([values], "after 96 steps")

    on_ranks(3, run)


def test_weights_are_compared_after_every_update():
    config = TrainConfig(**SMALL)
    whole, shared = collected(config), dataclasses.replace(config, ranks=2)

    def update(group):
        model = share_of(whole, shared, group)
        model.train()
        if group.rank == 1:
            model.policy.log_std.data += 1e-6
        with pytest.raises(DifferentWeightsError, match="weights of 1 differ"):
            model.train()

    on_ranks(2, update)


# --- statistics ---


class Recorded(StepStatistics):
    """Statistics that keep what this rank had before the exchange, and may be stopped after some rollouts."""

    def __init__(self, group, rollouts):
        super().__init__(group)
        self.own, self.shared, self.rollouts = [], [], rollouts

    def _on_rollout_end(self):
        self.own.append(self._own.copy())
        self.stopped = len(self.own) == self.rollouts
        super()._on_rollout_end()
        self.shared.append((np.concatenate([np.ravel(part) for part in self.sums]), self.mean_levels()))
        self.steps, self.budget_left = self.num_timesteps, self.schedule.left
        self.tiles = self._task.tiles
        self._clear()


def test_statistics_are_those_of_all_ranks_and_one_rank_stops_all():
    # Some fall; the terrain has levels.
    task = {"termination": {"max_tilt": 0.04}, "terrain": {"name": "tiles", "curriculum": True}}
    config = TrainConfig(**SMALL | {"ranks": 2, "timesteps": 50 * STEPS, "n_steps": 40, "task": task})

    def run(group):
        _, _, _, model = training.prepare(config, None, None, group)
        model.set_logger(configure(None, []))
        # Rank 1 alone is asked to stop.
        found = Recorded(group, 3 if group.rank else 99)
        training.learn(config, model, found, fresh=True)
        return found

    one, other = on_ranks(2, run)
    assert len(one.own) == len(other.own) == 3
    assert [one.ended, other.ended, one.stopped] == [True] * 3
    assert one.steps == other.steps == 3 * config.num_envs * config.n_steps
    assert one.budget_left == other.budget_left == 1.0 - one.steps / config.timesteps
    for index in range(3):
        expected = (one.own[index] + other.own[index]) / 2.0
        expected[-1] *= 2.0
        for found in (one, other):
            np.testing.assert_allclose(found.shared[index][0], expected, rtol=1e-12)
    assert sum(own[-1] for own in one.own) > 0
    levels = np.concatenate([one.tiles.level, other.tiles.level])
    assert one.shared[-1][1]["mean_level"] == levels.mean()
    assert one.shared[-1][1] == other.shared[-1][1]


# --- settings ---


@pytest.mark.parametrize(
    ("changes", "error"),
    [
        ({"ranks": 0}, r"--ranks: expected 1 or more, .*; found 0"),
        ({"ranks": 300}, r"--ranks: found 300, more than the 256 envs .*; lower it, or give more --num-envs"),
        ({"ranks": 3}, r"--ranks: found 3, .* --num-envs 256 .*; choose --num-envs 255 or --num-envs 258"),
        ({"ranks": 4, "batch_size": 1022}, r"--ranks: found 4, .*; choose --batch-size 1020 or --batch-size 1024"),
        ({"ranks": 4, "batch_size": 4}, r"2 or more samples per rank.*--batch-size 8"),
        ({"ranks": 2, "algo": "sac"}, r"--ranks: found 2 with --algo sac; .*choose --algo ppo"),
    ],
)
def test_ranks_that_cannot_share_a_training_are_errors_with_a_fix(changes, error):
    with pytest.raises(QuadrupedError, match=error):
        TrainConfig(**changes)


# --- torchrun ---

TORCHRUN = {"RANK": "3", "WORLD_SIZE": "8", "LOCAL_WORLD_SIZE": "4", "MASTER_ADDR": "node-0", "MASTER_PORT": "29500"}


@pytest.mark.parametrize(
    ("environment", "found"),
    [
        (TORCHRUN, Place(3, 8, 4, 0)),
        *((environment, None) for environment in ({}, {"RANK": "0"}, {"RANK": "0", "WORLD_SIZE": "1"})),
    ],
)
def test_place_of_a_process_is_that_of_torchrun_if_there_are_other_ranks(environment, found):
    assert torchrun_place(environment) == found


@pytest.mark.parametrize(
    ("changes", "error"),
    [
        ({"RANK": None}, r"RANK: WORLD_SIZE is 8, and this environment variable is missing; start the ranks with"),
        ({"MASTER_ADDR": None}, r"MASTER_ADDR: .*is missing"),
        ({"RANK": "8"}, r"RANK: expected 0 to 7, since WORLD_SIZE is 8; found 8"),
        ({"WORLD_SIZE": "many"}, r"WORLD_SIZE: expected a whole number of 1 or more .*; found 'many'"),
        ({"RANK": "-1"}, r"RANK: expected a whole number of 0 or more .*; found '-1'"),
    ],
)
def test_variables_of_torchrun_that_cannot_be_are_errors(changes, error):
    environment = {name: value for name, value in (TORCHRUN | changes).items() if value is not None}
    with pytest.raises(QuadrupedError, match=error):
        torchrun_place(environment)


def test_ranks_that_are_not_those_of_torchrun_are_an_error(monkeypatch):
    for name, value in TORCHRUN.items():
        monkeypatch.setenv(name, value)
    parser = argparse.ArgumentParser()
    train.add_arguments(parser)
    with pytest.raises(QuadrupedError, match=r"--ranks: found 2, and torchrun started 8 processes \(WORLD_SIZE\)"):
        train.run(parser.parse_args(["--ranks", "2"]), argparse.Namespace(line="train"))
