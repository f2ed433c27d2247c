"""Models of Stable-Baselines3 as policies: what a policy's file holds, and what it does not."""

import gymnasium
import numpy as np
import pytest
import stable_baselines3
import torch
from gymnasium.wrappers import RescaleAction
from stable_baselines3 import PPO, SAC
from stable_baselines3.common.vec_env import DummyVecEnv, SubprocVecEnv, VecCheckNan, VecFrameStack, VecNormalize

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.policies import Policy, load_policy
from quadruped_env.policies.activations import ACTIVATIONS, BY_CLASS
from quadruped_env.policies.sb3 import linear_layers
from quadruped_env.training.actor_critic import ActorCritic

NN = torch.nn
MODULES = ("Tanh", "ELU", "ReLU", "LeakyReLU", "SiLU", "GELU", "Softplus", "SELU", "Sigmoid", "Mish")
RANDOM = np.random.default_rng(0)
OFF_POLICY = {"buffer_size": 9}
LOW = np.full(8, -0.5, np.float32)


def model_of(kind, env=None, policy="MlpPolicy", **arguments):
    """A model whose parameters are random, also in the last layer."""
    torch.manual_seed(0)
    if policy != "LinearPolicy":
        arguments["policy_kwargs"] = {"net_arch": [16], **arguments.get("policy_kwargs", {})}
    model = kind(policy, env or make_sb3_vec_env(2, seed=0), device="cpu", **arguments)
    with torch.no_grad():
        for parameter in model.policy.parameters():
            parameter.add_(0.1 * torch.randn_like(parameter))
    return model


def seen(width=102):
    return np.random.default_rng(0).uniform(-1.0, 1.0, (200, width)).astype(np.float32)


def algorithm(name):
    return getattr(stable_baselines3, name, None) or getattr(pytest.importorskip("sb3_contrib"), name)


@pytest.mark.parametrize("module", MODULES)
def test_activation_is_torchs(module):
    x = np.concatenate([np.linspace(-30.0, 30.0, 2001), [-1e4, -1e-6, 0.0, 1e-6, 1e4]]).astype(np.float32)
    expected = getattr(NN, module)()(torch.from_numpy(x)).numpy()
    found = ACTIVATIONS[BY_CLASS[module.lower()]](x)
    assert found.dtype == np.float32
    np.testing.assert_allclose(found, expected, atol=1e-6, rtol=1e-6)


def test_every_activation_has_its_module():
    assert {BY_CLASS[module.lower()] for module in MODULES} == set(ACTIVATIONS)


@pytest.mark.parametrize(
    ("name", "policy", "arguments"),
    [
        ("PPO", "MlpPolicy", {"policy_kwargs": {"activation_fn": NN.SiLU, "net_arch": [16, 12, 8]}}),
        ("PPO", "MlpPolicy", {"policy_kwargs": {"net_arch": []}}),
        ("PPO", "MlpPolicy", {"use_sde": True, "policy_kwargs": {"squash_output": True}}),
        ("SAC", "MlpPolicy", {**OFF_POLICY, "policy_kwargs": {"activation_fn": NN.GELU}}),
        ("SAC", "MlpPolicy", {**OFF_POLICY, "use_sde": True, "policy_kwargs": {"clip_mean": 0.25}}),
        ("TQC", "MlpPolicy", {**OFF_POLICY, "use_sde": True}),
        ("TD3", "MlpPolicy", OFF_POLICY),
        ("DDPG", "MlpPolicy", OFF_POLICY),
        ("TRPO", "MlpPolicy", {}),
        ("TQC", "MlpPolicy", OFF_POLICY),
        ("CrossQ", "MlpPolicy", OFF_POLICY),
        ("ARS", "LinearPolicy", {}),
    ],
)
def test_plain_model_is_a_policy_that_can_be_saved_and_loaded(name, policy, arguments, tmp_path):
    model = model_of(algorithm(name), policy=policy, **arguments)
    made = Policy.from_sb3(model)
    made.save(tmp_path / "new" / "policy")
    loaded = load_policy(tmp_path / "new" / "policy")
    expected, _ = model.predict(seen(), deterministic=True)
    np.testing.assert_allclose(loaded.predict(seen()), expected, atol=1e-5)
    assert loaded.config == model.env.task.config
    assert loaded.card == {"algo": name.lower(), "seed": None, "timesteps": 0}
    assert loaded.make_env().observation_space.shape == (102,)


