"""Training: the files of a run, repeated, budgeted and stopped runs."""

import dataclasses
import json
import re
import signal
import socket
import subprocess
from pathlib import Path

import numpy as np
import pytest
from trainings import ENDLESS, TINY, assert_complete, command, progress, running, scalars, train
from waiting import output_of

import quadruped_env
from quadruped_env.envs import ENV_ID
from quadruped_env.policies import load_policy
from quadruped_env.policies.policy_data import TENSORS_FILE
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig
from quadruped_env.training import TrainConfig
from quadruped_env.training.recipes import task_values
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_COLUMNS


@pytest.fixture(scope="module")
def tiny_run(tmp_path_factory):
    """A finished tiny training: its directory, its seed 0."""
    return train(tmp_path_factory.mktemp("runs"), *TINY)


def test_a_run_is_complete(tiny_run):
    policy = assert_complete(tiny_run)
    assert policy.action_mode == TrainConfig().action_mode
    assert policy.card["timesteps"] == 2048
    assert policy.card["seed"] == 0
    assert tiny_run.name.endswith("-ppo")
    assert (tiny_run.parent / "latest").is_symlink()
    assert (tiny_run.parent / "latest").readlink() == Path(tiny_run.name), "relative, so that runs/ can be moved"


def test_run_records_its_settings_and_versions(tiny_run):
    document = json.loads((tiny_run / CONFIG_FILE).read_text())
    training = dict(document["training"])
    assert training["hidden"] == list(TrainConfig().hidden)
    recipe = task_values("flat", MINI_QUADRUPED)
    sizes = {"timesteps": 2048, "num_envs": 16, "n_steps": 16, "batch_size": 64}
    expected = TrainConfig(**sizes, task=recipe)
    assert TrainConfig(**{**training, "hidden": tuple(training["hidden"])}) == expected
    task = TaskConfig.from_dict(document["task"])
    assert dataclasses.replace(task, action=TaskConfig().action) == TaskConfig.from_dict(recipe)
    assert task.action.mode == training["action_mode"]
    assert document["versions"]["mini-quadruped"] == quadruped_env.__version__
    for library in ("python", "mujoco", "gymnasium", "numpy", "stable-baselines3", "torch"):
        assert re.match(r"\d+\.\d+", document["versions"][library]), library
    assert re.fullmatch(r"[0-9a-f]{12,40}(-dirty)?|unknown", document["git_commit"])
    assert "--num-envs 16" in document["command"]
    assert "cores" in document["machine"]
    card = load_policy(tiny_run).card
    for name in ("versions", "git_commit", "command", "machine"):
        assert card[name] == document[name], name


def test_progress_is_logged_as_csv_and_for_tensorboard_with_every_reward_term(tiny_run):
    rows = progress(tiny_run)
    weights = TaskConfig().reward.weights
    assert tuple(rows[0]) == (*PROGRESS_COLUMNS, *(f"reward_{name}" for name in weights))
    assert int(rows[-1]["timesteps"]) == 2048
    for row in rows:
        values = {name: float(value) for name, value in row.items()}
        assert np.isfinite(list(values.values())).all()
        assert values["forward_velocity_error"] > 0
        assert values["fall_rate"] >= 0
        # Per second, and the return for an episode of 20 s.
        assert 20.0 * sum(values[f"reward_{name}"] for name in weights) == pytest.approx(values["return"])
    shown = scalars(tiny_run)
    for name in weights:
        assert shown[f"reward_per_second/{name}"] == len(rows), name
    for name in PROGRESS_COLUMNS[1:]:
        assert shown[f"progress/{name}"] == len(rows), name


def test_policy_of_a_run_acts_in_the_environment(tiny_run):
    import gymnasium

    policy = load_policy(tiny_run)
    env = gymnasium.make(ENV_ID, action_mode=policy.action_mode, config=policy.config)
    observation, _ = env.reset(seed=0)
    for _ in range(10):
        observation, *_ = env.step(policy.predict(observation))
    assert observation in env.observation_space


@pytest.mark.slow
def test_the_same_seed_gives_the_same_policy_bit_for_bit(tiny_run, tmp_path):
    again, other = train(tmp_path, *TINY), train(tmp_path, *TINY, "--seed", 1)
    assert (again / TENSORS_FILE).read_bytes() == (tiny_run / TENSORS_FILE).read_bytes()
    assert (other / TENSORS_FILE).read_bytes() != (tiny_run / TENSORS_FILE).read_bytes()
    assert len(list(tmp_path.glob("*-ppo*"))) == 2, "a directory each, whenever they start"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("number", "name", "status"),
    [(signal.SIGINT, "SIGINT", 130), (signal.SIGTERM, "SIGTERM", 143), (signal.SIGHUP, "SIGTERM", 143)],
)
def test_a_signal_ends_a_training_which_saves_and_says_so(tmp_path, number, name, status):
    with running(tmp_path, *ENDLESS) as process:
        process.send_signal(number)
        output, errors = output_of(process)
    assert process.returncode == status, errors
    assert f"stopped by {name}, and saved what was learned" in output
    assert "Traceback" not in errors
    directory = (tmp_path / "latest").resolve()
    policy = assert_complete(directory)
    assert policy.card["interrupted"] == name
    assert policy.card["timesteps"] == int(progress(directory)[-1]["timesteps"]) > 0


@pytest.mark.slow
def test_a_training_whose_output_nobody_reads_goes_on_to_its_end(tmp_path):
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen(command(tmp_path, *TINY), **pipes) as process:
        process.stdout.close()
        errors = process.stderr.read()
    assert process.returncode == 0, errors
    card = load_policy((tmp_path / "latest").resolve()).card
    assert (card["timesteps"], card["interrupted"]) == (2048, None)
    assert card["learning"], "also what comes after the training"


@pytest.mark.slow
def test_a_run_names_neither_directories_nor_the_machine(tmp_path):
    directory = train(tmp_path / "secret place", *TINY)
    card = load_policy(directory).card
    assert card["command"].startswith("mini-quadruped train -o 'secret place' --timesteps")
    assert "secret" not in (directory / CONFIG_FILE).read_text().replace("-o 'secret place'", "")
    (events,) = (directory / "tensorboard").iterdir()
    assert ".training." in events.name
    assert socket.gethostname() not in events.name.split(".")
