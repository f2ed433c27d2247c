"""Other algorithms through the same program: their actors as policies, their settings, their runs."""

import csv
import dataclasses
import json

import numpy as np
import pytest
import torch
from networks import perturb
from trainings import assert_complete, learn, progress

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.export import PolicyInterface, runtime
from quadruped_env.export.onnx_graph import policy_graph
from quadruped_env.policies import Policy, load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig
from quadruped_env.training import TrainConfig
from quadruped_env.training.algorithms import ALGORITHMS, SETTINGS
from quadruped_env.training.recipes import with_recipe
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE
from quadruped_env.training.sb3_models import algorithm_class, go_on_from, make_model
from quadruped_env.training.schedules import Scheduled

WIDTH = make_sb3_vec_env(1, seed=0).observation_space.shape[0]
OFF_POLICY = [name for name, entry in ALGORITHMS.items() if not entry.on_policy]
TINY = {
    "num_envs": 4,
    "n_steps": 8,
    "batch_size": 16,
    "hidden": (8, 6),
    "buffer_size": 2000,
    "learning_starts": 64,
    "gradient_steps": 2,
    "checkpoint_seconds": 1e6,
    "asymmetric_critic": False,
}


def config_of(name, **changes):
    """A tiny training; without sb3-contrib the test is skipped."""
    if ALGORITHMS[name].module.startswith("sb3_contrib"):
        pytest.importorskip("sb3_contrib")
    return TrainConfig(algo=name, **{**TINY, **changes})


def model_of(name, robot=MINI_QUADRUPED, **changes):
    """A model with random parameters, also in its batch renormalization, and its env."""
    config = config_of(name, **changes)
    torch.manual_seed(0)
    env = make_sb3_vec_env(4, seed=0, privileged=config.asymmetric_critic, robot=robot)
    model = make_model(config, env)
    perturb(model)
    with torch.no_grad():
        for key, values in model.policy.named_buffers():
            if key.endswith("ra_mean"):
                values.copy_(torch.randn_like(values))
            if key.endswith("ra_var"):
                values.copy_(0.5 + torch.rand_like(values))
    return model, env


def observations(width, seed=0):
    return np.random.default_rng(seed).uniform(-1.0, 1.0, (200, width)).astype(np.float32)


def test_training_has_the_same_bits_whatever_the_number_of_threads():
    weights = []
    for threads in (1, 2):
        torch.set_num_threads(threads)
        config = TrainConfig(num_envs=64, n_steps=16, batch_size=1024, n_epochs=1)
        model = make_model(config, make_sb3_vec_env(config.num_envs, seed=0))
        model.learn(1024)
        weights.append([parameter.detach().clone() for parameter in model.policy.parameters()])
    assert all(map(torch.equal, *weights))


@pytest.mark.parametrize("symmetric", [True, False])
@pytest.mark.parametrize("activation", ["elu", "tanh"])
@pytest.mark.parametrize("name", ALGORITHMS)
def test_policy_predicts_what_the_algorithm_does(name, activation, symmetric, tmp_path):
    model, env = model_of(name, symmetric=symmetric, activation=activation)
    Policy.from_sb3(model, {}).save(tmp_path)
    policy = load_policy(tmp_path)
    assert policy.output == ("clip" if ALGORITHMS[name].on_policy else "tanh")
    seen = observations(WIDTH)
    expected, _ = model.predict(seen, deterministic=True)
    np.testing.assert_allclose(policy.predict(seen), expected, atol=2e-5)
    assert np.ptp(expected, axis=0).min() > 0.01
    mirror = MirrorMap.of(env.task.control.layout)
    difference = np.abs(policy.predict(mirror.observation(seen)) - mirror.action(policy.predict(seen))).max()
    assert (difference < 1e-4) == symmetric
    assert np.abs(policy.predict(50.0 * seen)).max() <= 1.0


@pytest.mark.parametrize("name", ["ppo", "sac", "td3"])
def test_symmetric_actor_of_a_robot_whose_joints_turn_the_other_way_on_the_other_side(name):
    """Half of the joints."""
    robot = dataclasses.replace(MINI_QUADRUPED, mirror_signs=(-1, 1) * 4)
    model, env = model_of(name, robot=robot, activation="tanh")
    mirror, seen = MirrorMap.of(env.task.control.layout), observations(WIDTH)
    assert mirror.action_sign.tolist() == [-1.0, 1.0] * 4
    actions, mirrored = (model.predict(one, deterministic=True)[0] for one in (seen, mirror.observation(seen)))
    np.testing.assert_allclose(mirrored, mirror.action(actions), atol=1e-4)
    assert np.abs(actions).min(axis=0).max() > 0.0