def test_task_is_that_of_the_models_env():
    """Also of single envs that Stable-Baselines3 has wrapped itself."""
    config = {"command": {"yaw_rate": [-0.3, 0.3]}}
    single = gymnasium.make("MiniQuadruped-v0", action_mode="residual", config=config)
    for env in (single, VecCheckNan(make_sb3_vec_env(2, action_mode="residual", config=config))):
        policy = Policy.from_sb3(model_of(PPO, env))
        assert policy.action_mode == "residual"
        assert policy.config == single.unwrapped.task.config


def normalized(env, width):
    """An env that normalizes by random statistics."""
    env = VecNormalize(env, clip_obs=1e6)
    env.obs_rms.mean, env.obs_rms.var = RANDOM.normal(0.0, 0.5, width), RANDOM.uniform(0.3, 2.0, width)
    return env


def test_normalization_of_observations_is_folded_into_the_first_layer():
    env = normalized(make_sb3_vec_env(2, seed=0), 102)
    model = model_of(PPO, env)
    policy, raw = Policy.from_sb3(model), RANDOM.normal(env.obs_rms.mean, 1.0, (200, 102)).astype(np.float32)
    expected, _ = model.predict(env.normalize_obs(raw), deterministic=True)
    np.testing.assert_allclose(policy.predict(raw), expected, atol=1e-3)
    assert np.abs(policy.predict(raw) - model.predict(raw, deterministic=True)[0]).max() > 0.05
    env.clip_obs = 1.5
    with pytest.warns(QuadrupedWarning, match=r"clips observations at 1.5 standard deviations, which \d+ columns can"):
        Policy.from_sb3(model)
    env.norm_obs = False
    expected, _ = model.predict(raw, deterministic=True)
    np.testing.assert_allclose(Policy.from_sb3(model).predict(raw), expected, atol=1e-5)


def test_normalization_of_privileged_readings_is_left_out():
    env = normalized(make_sb3_vec_env(2, seed=0, privileged=True), 122)
    model = PPO(ActorCritic, env, policy_kwargs={"actor_width": 102}, device="cpu")
    raw = RANDOM.normal(0.0, 1.0, (20, 122)).astype(np.float32)
    expected, _ = model.predict(env.normalize_obs(raw), deterministic=True)
    np.testing.assert_allclose(Policy.from_sb3(model).predict(raw[:, :102]), expected, atol=1e-3)


class Doubled(stable_baselines3.ppo.MlpPolicy):
    """A policy that computes its action in a way of its own."""

    def _predict(self, observation, deterministic=False):
        return 2.0 * super()._predict(observation, deterministic)


class Turned(gymnasium.ObservationWrapper):
    def observation(self, observation):
        return -observation


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda: model_of(algorithm("RecurrentPPO"), policy="MlpLstmPolicy"),
            r"RecurrentActorCriticPolicy is recurrent",
        ),
        (lambda: model_of(PPO, policy_kwargs={"activation_fn": NN.Softsign}), r"module Softsign"),
        (
            lambda: model_of(PPO, policy_kwargs={"activation_fn": lambda: NN.LeakyReLU(0.2)}),
            r"LeakyReLU\(negative_slope=0.2\)",
        ),
        (lambda: model_of(PPO, make_sb3_vec_env(2, privileged=True)), r"its actor sees 122 columns, and the env's"),
        (lambda: model_of(PPO, VecFrameStack(make_sb3_vec_env(2), 2)), r"its actor sees 204 columns"),
        (lambda: model_of(PPO, Turned(gymnasium.make("MiniQuadruped-v0"))), r"an ObservationWrapper, which changes"),
        (
            lambda: model_of(PPO, RescaleAction(gymnasium.make("MiniQuadruped-v0"), LOW, -LOW)),
            r"an ActionWrapper, which",
        ),
        (lambda: model_of(PPO, policy=Doubled), r"Doubled computes its action in a way of its own"),
        (
            lambda: model_of(SAC, use_sde=True, policy_kwargs={"activation_fn": NN.Tanh}, **OFF_POLICY),
            r"explores with gSDE and clips its mean \(clip_mean=2\), and is no ReLU network",
        ),
    ],
)
def test_model_that_a_policys_file_cannot_hold_names_the_protocol(make, message):
    with pytest.raises(QuadrupedError, match=rf"{message}.*two methods, reset and predict \(docs/training.md#your-own"):
        Policy.from_sb3(make())


