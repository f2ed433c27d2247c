"""Training on MuJoCo Warp with rsl-rl, on a GPU or Warp's CPU device, and its errors."""

import dataclasses
import json
import shutil

import numpy as np
import pytest
from trainings import learn, needs_warp, progress
from warp_device import DEVICE, TRAINING_DEVICE

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.policies import load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import Task, TaskConfig
from quadruped_env.training import TrainConfig
from quadruped_env.training.default_settings import with_recipe
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE, RESUME_FILE, RSL_FILE
from quadruped_env.training.train_config import GPU_DEFAULTS

torch = pytest.importorskip("torch", reason="torch is not installed: pip install -e '.[gpu]'")
pytest.importorskip("stable_baselines3", reason="Stable-Baselines3 is not installed: pip install -e '.[train]'")

TINY = {"num_envs": 4, "n_steps": 8, "batch_size": 16, "timesteps": 64, "hidden": (8,), "device": TRAINING_DEVICE}
COMMAND = (0.4, 0.0)
"""Forward velocity, m/s, and yaw rate, rad/s."""


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"device": "gpu"}, r"--device: 'gpu' is unknown; expected cpu, cuda, cuda:N or warp-cpu"),
        ({"device": "cuda:x"}, r"--device: 'cuda:x' is unknown"),
        ({"device": "cuda:1", "ranks": 2}, r"--device: found cuda:1 with --ranks 2, .*; choose --device cuda: rank i"),
        ({"device": "cuda", "num_envs": 64, "ranks": 65}, r"--ranks: found 65, more than the 64 envs"),
        ({"device": "cuda", "algo": "sac"}, r"--device: cuda trains with ppo alone; found --algo sac"),
    ],
)
def test_device_that_is_not_possible_is_an_error(settings, message):
    with pytest.raises(QuadrupedError, match=message):
        TrainConfig(**settings)


def test_gpu_has_its_own_defaults_and_typed_values_win():
    gpu, cpu, tried = (with_recipe({"device": device}, MINI_QUADRUPED, ()) for device in ("cuda:1", "cpu", "warp-cpu"))
    assert {name: gpu[name] for name in GPU_DEFAULTS} == GPU_DEFAULTS
    assert not set(GPU_DEFAULTS) & set(cpu)
    assert not set(GPU_DEFAULTS) & set(tried)
    rough = with_recipe({"device": "cuda", "recipe": "rough", "num_envs": 1024}, MINI_QUADRUPED, ())
    assert (rough["num_envs"], rough["batch_size"]) == (1024, GPU_DEFAULTS["batch_size"])


@pytest.fixture
def cpu_run(tmp_path):
    return learn(tmp_path, TrainConfig(**{**TINY, "device": "cpu"}))


def test_run_of_an_earlier_version_without_device_resumes(cpu_run, tmp_path):
    path = cpu_run / CONFIG_FILE
    document = json.loads(path.read_text())
    assert document["training"].pop("device") == "cpu"
    path.write_text(json.dumps(document))
    parent = Parent.load(cpu_run)
    assert parent.config.device == "cpu"
    resumed = learn(tmp_path, parent.resumed({"timesteps": 32}), cpu_run)
    assert load_policy(resumed).card["timesteps"] == 64 + 32


def test_run_of_the_cpu_does_not_resume_on_a_gpu(cpu_run):
    with pytest.raises(QuadrupedError, match=r"--device: found cuda; .* was trained with cpu, .*without --resume"):
        Parent.load(cpu_run).resumed({"device": "cuda"})


@needs_warp
@pytest.mark.skipif(torch.cuda.is_available(), reason="this machine has a GPU")
def test_missing_gpu_is_an_error_that_says_what_to_check(tmp_path, capsys):
    assert main(["train", "--device", "cuda", "--output", str(tmp_path / "runs")]) == 2
    assert "finds no CUDA GPU on this machine; check that nvidia-smi shows one" in capsys.readouterr().err
    assert not (tmp_path / "runs").exists()


@needs_warp
def test_run_directory_is_that_of_a_training_on_the_cpu(tmp_path):
    directory = learn(tmp_path, TrainConfig(**TINY, asymmetric_critic=True))
    policy = load_policy(directory)
    assert policy.card["timesteps"] == 64
    assert [int(row["timesteps"]) for row in progress(directory)][-1] == 64
    assert json.loads((directory / CONFIG_FILE).read_text())["training"]["device"] == TRAINING_DEVICE
    assert (directory / RSL_FILE).is_file()
    assert not (directory / RESUME_FILE).exists()
    parent = Parent.load(directory)
    with pytest.raises(QuadrupedError, match=rf"--device: found cpu; .* was trained with {TRAINING_DEVICE}"):
        parent.resumed({"device": "cpu"})
    resumed = learn(tmp_path, parent.resumed({"timesteps": 32}), directory)
    assert load_policy(resumed).card["timesteps"] == 96
    assert [int(row["timesteps"]) for row in progress(resumed)][-1] == 96


