"""Privileged readings: true values, for the value function alone; the actor does not depend on them."""

import json
import math

import mujoco
import numpy as np
import pytest
import torch
from networks import perturb
from trainings import SMALL, STEPS, assert_complete, learn

from quadruped_env import QuadrupedError
from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.policies import Policy, load_policy
from quadruped_env.task import load_task_file, preset_values
from quadruped_env.task.privileged import PRIVILEGED
from quadruped_env.training import TrainConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE
from quadruped_env.training.sb3_models import make_model
from quadruped_env.training.schedules import Scheduled

WIDTH = make_sb3_vec_env(1, seed=0).observation_space.shape[0]
"""Of an observation, without privileged readings"""
NAMES = [field.name for field in PRIVILEGED]


def columns(env, name, observation):
    """Unscaled columns of a privileged reading."""
    where = env.privileged.layout.slices[name]
    return observation[:, WIDTH:][:, where] / env.privileged.layout.scale[where]


def test_observations_end_with_the_true_values_of_the_simulation():
    """Against MuJoCo's own data and each env's own model."""
    config = {"randomization": {"preset": "hard", "push_speed": None, "push_force": None}}
    env = make_sb3_vec_env(5, seed=0, privileged=True, config=config)
    plain = make_sb3_vec_env(5, seed=0, config=config)
    observation = env.reset()
    np.testing.assert_array_equal(observation[:, :WIDTH], plain.reset())
    rng, smooth = np.random.default_rng(0), np.zeros((5, 2))
    for _ in range(20):
        action = rng.uniform(-0.5, 0.5, (5, 8)).astype(np.float32)
        observation, reward, *_ = env.step(action)
        without, other_reward, *_ = plain.step(action)
        np.testing.assert_array_equal(observation[:, :WIDTH], without)
        np.testing.assert_array_equal(reward, other_reward)
        assert observation in env_space(env, observation)
        smooth += (1.0 - math.exp(-0.02 / 0.4)) * (forward_and_yaw(env) - smooth)
        np.testing.assert_allclose(columns(env, "smooth_velocity", observation), smooth, atol=1e-5)
    assert env.observation_space.shape == (WIDTH + env.privileged.layout.width,)
    simulation, robot = env.task.simulation, env.task.config.robot
    model = simulation.model
    for i in range(5):
        data = env.env.env_data(i)
        turn = np.zeros(9)
        mujoco.mju_quat2Mat(turn, data.qpos[3:7])
        velocity = turn.reshape(3, 3).T @ data.qvel[:3]
        np.testing.assert_allclose(columns(env, "base_velocity", observation)[i], velocity, atol=1e-5)
        height = data.qpos[2] - robot.stance_height
        np.testing.assert_allclose(columns(env, "base_height", observation)[i], height, atol=1e-6)
        friction = simulation.model_field("geom_friction")[i, model.geom("ground").id, 0]
        np.testing.assert_allclose(columns(env, "friction", observation)[i], friction, rtol=1e-6)
        mass = simulation.model_field("body_mass")[i].sum() - model.body_mass.sum()
        np.testing.assert_allclose(columns(env, "added_mass", observation)[i], mass, atol=1e-6)
        latency = simulation.model_field("actuator_delay")[i].mean()
        np.testing.assert_allclose(columns(env, "action_latency", observation)[i], latency, atol=1e-7)
        age = env.task._randomizer.sensors.latency[i]
        np.testing.assert_allclose(columns(env, "observation_latency", observation)[i], age, atol=1e-7)
    contact = simulation.readings.foot_force > env.task.context.contact_threshold
    np.testing.assert_array_equal(columns(env, "foot_contact", observation), contact)
    soles = simulation.readings.foot_position[..., 2] - robot.foot_radius
    np.testing.assert_allclose(columns(env, "foot_height", observation), soles, atol=1e-6)
    for name in ("friction", "added_mass", "action_latency", "observation_latency"):
        assert np.ptp(columns(env, name, observation)) > 1e-4, name


def forward_and_yaw(env):
    """Velocity (N, 2) along and about the body's axes, from MuJoCo's data."""
    found = []
    for i in range(env.num_envs):
        data, turn = env.env.env_data(i), np.zeros(9)
        mujoco.mju_quat2Mat(turn, data.qpos[3:7])
        found.append((turn.reshape(3, 3)[:, 0] @ data.qvel[:3], data.qvel[5]))
    return np.array(found)


def env_space(env, observation):
    """The space of a whole batch."""
    from gymnasium.vector.utils import batch_space

    assert observation.dtype == np.float32
    return batch_space(env.observation_space, len(observation))


