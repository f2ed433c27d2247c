"""Training: the files of a run, repeated, budgeted and stopped runs."""

import contextlib
import dataclasses
import io
import json
import re
import signal
import socket
import subprocess
from pathlib import Path

import numpy as np
import pytest
from trainings import ENDLESS, TINY, assert_complete, command, progress, running, train
from waiting import output_of

import quadruped_env
from quadruped_env.api import Evaluation
from quadruped_env.cli.main import main
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.learning_gain import GAIN_HEADER, reward_in_words
from quadruped_env.policies import load_policy
from quadruped_env.policies.policy_data import TENSORS_FILE
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig
from quadruped_env.training import TrainConfig
from quadruped_env.training.recipes import with_recipe
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_COLUMNS


@pytest.fixture(scope="module")
def tiny_run(tmp_path_factory):
    """A finished tiny training by the program, in this process: its directory; and what the program printed."""
    runs = tmp_path_factory.mktemp("runs")
    with contextlib.redirect_stdout(output := io.StringIO()):
        assert main(["train", "-o", str(runs), *TINY]) == 0
    return (runs / "latest").resolve(), output.getvalue()


@pytest.fixture(scope="module")
def directory(tiny_run):
    return tiny_run[0]


def test_a_run_is_complete(directory):
    policy = assert_complete(directory)
    assert policy.action_mode == TrainConfig().action_mode
    assert policy.card["timesteps"] == 2048
    assert policy.card["seed"] == 0
    assert directory.name.endswith("-ppo")
    assert (directory.parent / "latest").readlink() == Path(directory.name), "relative, so that runs/ can be moved"


def test_training_ends_with_what_it_added_over_the_zero_action_and_keeps_it_on_the_card(tiny_run):
    directory, output = tiny_run
    learning, lines = load_policy(directory).card["learning"], output.splitlines()
    assert learning["episodes"] == 2, "as many steps are measured as were trained, and two episodes at least"
    assert f"In its own task, 2 episodes of 20 s, it {learning['verdict']}" in lines
    first = next(i for i, line in enumerate(lines) if line.split() == " ".join(GAIN_HEADER).split()) + 1
    assert lines[first].startswith("own task  "), "motions take more steps than this training had"
    assert lines[first + 1] == reward_in_words(learning)
    assert learning["terms"] == []


def test_closing_table_has_a_row_for_a_changed_weight(tmp_path):
    task = '{"reward": {"weights": {"landing": -5}}}'
    with contextlib.redirect_stdout(output := io.StringIO()):
        assert main(["train", "-o", str(tmp_path), *TINY, "--task", task]) == 0
    (term,) = load_policy(tmp_path / "latest").card["learning"]["terms"]
    assert (term["name"], term["weight"]) == ("landing", -5.0)
    assert term["first"] > 0.0, "from progress.csv"
    (row,) = (line for line in output.getvalue().splitlines() if line.startswith("landing (m^2/s^3)"))
    assert row.split()[2:4] == ["-5", f"{term['first']:.3g}"]
    evaluation = Evaluation.measure(find_policy(str(tmp_path / "latest")), "", 1, 2.0, None, "none")
    assert [one.first for one in evaluation.gain.terms] == [term["first"]]


def test_run_records_its_settings_and_versions(directory):
    document = json.loads((directory / CONFIG_FILE).read_text())
    training = dict(document["training"])
    assert training["hidden"] == list(TrainConfig().hidden)
    expected = with_recipe({"timesteps": 2048, "num_envs": 16, "n_steps": 16, "batch_size": 64}, MINI_QUADRUPED)
    assert TrainConfig(**{**training, "hidden": tuple(training["hidden"])}) == expected
    task = TaskConfig.from_dict(document["task"])
    assert dataclasses.replace(task, action=TaskConfig().action) == TaskConfig.from_dict(expected.task)
    assert task.action.mode == training["action_mode"]
    assert document["versions"]["mini-quadruped"] == quadruped_env.__version__
    for library in ("python", "mujoco", "gymnasium", "numpy", "stable-baselines3", "torch"):
        assert re.match(r"\d+\.\d+", document["versions"][library]), library
    assert re.fullmatch(r"[0-9a-f]{12,40}(-dirty)?|unknown", document["git_commit"])
    assert "--num-envs 16" in document["command"]
    assert "cores" in document["machine"]
    card = load_policy(directory).card
    for name in ("versions", "git_commit", "command", "machine"):
        assert card[name] == document[name], name


def test_progress_is_logged_as_csv_with_every_reward_term(directory):
    rows = progress(directory)
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


@pytest.mark.slow
def test_the_same_seed_gives_the_same_policy_bit_for_bit(directory, tmp_path):
    again, other = train(tmp_path, *TINY), train(tmp_path, *TINY, "--seed", 1)
    assert (again / TENSORS_FILE).read_bytes() == (directory / TENSORS_FILE).read_bytes()
    assert (other / TENSORS_FILE).read_bytes() != (directory / TENSORS_FILE).read_bytes()
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
def test_a_training_whose_output_nobody_reads_is_saved(tmp_path):
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen(command(tmp_path, *TINY), **pipes) as process:
        process.stdout.close()
        errors = process.stderr.read()
    assert process.returncode == 141, errors
    card = load_policy((tmp_path / "latest").resolve()).card
    assert (card["timesteps"], card["interrupted"]) == (2048, None)


@pytest.mark.slow
def test_a_run_names_neither_directories_nor_the_machine(tmp_path):
    directory = train(tmp_path / "secret place", *TINY)
    card = load_policy(directory).card
    assert card["command"].startswith("mini-quadruped train -o 'secret place' --timesteps")
    assert "secret" not in (directory / CONFIG_FILE).read_text().replace("-o 'secret place'", "")
    (events,) = (directory / "tensorboard").iterdir()
    assert ".training." in events.name
    assert socket.gethostname() not in events.name.split(".")
