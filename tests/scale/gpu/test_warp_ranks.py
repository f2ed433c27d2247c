"""A training on MuJoCo Warp that several ranks share, on Warp's CPU device: updates, envs, statistics and processes."""

import dataclasses
import re
import threading
from types import SimpleNamespace

import pytest

torch = pytest.importorskip("torch", reason="torch is not installed: pip install -e '.[gpu]'")
pytest.importorskip("mujoco_warp", reason="MuJoCo Warp is not installed: pip install -e '.[gpu]'")
pytest.importorskip("rsl_rl", reason="rsl-rl is not installed: pip install -e '.[gpu]'")

import numpy as np  # noqa: E402
from rank_processes import check_death_of_a_rank  # noqa: E402
from rank_threads import on_ranks  # noqa: E402
from tensordict import TensorDict  # noqa: E402
from trainings import SMALL, STEPS, TINY, WARP_FILES, assert_complete, learn, needs_warp, progress, train  # noqa: E402

from quadruped_env.cli.main import main  # noqa: E402
from quadruped_env.control.symmetry import MirrorMap  # noqa: E402
from quadruped_env.policies import load_policy  # noqa: E402
from quadruped_env.scale.gpu import warp_training  # noqa: E402
from quadruped_env.scale.gpu.warp_env import FINAL, OBSERVATION, TIME_OUTS  # noqa: E402
from quadruped_env.scale.gpu.warp_ppo import make_ppo  # noqa: E402
from quadruped_env.scale.gpu.warp_training import WarpStatistics  # noqa: E402
from quadruped_env.scale.ranks.job import Job  # noqa: E402
from quadruped_env.simulation import BatchSimulation  # noqa: E402
from quadruped_env.task import Task, TaskConfig  # noqa: E402
from quadruped_env.training import TrainConfig  # noqa: E402
from quadruped_env.training.group import DifferentWeightsError, Group, checksum, flat, unflatten  # noqa: E402
from quadruped_env.training.resume import Parent  # noqa: E402
from quadruped_env.training.train import learn as learn_model  # noqa: E402
from quadruped_env.training.train import prepare  # noqa: E402

CONFIG = TrainConfig(**SMALL | {"device": "warp-cpu", "batch_size": STEPS, "n_epochs": 2, "asymmetric_critic": False})
ON_WARP = ("--device", "warp-cpu")
ROLLOUT = ("observations", "actions", "rewards", "dones", "values", "actions_log_prob")


def weights(ppo):
    return flat([*ppo.actor.parameters(), *ppo.critic.parameters()])


def gradient(ppo):
    return flat(parameter.grad for parameter in [*ppo.actor.parameters(), *ppo.critic.parameters()])


@pytest.fixture(scope="module")
def task():
    return Task(BatchSimulation(TaskConfig().compiled_model(), 1), TaskConfig())


def observations(task, num_envs):
    """Observations of envs without physics, whose scales differ."""
    width = len(MirrorMap.of(task.control.layout).observation_order)
    values = torch.randn(num_envs, width) * torch.arange(1.0, 1.0 + num_envs).unsqueeze(1)
    return TensorDict({OBSERVATION: values}, batch_size=[num_envs])


def envs_without_physics(task, num_envs):
    """All of a vector env that PPO reads when it is made."""
    seen = observations(task, num_envs)
    return SimpleNamespace(
        task=task, num_envs=num_envs, num_actions=8, device="cpu", privileged_layout=None, get_observations=lambda: seen
    )


def collected(task, config):
    """Plain PPO after a rollout, and its last observations. Rewards differ in mean and spread from env to env."""
    ppo = make_ppo(config, envs_without_physics(task, config.num_envs), Group())
    own = torch.arange(1.0, 1.0 + config.num_envs)
    with torch.no_grad():
        for parameter in [*ppo.actor.parameters(), *ppo.critic.parameters()]:
            parameter.add_(0.1 * torch.randn_like(parameter))
        seen = observations(task, config.num_envs)
        for _ in range(config.n_steps):
            ppo.act(seen)
            seen = observations(task, config.num_envs)
            done = torch.rand(config.num_envs) < 0.2
            extras = {FINAL: seen, TIME_OUTS: torch.zeros_like(done)}
            ppo.process_env_step(seen, own * torch.randn(config.num_envs) + own, done, extras)
    return ppo, seen


def share_of(ppo, seen, task, config, group):
    """A rank's PPO with the weights of a plain one, and its share of that one's rollout and last observations."""
    share = config.num_envs // group.ranks
    own = make_ppo(config, envs_without_physics(task, share), group)
    unflatten(weights(ppo), [*own.actor.parameters(), *own.critic.parameters()])
    envs = slice(group.rank * share, (group.rank + 1) * share)
    for name in ROLLOUT:
        getattr(own.storage, name).copy_(getattr(ppo.storage, name)[:, envs])
    own.storage.distribution_params = tuple(part[:, envs].clone() for part in ppo.storage.distribution_params)
    with torch.no_grad():
        own.compute_returns(seen[envs])
    return own