def test_without_randomization_the_constants_are_those_of_the_model():
    env = make_sb3_vec_env(3, seed=0, privileged=True)
    observation = env.reset()
    np.testing.assert_allclose(columns(env, "friction", observation), 0.8, rtol=1e-6)
    for name in ("added_mass", "observation_latency"):
        np.testing.assert_array_equal(columns(env, name, observation), 0.0)
    delay = env.task.config.motor.delay
    np.testing.assert_allclose(columns(env, "action_latency", observation), delay, atol=1e-9)


TIMED = {"privileged": True, "config": {"termination": {"max_tilt": 3.1}, "randomization": "hard"}}
"""Episodes that a time limit ends."""


def test_time_limit_leaves_the_whole_observation_that_would_have_followed():
    """Next to the same envs without the limit."""
    env, unlimited = (make_sb3_vec_env(4, seed=0, max_episode_steps=steps, **TIMED) for steps in (15, 1000))
    env.reset(), unlimited.reset()
    for action in np.random.default_rng(0).uniform(-1, 1, (15, 4, 8)).astype(np.float32):
        (observation, _, done, infos), (following, *_) = env.step(action), unlimited.step(action)
    assert done.all()
    for env_id, info in enumerate(infos):
        assert info["TimeLimit.truncated"]
        np.testing.assert_array_equal(info["terminal_observation"], following[env_id])
    assert (observation[:, WIDTH:] != following[:, WIDTH:]).any(axis=1).all(), "another state than the reset's"


def test_ppo_bootstraps_a_time_limit_by_the_critics_value_of_the_privileged_readings():
    """The last reward of an episode gets the discounted value of the state that would have followed."""
    seen = {}

    class Rollout(Scheduled):
        def _on_training_start(self):
            super()._on_training_start()
            actions, self.following = self.model.env.step_async, []
            unlimited.reset()

            def step_async(action):
                actions(action)
                self.following.append(unlimited.step(action)[:2])

            self.model.env.step_async = step_async

        def _on_rollout_end(self):
            super()._on_rollout_end()
            seen["rewards"] = self.model.rollout_buffer.rewards.copy()
            with torch.no_grad():
                last = torch.as_tensor(self.following[-1][0])
                without = torch.cat([last[:, :WIDTH], torch.zeros_like(last[:, WIDTH:])], dim=1)
                seen["value"], seen["blind"] = (self.model.policy.predict_values(x)[:, 0] for x in (last, without))
            seen["own"] = np.array([reward for _, reward in self.following])

    config = TrainConfig(num_envs=4, n_steps=15, batch_size=60, n_epochs=1, gamma=0.9, log_std_init=0.0)
    env, unlimited = (make_sb3_vec_env(4, seed=0, max_episode_steps=steps, **TIMED) for steps in (15, 1000))
    model = make_model(config, env)
    perturb(model, 0.1)
    model.learn(60, Rollout())
    np.testing.assert_array_equal(seen["rewards"][:-1], seen["own"][:-1])
    np.testing.assert_allclose(seen["rewards"][-1], seen["own"][-1] + 0.9 * seen["value"].numpy(), rtol=1e-5)
    assert (seen["value"] - seen["blind"]).abs().min() > 1e-3, "the privileged readings matter"


def model_of(**changes):
    torch.manual_seed(0)
    config = TrainConfig(num_envs=2, n_steps=8, batch_size=16, **changes)
    env = make_sb3_vec_env(2, seed=0, privileged=config.asymmetric_critic)
    model = make_model(config, env)
    perturb(model, 0.1)
    return model, env


@pytest.mark.parametrize("symmetric", [True, False])
def test_gradient_of_the_actor_by_privileged_readings_is_zero_and_that_of_the_critic_is_not(symmetric):
    model, env = model_of(asymmetric_critic=True, symmetric=symmetric)
    seen = torch.rand(20, env.observation_space.shape[0], requires_grad=True)
    model.policy.get_distribution(seen).distribution.mean.square().sum().backward()
    assert (seen.grad[:, WIDTH:] == 0.0).all()
    assert (seen.grad[:, :WIDTH] != 0.0).any(dim=0).all()
    seen.grad = None
    model.policy.predict_values(seen).sum().backward()
    assert (seen.grad != 0.0).any(dim=0).all(), "every column, privileged ones included"
    other = seen.detach().clone()
    other[:, WIDTH:] = torch.rand_like(other[:, WIDTH:])
    with torch.no_grad():
        assert torch.equal(model.policy._predict(seen, True), model.policy._predict(other, True))