class Halved(gymnasium.Wrapper):
    def step(self, action):
        observation, *rest = self.env.step(action)
        return observation / 2, *rest


def test_wrapper_that_may_change_observations_is_named():
    with pytest.warns(QuadrupedWarning, match=r"the env has the wrapper Halved, which the policy leaves out"):
        Policy.from_sb3(model_of(PPO, Halved(gymnasium.make("MiniQuadruped-v0"))))
    Policy.from_sb3(model_of(PPO, gymnasium.make("MiniQuadruped-v0")))  # whose own wrappers are no reason for a warning
    with pytest.raises(QuadrupedError, match=r"expected a model of Stable-Baselines3; found str"):
        Policy.from_sb3("flat")


def test_wrappers_of_envs_in_other_processes_are_found():
    envs = SubprocVecEnv([lambda: Turned(gymnasium.make("MiniQuadruped-v0"))], start_method="fork")
    try:
        with pytest.raises(QuadrupedError, match=r"an ObservationWrapper, which changes observations"):
            Policy.from_sb3(model_of(PPO, envs))
    finally:
        envs.close()


def test_model_without_an_env_of_this_package_is_refused(tmp_path):
    with pytest.raises(QuadrupedError, match=r"DummyVecEnv is not an env of this package; train in make_sb3_vec_env"):
        Policy.from_sb3(PPO("MlpPolicy", DummyVecEnv([lambda: gymnasium.make("Pendulum-v1")]), device="cpu"))
    model_of(PPO).save(tmp_path / "model")
    advice = (
        r"this PPO has no env; if it was trained in a VecNormalize, .*if it was not, with env=make_sb3_vec_env\(1\)"
    )
    with pytest.raises(QuadrupedError, match=advice):
        Policy.from_sb3(PPO.load(tmp_path / "model", device="cpu"))


def test_model_of_a_vecnormalize_is_refused_in_an_env_without_one(tmp_path):
    """The statistics are not in the zip, and without them its actions are others."""
    model = model_of(PPO, VecNormalize(make_sb3_vec_env(2, seed=0)), n_steps=8, batch_size=16)
    model.learn(16)
    model.save(tmp_path / "model")
    for env in (None, make_sb3_vec_env(1)):
        with pytest.raises(QuadrupedError, match=r"trained in a VecNormalize, whose statistics are not in its zip"):
            Policy.from_sb3(PPO.load(tmp_path / "model", env=env, device="cpu"))


def test_batch_renormalization_is_folded_into_the_layer_behind_it():
    """By hand: y = W (s x + t) + b with s = scale / sqrt(var + eps) and t = bias - mean s."""
    renorm = type("BatchRenorm1d", (NN.Module,), {})()
    renorm.scale, renorm.bias = torch.tensor([2.0, 3.0]), torch.tensor([0.5, -1.0])
    renorm.ra_mean, renorm.ra_var, renorm.eps = torch.tensor([1.0, 2.0]), torch.tensor([3.0, 0.0]), 1.0
    linear = NN.Linear(2, 1)
    linear.weight.data, linear.bias.data = torch.tensor([[10.0, 100.0]]), torch.tensor([7.0])
    ((weight, bias),), _ = linear_layers([renorm, linear])
    # s = (1, 3), t = (-0.5, -7)
    np.testing.assert_allclose(weight, [[10.0], [300.0]])
    np.testing.assert_allclose(bias, [7.0 - 5.0 - 700.0])


@pytest.mark.parametrize(
    ("modules", "found"),
    [
        ([NN.Linear(3, 4), NN.ReLU(), NN.Linear(4, 4), NN.Tanh(), NN.Linear(4, 2)], "has the module Tanh"),
        ([NN.Linear(3, 4), NN.Linear(4, 2)], "has the module Linear"),
        ([NN.LayerNorm(3), NN.Linear(3, 2)], "has the module LayerNorm"),
        ([NN.Linear(3, 2), NN.ReLU()], "does not end with a linear layer"),
        ([], "does not end with a linear layer"),
    ],
)
def test_layers_that_a_policy_cannot_express_are_refused(modules, found):
    with pytest.raises(QuadrupedError, match=rf"its actor {found}; a policy's file holds linear layers"):
        linear_layers(modules)