@pytest.mark.parametrize("name", [name for name, entry in ALGORITHMS.items() if entry.on_policy])
def test_gradient_steps_keep_a_symmetric_network_symmetric_to_the_last_bit(name):
    model, _ = model_of(name)
    before = [parameter.detach().clone() for parameter in model.policy.parameters()]
    model.learn(3 * model.n_steps * model.n_envs, Scheduled())
    after = [parameter.detach().clone() for parameter in model.policy.parameters()]
    assert any(not torch.equal(one, two) for one, two in zip(before, after, strict=True))
    model.policy.project()
    for one, two in zip(after, model.policy.parameters(), strict=True):
        assert torch.equal(one, two)


@pytest.mark.parametrize("name", ["sac", "td3"])
def test_exported_graph_squashes_as_the_policy_does(name):
    pytest.importorskip("onnx", reason="ONNX is not installed: pip install -e '.[export]'")
    model, _ = model_of(name)
    interface = PolicyInterface(Policy.from_sb3(model, {}))
    assert runtime.largest_difference(interface, policy_graph(interface, name), 2000) < 1e-5


@pytest.mark.parametrize("symmetric", [True, False])
@pytest.mark.parametrize("name", OFF_POLICY)
def test_actor_of_an_asymmetric_training_does_not_see_the_privileged_readings(name, symmetric):
    model, env = model_of(name, asymmetric_critic=True, symmetric=symmetric)
    width = env.observation_space.shape[0]
    assert width > WIDTH
    policy = Policy.from_sb3(model, {})
    assert policy.weights[0].shape[0] == WIDTH
    seen = torch.as_tensor(observations(width)).requires_grad_()
    model.policy.set_training_mode(False)
    model.policy.actor(seen).square().sum().backward()
    assert (seen.grad[:, WIDTH:] == 0.0).all()
    assert (seen.grad[:, :WIDTH] != 0.0).any(dim=0).all()
    all_columns = seen.detach().numpy()
    expected, _ = model.predict(all_columns, deterministic=True)
    np.testing.assert_allclose(policy.predict(all_columns[:, :WIDTH]), expected, atol=2e-5)
    other = observations(width)
    other[:, WIDTH:] += 0.3
    one, two = (values_of(model, x) for x in (seen.detach(), torch.as_tensor(other)))
    assert (one - two).abs().max() > 1e-3


def values_of(model, seen):
    """Values of all critics at the action 0, in one column or several."""
    with torch.no_grad():
        found = model.critic(seen, torch.zeros(len(seen), 8))
    return torch.cat(found, dim=-1) if isinstance(found, tuple) else found


# --- settings ---


def test_settings_of_each_algorithm_are_arguments_of_its_class():
    """Every algorithm is made with the values of its settings."""
    values = {"gamma": 0.9, "learning_rate": 5e-4, "n_steps": 6, "batch_size": 12, "tau": 0.25, "learning_starts": 77}
    for name, entry in ALGORITHMS.items():
        try:
            model, _ = model_of(name, **values)
        except pytest.skip.Exception:
            continue
        assert type(model) is algorithm_class(name)
        assert model.gamma == 0.9
        assert model.learning_rate() == pytest.approx(5e-4)
        if entry.on_policy:
            assert model.n_steps == 6
        else:
            assert model.train_freq.frequency == 6
            assert (model.learning_starts, model.batch_size, model.gradient_steps) == (77, 12, 2)
            assert model.buffer_size == 2000
        if "tau" in entry.settings:
            assert model.tau == 0.25
        assert model.seed == 0


def test_program_takes_the_defaults_of_the_algorithm(asked):
    assert asked("--algo", "ppo") == asked()
    config = asked("--algo", "sac", "--gamma", "0.9")
    assert (config.algo, config.name, config.gamma) == ("sac", "sac", 0.9)
    for field, value in ALGORITHMS["sac"].defaults.items():
        assert getattr(config, field) == value
    config = asked("--algo", "td3", "--batch-size", "64", "--recipe", "walker", "--name", "mine")
    assert (config.batch_size, config.name, config.asymmetric_critic) == (64, "mine", True)