@pytest.mark.parametrize("max_grad_norm", [1e3, 1e-3])
@pytest.mark.parametrize("ranks", [2, 4])
def test_shares_of_a_batch_give_the_gradient_and_the_step_of_the_whole_batch(task, ranks, max_grad_norm):
    # One batch, so the order of the samples does not matter.
    config = dataclasses.replace(CONFIG, max_grad_norm=max_grad_norm)
    whole, seen = collected(task, config)
    before = weights(whole)
    shared = dataclasses.replace(config, ranks=ranks)

    def update(group):
        ppo = share_of(whole, seen, task, shared, group)
        ppo.update()
        return gradient(ppo), weights(ppo)

    results = on_ranks(ranks, update)
    with torch.no_grad():
        whole.compute_returns(seen)
    whole.update()
    expected = gradient(whole)
    assert expected.norm() > 0.9e-3
    assert (weights(whole) - before).abs().max() > 1e-4, "a step that can be compared"
    for own_gradient, own_weights in results:
        torch.testing.assert_close(own_gradient, expected, rtol=1e-4, atol=1e-5 * float(expected.norm()))
        torch.testing.assert_close(own_weights, weights(whole), rtol=0.0, atol=2e-2 * config.learning_rate)
    assert len({checksum([own_weights]) for _, own_weights in results}) == 1


def test_ranks_begin_with_the_same_weights_and_explore_with_noise_of_their_own(task):
    def begin(group):
        # As GPUs of two types do, whose arithmetic rounds differently.
        return weights(make_ppo(dataclasses.replace(CONFIG, seed=group.rank), envs_without_physics(task, 2), group))

    one, other = on_ranks(2, begin)
    assert torch.equal(one, other)
    noise = []
    for group in (Group(), *(Group(rank, 3) for rank in range(3))):
        make_ppo(CONFIG, envs_without_physics(task, 2), group)
        noise.append(torch.randn(4).tolist())
    assert noise[0] == noise[1], "rank 0 has that of plain training"
    assert len({*map(tuple, noise)}) == 3


# --- GPUs ---


OF_TORCHRUN = {
    "RANK": 5, "WORLD_SIZE": 8, "LOCAL_RANK": 1, "LOCAL_WORLD_SIZE": 4, "MASTER_ADDR": "node", "MASTER_PORT": 29500
}  # fmt: skip


@pytest.mark.parametrize(
    ("arguments", "variables", "gpus", "message"),
    [
        ("--ranks 2", {}, 1, "--ranks: found 2 ranks on this machine .*, and torch finds 1 GPU; choose --ranks 1, or"),
        ("--ranks 2", {}, 0, "--ranks: found 2 ranks .*torch finds 0 GPUs; check that nvidia-smi shows them"),
        ("", OF_TORCHRUN, 2, "--ranks: found 4 ranks on this machine"),
        ("--ranks 2 --launcher ray --address 127.0.0.1:1", {}, 2, "--launcher: found ray with --device cuda; "),
    ],
)
def test_ranks_that_cannot_have_a_gpu_each_are_an_error(
    arguments, variables, gpus, message, monkeypatch, tmp_path, capsys
):
    for name, value in variables.items():
        monkeypatch.setenv(name, str(value))
    monkeypatch.setattr(torch.cuda, "device_count", lambda: gpus)
    assert main(["train", "--device", "cuda", *arguments.split(), "--output", str(tmp_path / "runs")]) == 2
    (error,) = (line for line in capsys.readouterr().err.splitlines() if "error" in line)
    assert re.search(message, error)
    assert not (tmp_path / "runs").exists()


def test_each_rank_has_the_gpu_of_its_place_on_its_machine():
    rank = Group(5, 8, local_rank=1)
    assert [warp_training.device_of(device, rank) for device in ("cuda", "warp-cpu")] == ["cuda:1", "cpu"]
    for device, name in {"cuda": "cuda", "cuda:1": "cuda:1", "warp-cpu": "cpu"}.items():
        assert warp_training.device_of(device, Group()) == name


def test_first_line_names_the_batch_after_rounding(tmp_path):
    config = TrainConfig(device="cuda", ranks=2, num_envs=100, n_steps=10, batch_size=300)
    line = Job(config, tmp_path, "test").description(1)
    assert line.startswith(
        "2 ranks of 50 envs and one GPU each; effective batch: 332 samples, 166 per rank; 18 gradient steps after"
    )


# --- the task on Warp ---


@needs_warp
def test_envs_of_the_ranks_are_those_of_one_rank():
    def seen(config, group):
        return prepare(config, None, None, group, trainer=warp_training.ON_WARP)[2].get_observations()[OBSERVATION]

    whole = seen(dataclasses.replace(CONFIG, seed=5), Group())
    shares = [seen(dataclasses.replace(CONFIG, seed=5, ranks=2), Group(rank, 2)) for rank in range(2)]
    assert torch.equal(torch.cat(shares), whole)
    assert len(whole.unique(dim=0)) == len(whole)