def test_symmetric_policy_has_a_symmetric_asymmetric_critic():
    model, env = model_of(asymmetric_critic=True)
    own, more = MirrorMap.of(env.task.control.layout), MirrorMap.of(env.privileged.layout)
    rng = np.random.default_rng(0)
    seen = rng.uniform(-1, 1, (30, env.observation_space.shape[0])).astype(np.float32)
    other = np.concatenate([own.observation(seen[:, :WIDTH]), more.observation(seen[:, WIDTH:])], axis=1)
    assert (other[:, WIDTH:] != seen[:, WIDTH:]).any()
    with torch.no_grad():
        one, two = (model.policy.predict_values(torch.as_tensor(side)).numpy() for side in (seen, other))
        mean, mirrored = (
            model.policy.get_distribution(torch.as_tensor(side)).distribution.mean.numpy() for side in (seen, other)
        )
    np.testing.assert_allclose(one, two, atol=1e-5)
    np.testing.assert_allclose(mirrored, own.action(mean), atol=1e-5)
    half = np.concatenate([own.observation(seen[:, :WIDTH]), seen[:, WIDTH:]], axis=1)
    with torch.no_grad():
        assert np.abs(model.policy.predict_values(torch.as_tensor(half)).numpy() - one).max() > 1e-3


def test_exported_policy_takes_the_observation_alone():
    model, env = model_of(asymmetric_critic=True)
    policy = Policy.from_sb3(model, {})
    assert policy.weights[0].shape[0] == WIDTH
    seen = np.random.default_rng(0).uniform(-1, 1, (10, env.observation_space.shape[0])).astype(np.float32)
    with torch.no_grad():
        mean = model.policy.get_distribution(torch.as_tensor(seen)).distribution.mean.clamp(-1, 1).numpy()
    np.testing.assert_allclose(policy.predict(seen[:, :WIDTH]), mean, atol=1e-5)


def test_training_saves_and_resumes_the_asymmetric_critic(tmp_path):
    config = TrainConfig(timesteps=2 * STEPS, asymmetric_critic=True, checkpoint_seconds=1e6, **SMALL)
    run = learn(tmp_path, config)
    assert assert_complete(run).weights[0].shape[0] == WIDTH
    assert json.loads((run / CONFIG_FILE).read_text())["training"]["asymmetric_critic"] is True
    parent = Parent.load(run)
    again = learn(tmp_path, parent.resumed({"timesteps": STEPS}), parent)
    assert load_policy(again).card["timesteps"] == 3 * STEPS


OWN = """
from quadruped_env.task import privileged


@privileged(unit="N", mirror="feet", scale=0.05, bound=2.0)
def foot_force(state):
    "Normal force on each foot."
    return state.context.readings.foot_force


@privileged(unit="1", mirror=(1.0,))
def friction(state):
    "In place of the built-in one."
    return 0.0 * state.context.base_height[:, None] + 0.25
"""


def test_file_of_terms_adds_and_replaces_privileged_readings(tmp_path):
    (tmp_path / "own.py").write_text(OWN)
    names = [field.name for field in load_task_file(tmp_path / "own.py").privileged]
    assert names == [*NAMES, "foot_force"]
    env = make_sb3_vec_env(3, seed=0, privileged=True, task_file=tmp_path / "own.py")
    env.reset()
    for _ in range(10):
        observation, *_ = env.step(np.zeros((3, 8), np.float32))
    np.testing.assert_allclose(columns(env, "friction", observation), 0.25)
    force = np.clip(env.task.simulation.readings.foot_force, 0.0, 40.0)
    np.testing.assert_allclose(columns(env, "foot_force", observation), force, rtol=1e-5)
    assert (force > 1.0).any()
    # The policy's observation, and what a robot must measure, do not change.
    layout = env.task.control.layout
    assert layout.history * layout.width == WIDTH


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("    return state.context.readings.foot_force[:, 0]", r"privileged reading foot_force must be an array of"),
        ("    return state.wind", r"privileged reading foot_force: AttributeError: .*wind"),
    ],
)
def test_bad_privileged_reading_is_named(tmp_path, line, message):
    (tmp_path / "own.py").write_text(OWN.replace("    return state.context.readings.foot_force", line))
    with pytest.raises(QuadrupedError, match=message):
        make_sb3_vec_env(2, privileged=True, task_file=tmp_path / "own.py")


def test_privileged_reading_that_is_nan_is_named(tmp_path):
    (tmp_path / "own.py").write_text(OWN.replace("+ 0.25", "+ float('nan')"))
    env = make_sb3_vec_env(2, seed=0, privileged=True, task_file=tmp_path / "own.py")
    with pytest.raises(QuadrupedError, match=r"privileged reading friction: found NaN or infinity"):
        env.reset()


def test_preset_values_are_within_the_bounds():
    """No value of the preset `hard` is clipped."""
    env = make_sb3_vec_env(1, seed=0, privileged=True)
    layout, hard = env.privileged.layout, preset_values("hard")
    for name, largest in (
        ("friction", hard["friction"][1]),
        ("action_latency", hard["action_latency"][1]),
        ("observation_latency", hard["observation_latency"][1]),
        ("added_mass", hard["payload"][1] + 0.2 * env.task.config.robot.total_mass),
    ):
        where = layout.slices[name]
        assert (largest * layout.scale[where] <= layout.high[where]).all(), name