@pytest.mark.parametrize(
    ("algo", "given", "message"),
    [
        ("sac", {"clip_range": 0.1}, r"^training.clip_range: sac does not use it; leave it out, or choose algo ppo$"),
        ("sac", {"action_noise": 0.1}, r"^training.action_noise: sac does not use it; .* algo td3 or ddpg$"),
        ("ppo", {"tau": 0.1}, r"^training.tau: ppo does not use it; .*sac or td3 or ddpg or tqc"),
        ("a2c", {"n_epochs": 2}, r"^training.n_epochs: a2c does not use it"),
        ("crossq", {"tau": 0.1}, r"^training.tau: crossq does not use it"),
    ],
)
def test_setting_that_the_algorithm_does_not_use_is_refused(algo, given, message):
    with pytest.raises(QuadrupedError, match=message):
        with_recipe({"algo": algo, **given}, MINI_QUADRUPED)


def test_every_setting_that_not_all_algorithms_use_is_a_field():
    assert {field.name for field in dataclasses.fields(TrainConfig)} >= SETTINGS


def test_algorithm_without_its_library_names_the_extra(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "sb3_contrib", None)
    monkeypatch.setitem(sys.modules, "sb3_contrib.tqc", None)
    with pytest.raises(MissingExtraError, match=r"algorithm tqc needs the 'contrib' extra"):
        algorithm_class("tqc")


# --- runs ---


@pytest.mark.slow
@pytest.mark.parametrize("name", ALGORITHMS)
def test_training_leaves_a_complete_run_that_can_be_resumed_and_walks_in_its_env(name, tmp_path):
    config = config_of(name, timesteps=512, symmetric=name != "td3", asymmetric_critic=name in ("a2c", "crossq"))
    run = learn(tmp_path, config)
    policy = assert_complete(run)
    assert (policy.card["algo"], policy.card["timesteps"]) == (name, 512)
    assert json.loads((run / CONFIG_FILE).read_text())["training"]["algo"] == name
    parent = Parent.load(run)
    # A learning rate so low that the network stays as the first run left it.
    again = learn(tmp_path, dataclasses.replace(parent.config, timesteps=256, learning_rate=1e-9), parent)
    resumed = assert_complete(again)
    assert resumed.card["timesteps"] == 768
    assert [int(row["timesteps"]) for row in progress(again)][: len(parent.curve)] == [
        int(row["timesteps"]) for row in parent.curve
    ]
    # The statistics of CrossQ go on, and TRPO's step has another size.
    if name not in ("crossq", "trpo"):
        for one, other in zip(policy.weights, resumed.weights, strict=True):
            np.testing.assert_allclose(one, other, atol=1e-6)
    env = policy.make_env()
    observation, _ = env.reset(seed=0)
    for _ in range(20):
        observation, *_ = env.step(policy.predict(observation))
    assert observation in env.observation_space


def test_off_policy_training_has_the_steps_and_schedules_of_its_budget(tmp_path):
    """The learning rate falls linearly to a tenth with the budget, as PPO's does."""
    rates = []
    cls = algorithm_class("sac")
    update = cls.train

    def watched(self, *args, **kwargs):
        update(self, *args, **kwargs)
        rates.append(self.actor.optimizer.param_groups[0]["lr"])

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(cls, "train", watched)
        run = learn(tmp_path, config_of("sac", timesteps=320, learning_rate=1e-3))
    # An update after each 32 steps, beginning after the 64 random ones.
    np.testing.assert_allclose(rates, [1e-3 * (0.1 + 0.9 * (1 - step / 320)) for step in range(96, 321, 32)])
    policy = assert_complete(run)
    assert policy.card["budget_left"] == 0.0
    with (run / "progress.csv").open() as file:
        assert int(list(csv.DictReader(file))[-1]["timesteps"]) == 320
    assert policy.config == TaskConfig.from_dict(json.loads((run / CONFIG_FILE).read_text())["task"])


def test_resumed_training_takes_over_the_weight_of_the_entropy(tmp_path):
    run = learn(tmp_path, config_of("sac", timesteps=320, learning_rate=1e-2))
    parent = Parent.load(run)
    model, _ = model_of("sac", learning_rate=1e-2)
    assert model.log_ent_coef.item() == 0.0
    go_on_from(model, parent)
    assert model.log_ent_coef.item() < -0.02, "Adam moved it by the learning rate in each of 16 gradient steps"
    assert model.num_timesteps == 320
    exported = Policy.from_sb3(model, {})
    for one, other in zip(exported.weights, load_policy(run).weights, strict=True):
        np.testing.assert_array_equal(one, other)