@needs_warp
def test_resume_file_that_is_damaged_is_an_error(tmp_path):
    directory = learn(tmp_path, TrainConfig(**TINY))
    copy = tmp_path / "copy"
    shutil.copytree(directory, copy)
    (copy / RSL_FILE).write_bytes(b"nothing")
    with pytest.raises(QuadrupedError, match=rf"{copy}/{RSL_FILE}: cannot be resumed .*or start a new training"):
        learn(tmp_path, Parent.load(copy).resumed({"timesteps": 32}), copy)


@needs_warp
def test_uneven_ground_is_refused_before_a_run_is_left(tmp_path):
    with pytest.raises(QuadrupedError, match=r"terrain: .*height field"):
        learn(tmp_path / "runs", TrainConfig(**TINY, task={"terrain": {"name": "rough"}}))
    assert not list((tmp_path / "runs").glob("*"))


@needs_warp
@pytest.mark.parametrize(("symmetric", "activation"), [(True, "elu"), (True, "leaky_relu"), (False, "silu")])
def test_policy_file_has_the_networks_mean_actions(symmetric, activation):
    from quadruped_env.scale.gpu.warp_env import OBSERVATION, WarpVecEnv
    from quadruped_env.scale.gpu.warp_training import WarpModel

    network = {"hidden": (16, 8), "activation": activation}
    config = TrainConfig(**{**TINY, **network}, symmetric=symmetric, asymmetric_critic=True)
    env = WarpVecEnv(TaskConfig(), 4, DEVICE, 0, True)
    model = WarpModel(config, env)
    with torch.no_grad():
        for parameter in model.ppo.actor.mlp.parameters():
            parameter.add_(0.3 * torch.randn_like(parameter))
        seen = env.get_observations()
        expected = model.ppo.actor(seen).cpu().numpy().clip(-1.0, 1.0)
        values = model.ppo.critic(seen)
    found = model.policy(env.task.config, {}).predict(seen[OBSERVATION].cpu().numpy())
    np.testing.assert_allclose(found, expected, atol=1e-5)
    assert np.abs(expected).max() > 0.05
    assert values.shape == (4, 1)


@needs_warp
def test_time_limit_adds_the_value_of_the_last_observation():
    """Rewards that the storage holds, recomputed from the critic's value after the last step and before the reset."""
    from quadruped_env.scale.gpu.warp_env import FINAL, TIME_OUTS, WarpVecEnv
    from quadruped_env.scale.gpu.warp_training import WarpModel

    config = TrainConfig(**{**TINY, "n_steps": 3, "batch_size": 12})
    env = WarpVecEnv(TaskConfig(), 4, DEVICE, 0, config.asymmetric_critic)
    env.task.max_episode_steps = 2
    env.task._shortened[:] = 0  # first episodes of random length would end apart
    model = WarpModel(config, env)
    ppo, observations = model.ppo, env.get_observations()
    with torch.no_grad():
        for parameter in ppo.critic.parameters():
            parameter.add_(0.1 * torch.randn_like(parameter))
        for step in range(3):
            observations, rewards, done, extras = env.step(ppo.act(observations))
            ppo.process_env_step(observations, rewards, done, extras)
            limit = step == 1
            assert extras[TIME_OUTS].tolist() == done.tolist() == [limit] * 4
            value = config.gamma * ppo.critic(extras[FINAL]).squeeze(-1) if limit else torch.zeros_like(rewards)
            torch.testing.assert_close(ppo.storage.rewards[step, :, 0], rewards + value)
            if limit:
                # The next episodes begin elsewhere, with other values.
                assert (ppo.critic(observations) - ppo.critic(extras[FINAL])).abs().max() > 1e-3


def forward_velocity(task, policy):
    """Mean forward velocity over the envs and the last 4 of 6 s, m/s."""
    env_ids = np.arange(task.num_envs, like=task.simulation.sensordata)
    task.reset(env_ids, list(range(10_000, 10_000 + task.num_envs)), COMMAND)
    observation, velocities = task.observe(), []
    for step in range(300):
        observation = task.step(policy.predict(np.array(observation.tolist()))).observation
        assert not task.finished.any()
        if step >= 100:
            velocities.append(float(task.simulation.readings.linear_velocity_b[:, 0].mean()))
    return np.mean(velocities)


@needs_warp
def test_policy_trained_on_warp_walks_in_mujoco_as_in_warp(tmp_path):
    from quadruped_env.scale.gpu.warp_simulation import WarpSimulation

    settings = with_recipe(
        {"device": TRAINING_DEVICE, "timesteps": 81_920, "checkpoint_seconds": 1e9}, MINI_QUADRUPED, ()
    )
    directory = learn(tmp_path, TrainConfig(**settings))
    policy = load_policy(directory)
    config = dataclasses.replace(policy.config, randomization=TaskConfig().randomization)
    model = config.compiled_model()
    there = forward_velocity(Task(WarpSimulation(model, 16, MINI_QUADRUPED, DEVICE), config), policy)
    here = forward_velocity(Task(BatchSimulation(model, 16), config), policy)
    print(f"forward velocity: {there:.3f} m/s in Warp, {here:.3f} m/s in mujoco.batch; commanded {COMMAND[0]} m/s")
    assert here > 0.3
    assert abs(here - there) < 0.03
