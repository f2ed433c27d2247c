"""`mini-quadruped import-policy`: policies of zips of Stable-Baselines3, and of ONNX files."""

import base64
import json
import os
import pickle
import re
import zipfile

import gymnasium
import numpy as np
import pytest
import stable_baselines3
from stable_baselines3 import PPO, SAC
from stable_baselines3.common.vec_env import VecNormalize

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.policies import load_policy
from quadruped_env.task import TaskConfig
from quadruped_env.training.policy_import import import_policy


def small(kind, env, **arguments):
    """A model whose network has one small layer."""
    return kind("MlpPolicy", env, policy_kwargs={"net_arch": [8]}, device="cpu", **arguments)


def seen(env):
    return np.random.default_rng(0).uniform(-1.0, 1.0, (50, env.observation_space.shape[0])).astype(np.float32)


class Harmful:
    """Creates a folder when it is unpickled."""

    def __init__(self, path):
        self.path = path

    def __reduce__(self):
        return os.mkdir, (str(self.path),)


@pytest.mark.parametrize("name", ["PPO", "A2C", "SAC", "TD3", "DDPG", "TRPO", "TQC", "CrossQ"])
def test_zip_of_any_algorithm_becomes_a_run(name, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    kind = getattr(stable_baselines3, name, None) or getattr(pytest.importorskip("sb3_contrib"), name)
    env = make_sb3_vec_env(2, seed=0, action_mode="residual")
    model = small(kind, env, **({"buffer_size": 9} if hasattr(kind, "load_replay_buffer") else {}))
    model.save("mine")
    assert main(["import-policy", "mine.zip", "--action-mode", "residual"]) == 0
    printed = capsys.readouterr().out
    assert "unpickling mine.zip: whatever code is in there is executed" in printed
    assert "action mode residual (--action-mode), actions of 0.4 rad, without VecNormalize" in printed
    policy = load_policy("runs/mine")
    assert policy.action_mode == "residual"
    assert policy.card["imported_from"]["name"] == "mine.zip"
    assert policy.card["algo"] == {"DDPG": "td3"}.get(name, name.lower())
    expected, _ = model.predict(seen(env), deterministic=True)
    np.testing.assert_allclose(policy.predict(seen(env)), expected, atol=1e-5)


def test_statistics_of_a_vecnormalize_become_a_part_of_the_policy(tmp_path, capsys):
    env = VecNormalize(make_sb3_vec_env(2, seed=0), clip_obs=1e6)
    model = small(PPO, env, n_steps=8, batch_size=16, n_epochs=1)
    model.learn(16)
    model.save(tmp_path / "mine")
    env.save(tmp_path / "statistics.pkl")
    command = ["import-policy", str(tmp_path / "mine.zip"), "-o", str(tmp_path / "run")]
    assert main(command) == 2
    assert "was trained in a VecNormalize" in (error := capsys.readouterr().err)
    assert "name their file (vecnormalize)" in error
    assert not (tmp_path / "run").exists()
    assert main([*command, "--vecnormalize", str(tmp_path / "statistics.pkl")]) == 0
    raw = np.random.default_rng(0).normal(env.obs_rms.mean, np.sqrt(env.obs_rms.var), (50, 102)).astype(np.float32)
    expected, _ = model.predict(env.normalize_obs(raw), deterministic=True)
    np.testing.assert_allclose(load_policy(tmp_path / "run").predict(raw), expected, atol=1e-3)
    assert main(command) == 2
    assert "exists already" in capsys.readouterr().err


def test_task_of_the_training_is_an_option(tmp_path):
    env = make_sb3_vec_env(1, config={"observation_history": 1})
    small(SAC, env, buffer_size=9).save(tmp_path / "mine")
    command = ["import-policy", str(tmp_path / "mine.zip"), "-o", str(tmp_path / "run")]
    assert main(command) == 2
    assert main([*command, "--task", '{"observation_history": 1}']) == 0
    assert load_policy(tmp_path / "run").config == env.task.config


def test_model_of_another_env_is_refused_with_the_columns_of_this_one(tmp_path, capsys):
    PPO("MlpPolicy", gymnasium.make("Pendulum-v1"), device="cpu").save(tmp_path / "mine")
    assert main(["import-policy", str(tmp_path / "mine.zip"), "-o", str(tmp_path / "run")]) == 2
    error = capsys.readouterr().err
    assert re.search(r"observations have the shape \(3,\).* \(102,\): 3 x \(projected_gravity, .*--task", error)


def test_only_the_import_unpickles(tmp_path, capsys):
    with zipfile.ZipFile(tmp_path / "mine.zip", "w") as archive:
        text = base64.b64encode(pickle.dumps(Harmful(tmp_path / "executed"))).decode()
        archive.writestr("data", json.dumps({"n_epochs": 1, "seed": {":type:": "x", ":serialized:": text}}))
        archive.writestr("policy.pth", b"")
    with pytest.raises(QuadrupedError, match=r"mine.zip: this is a model of Stable-Baselines3; '.*import-policy"):
        load_policy(tmp_path / "mine.zip")
    assert not (tmp_path / "executed").exists()
    assert main(["import-policy", str(tmp_path / "mine.zip"), "-o", str(tmp_path / "run")]) == 2
    assert "mine.zip: cannot be loaded" in capsys.readouterr().err
    assert (tmp_path / "executed").exists()  # as the line on the terminal says


@pytest.mark.parametrize("content", [b"PK\x03\x04nothing", b"text"])
def test_file_that_is_no_zip_of_a_model_is_refused(content, tmp_path):
    (tmp_path / "mine.zip").write_bytes(content)
    with pytest.raises(QuadrupedError, match=r"mine.zip: .*name the zip that model.save of Stable-Baselines3 wrote"):
        import_policy(tmp_path / "mine.zip", TaskConfig())
    with pytest.raises(QuadrupedError, match=r"nowhere: there is no such file"):
        import_policy(tmp_path / "nowhere", TaskConfig())