class Recorded(WarpStatistics):
    """Statistics that keep what is shared after each rollout, clear it after two, and may be stopped after some."""

    def __init__(self, group, rollouts):
        super().__init__(group)
        self.shared, self.rollouts = [], rollouts

    def _on_rollout_end(self):
        self.stopped = len(self.shared) + 1 == self.rollouts
        super()._on_rollout_end()
        self.shared.append(np.concatenate([np.ravel(part) for part in self.sums]))
        if len(self.shared) == 2:
            self._clear()


def watch_steps(env, lock):
    """Let one env at a time advance; returns a list that gets the errors, terms and falls of each step."""
    step, steps = env.step, []

    def watched(actions):
        with lock:
            found = step(actions)
        falls = (found[2] & ~found[3][TIME_OUTS]).sum()
        squares = env.task.tracking_error.numpy() ** 2
        steps.append(np.concatenate([squares.mean(0), env.last_terms.numpy().mean(0), [float(falls)]]))
        return found

    env.step = watched
    return steps


@needs_warp
def test_statistics_are_those_of_all_ranks_and_one_rank_stops_all():
    # Some fall.
    config = dataclasses.replace(
        CONFIG, ranks=2, timesteps=50 * 160, n_steps=40, task={"termination": {"max_tilt": 0.04}}
    )
    envs = [prepare(config, None, None, Group(rank, 2), trainer=warp_training.ON_WARP)[2] for rank in range(2)]
    lock = threading.Lock()

    def run(group):
        model = warp_training.WarpModel(config, envs[group.rank], group)
        steps = watch_steps(envs[group.rank], lock)
        # Rank 1 alone is asked to stop.
        found = Recorded(group, 3 if group.rank else 99)
        learn_model(config, model, found, fresh=True)
        return found, np.array(steps), model

    (one, own, model), (other, others, _) = on_ranks(2, run)
    assert len(one.shared) == len(other.shared) == 3
    assert [one.stopped, one.ended, other.ended] == [True] * 3
    assert model.num_timesteps == 3 * 160
    assert model.learning_rate.left == 1.0 - 3 / 50
    assert own[:, -1].sum() > 0, "some fall"
    for index, part in enumerate((slice(40), slice(80), slice(80, 120))):
        expected = (own[part].sum(0) + others[part].sum(0)) / 2.0
        expected[-1] *= 2.0
        for found in (one, other):
            np.testing.assert_allclose(found.shared[index], expected, rtol=1e-5, atol=1e-9)


@needs_warp
def test_weights_are_compared_after_every_update():
    config = dataclasses.replace(CONFIG, ranks=2, timesteps=5 * STEPS)
    envs = [prepare(config, None, None, Group(rank, 2), trainer=warp_training.ON_WARP)[2] for rank in range(2)]
    lock = threading.Lock()

    def run(group):
        model = warp_training.WarpModel(config, envs[group.rank], group)
        steps, update = watch_steps(envs[group.rank], lock), model.ppo.update

        def drift():
            update()
            if group.rank and len(steps) == 3 * config.n_steps:
                model.ppo.actor.distribution.log_std_param.data += 1e-6

        model.ppo.update = drift
        with pytest.raises(DifferentWeightsError, match=f"weights of 1 differ from those of rank 0 after {3 * STEPS} "):
            learn_model(config, model, WarpStatistics(group), fresh=True)

    on_ranks(2, run)


# --- processes ---


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """A finished tiny training on two ranks."""
    return train(tmp_path_factory.mktemp("runs"), *TINY, *ON_WARP, "--ranks", "2")


@needs_warp
def test_run_of_two_ranks_is_that_of_one_and_counts_the_steps_of_all(run):
    assert assert_complete(run, WARP_FILES).card["timesteps"] == int(TINY[1])
    assert Parent.load(run).config.ranks == 2
    assert len(list(run.parent.iterdir())) == 2, "one directory, and the link to it"
    assert int(progress(run)[-1]["timesteps"]) == int(TINY[1])


@needs_warp
def test_run_of_two_ranks_resumes_on_one_and_that_on_two(run, tmp_path):
    one = learn(tmp_path, Parent.load(run).resumed({"ranks": 1, "timesteps": 256}), run)
    assert load_policy(one).card["timesteps"] == int(TINY[1]) + 256
    two = train(tmp_path / "two", "--resume", one, "--ranks", "2", "--timesteps", "256")
    assert load_policy(two).card["timesteps"] == int(TINY[1]) + 512


@needs_warp
def test_rank_that_dies_ends_the_run_with_one_error_and_a_whole_checkpoint(tmp_path):
    check_death_of_a_rank(1, tmp_path, *ON_WARP)
