"""Training: what a run leaves, that it can be repeated, stopped and resumed, and that bad arguments are refused."""

import contextlib
import csv
import dataclasses
import json
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import quadruped_env
from quadruped_env import QuadrupedError
from quadruped_env.envs import ENV_ID
from quadruped_env.policies import load_policy
from quadruped_env.policies.policy import CARD_FILE, TENSORS_FILE
from quadruped_env.task import TaskConfig
from quadruped_env.training import TrainConfig
from quadruped_env.training.run import (
    CONFIG_FILE,
    PROGRESS_COLUMNS,
    PROGRESS_FILE,
    RESUME_FILE,
    Run,
    resumed_config,
)

SCRIPT = Path(__file__).parents[1] / "train" / "ppo.py"
TINY = ("--timesteps", "2048", "--num-envs", "16", "--n-steps", "16", "--batch-size", "64")
ENDLESS = ("--timesteps", "1000000000", *TINY[2:])
RUN_FILES = {CONFIG_FILE, PROGRESS_FILE, CARD_FILE, TENSORS_FILE, RESUME_FILE, "tensorboard"}


def command(runs, *arguments):
    return [sys.executable, str(SCRIPT), "--runs", str(runs), *map(str, arguments)]


def train(runs, *arguments):
    """Run the program to its end; the run directory."""
    done = subprocess.run(command(runs, *arguments), capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stderr
    return (runs / "latest").resolve()


def progress(directory):
    with (directory / PROGRESS_FILE).open() as file:
        return list(csv.DictReader(file))


def scalars(directory):
    """Names of the scalars that TensorBoard shows -> their number of points."""
    from tensorboard.backend.event_processing.event_accumulator import EventAccumulator

    events = EventAccumulator(str(directory / "tensorboard"))
    events.Reload()
    return {tag: len(events.Scalars(tag)) for tag in events.Tags()["scalars"]}


def assert_complete(directory):
    assert {path.name for path in directory.iterdir()} >= RUN_FILES
    policy = load_policy(directory)
    resumed_config(directory, TrainConfig())
    assert progress(directory)
    assert policy.predict(np.zeros(policy.weights[0].shape[0])).shape == (8,)
    return policy


def assert_refused(tmp_path, arguments, message):
    """One clear line, status 2, and no run begun."""
    done = subprocess.run(command(tmp_path / "runs", *arguments), capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert re.search(message, done.stderr), done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""
    assert not (tmp_path / "runs").exists(), "no run was begun"


@contextlib.contextmanager
def running(runs, *arguments):
    """The program while it trains, from its second row of progress on."""
    process = subprocess.Popen(command(runs, *arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        wait_until(lambda: (runs / "latest" / PROGRESS_FILE).exists() and len(progress(runs / "latest")) >= 2, process)
        yield process
    finally:
        process.kill()
        process.communicate()


def wait_until(condition, process, seconds=60.0):
    end = time.monotonic() + seconds
    while not condition():
        assert process.poll() is None, process.communicate()[1]
        assert time.monotonic() < end, "waited too long"
        time.sleep(0.05)


@pytest.fixture(scope="module")
def tiny_run(tmp_path_factory):
    """A finished tiny training: its directory, its seed 0."""
    return train(tmp_path_factory.mktemp("runs"), *TINY)


# --- what a run leaves ---


def test_a_run_is_complete(tiny_run):
    policy = assert_complete(tiny_run)
    assert policy.action_mode == TrainConfig().action_mode
    assert policy.card["timesteps"] == 2048
    assert policy.card["seed"] == 0
    assert tiny_run.name.endswith("-ppo")
    assert (tiny_run.parent / "latest").is_symlink()
    assert (tiny_run.parent / "latest").readlink() == Path(tiny_run.name), "relative, so that runs/ can be moved"


def test_a_run_records_what_it_was_asked_for_and_with_what(tiny_run):
    document = json.loads((tiny_run / CONFIG_FILE).read_text())
    training = dict(document["training"])
    assert training["hidden"] == list(TrainConfig().hidden)
    expected = TrainConfig(timesteps=2048, num_envs=16, n_steps=16, batch_size=64)
    assert TrainConfig(**{**training, "hidden": tuple(training["hidden"])}) == expected
    task = TaskConfig.from_dict(document["task"])
    assert dataclasses.replace(task, action=TaskConfig().action) == TaskConfig()
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
    assert tuple(rows[0]) == PROGRESS_COLUMNS
    assert int(rows[-1]["timesteps"]) == 2048
    for row in rows:
        values = {name: float(value) for name, value in row.items()}
        assert np.isfinite(list(values.values())).all()
        assert values["forward_velocity_error"] > 0
        assert values["fall_rate"] >= 0
    shown = scalars(tiny_run)
    for name in TaskConfig().reward.weights:
        assert shown[f"reward_per_second/{name}"] == len(rows), name
    for name in PROGRESS_COLUMNS[1:]:
        assert shown[f"progress/{name}"] == len(rows), name


def test_help_shows_every_field_with_its_meaning_and_default():
    done = subprocess.run(command("runs", "--help"), capture_output=True, text=True, check=True)
    text = " ".join(done.stdout.partition("options:")[2].split())
    described = dict(re.findall(r"--([a-z-]+)(?:, --no-[a-z-]+)? (.*?)(?= --[a-z-]+[ ,]|$)", text))
    for field in dataclasses.fields(TrainConfig):
        option = described[field.name.replace("_", "-")]
        default = {} if field.default is dataclasses.MISSING else field.default
        assert option.endswith(f"(default: {default})"), field.name
        assert len(option) > len(f"(default: {default})") + 20, field.name
    assert {"runs", "resume"} < set(described)


def test_a_run_policy_walks_into_the_environment_again(tiny_run):
    import gymnasium

    policy = load_policy(tiny_run)
    env = gymnasium.make(ENV_ID, action_mode=policy.action_mode, config=policy.config)
    observation, _ = env.reset(seed=0)
    for _ in range(10):
        observation, *_ = env.step(policy.predict(observation))
    assert observation in env.observation_space


# --- repeated, budgeted ---


@pytest.mark.slow
def test_the_same_seed_gives_the_same_policy_bit_for_bit(tiny_run, tmp_path):
    again, other = train(tmp_path, *TINY), train(tmp_path, *TINY, "--seed", 1)
    assert (again / TENSORS_FILE).read_bytes() == (tiny_run / TENSORS_FILE).read_bytes()
    assert (other / TENSORS_FILE).read_bytes() != (tiny_run / TENSORS_FILE).read_bytes()
    assert len(list(tmp_path.glob("*-ppo*"))) == 2, "a directory each, whenever they start"


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["position", "residual"])
def test_options_reach_the_policy(tmp_path, mode):
    directory = train(
        tmp_path, *TINY, "--action-mode", mode, "--hidden", 24, 20, 16, "--activation", "tanh", "--no-symmetric",
        "--name", "try",
        "--task", json.dumps({"decimation": 5, "randomization": {"push_velocity": 0.3}}),
    )  # fmt: skip
    policy = assert_complete(directory)
    assert directory.name.endswith("-try")
    assert policy.action_mode == mode
    assert policy.activation == "tanh"
    assert [weight.shape[1] for weight in policy.weights] == [24, 20, 16, 8]
    assert policy.config.decimation == 5
    assert policy.config.randomization.push_velocity == 0.3


@pytest.mark.slow
def test_a_budget_in_seconds_is_kept(tmp_path):
    directory = train(tmp_path, *TINY, "--seconds", 2)
    card = assert_complete(directory).card
    assert 2.0 <= card["seconds"] < 3.0
    assert card["timesteps"] > 2048, "not the budget in steps"


# --- stopped, resumed ---


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_a_training_which_saves_and_exits_cleanly(tmp_path, number):
    with running(tmp_path, *ENDLESS) as process:
        process.send_signal(number)
        output, errors = process.communicate(timeout=60)
    assert process.returncode == 0, errors
    assert "stopped, and saved what was learned" in output
    assert "Traceback" not in errors
    directory = (tmp_path / "latest").resolve()
    policy = assert_complete(directory)
    assert policy.card["timesteps"] == int(progress(directory)[-1]["timesteps"]) > 0


@pytest.mark.slow
def test_checkpoints_can_be_loaded_and_resumed(tmp_path):
    with running(tmp_path, *ENDLESS, "--checkpoint-seconds", "0.5") as process:
        checkpoints = (tmp_path / "latest").resolve() / "checkpoints"
        wait_until(lambda: checkpoints.exists() and len(list(checkpoints.glob(f"*/{CONFIG_FILE}"))) >= 2, process)
    # It was killed: the run has no policy of its own, only its checkpoints do.
    directory = checkpoints.parent
    with pytest.raises(QuadrupedError, match=r"missing, so the run is incomplete.*checkpoints"):
        load_policy(directory)
    first, *_, last = sorted(path for path in checkpoints.iterdir() if (path / CONFIG_FILE).exists())
    assert load_policy(first).card["timesteps"] < load_policy(last).card["timesteps"]
    resumed = train(tmp_path / "resumed", *TINY, "--resume", first)
    assert_complete(resumed)


@pytest.mark.slow
def test_resuming_goes_on_with_the_task_and_the_network_of_the_run(tmp_path):
    task = {"decimation": 5, "reward": {"weights": {"upright": -3.5}}}
    first = train(
        tmp_path, *TINY, "--action-mode", "position", "--hidden", 24, "--activation", "relu", "--task", json.dumps(task)
    )
    # So slow that what it began with is still there.
    resumed = train(tmp_path, *TINY, "--resume", first, "--learning-rate", "1e-12")
    policy, start = assert_complete(resumed), load_policy(first)
    assert resumed != first
    assert policy.config == start.config
    assert policy.activation == "relu"
    for one, other in zip(policy.weights + policy.biases, start.weights + start.biases, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-6)
    assert policy.card["timesteps"] == 2048
    learned = train(tmp_path, *TINY, "--resume", first)
    assert any(
        abs(one - other).max() > 1e-4 for one, other in zip(load_policy(learned).weights, start.weights, strict=True)
    )


# --- bad arguments ---


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--batch-size", "99999"), r"error: --batch-size: 99999 is more than the \d+ samples of an update"),
        (("--action-mode", "torque"), r"--action-mode.*'torque'.*'position', 'residual'"),
        (("--task", "{"), r"--task.*'\{'"),
        (("--resume", "nowhere"), r"error: --resume: nowhere is not a directory; name a run such as runs/latest"),
        (("--timesteps", "many"), r"--timesteps.*'many'"),
        (("--speed", "9"), r"unrecognized arguments: --speed 9"),
    ],
)
def test_bad_arguments_give_one_clear_line_and_status_2(tmp_path, arguments, message):
    assert_refused(tmp_path, arguments, message)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--task", '{"tempo": 1}'), r"error: config: unknown field 'tempo'; valid fields are"),
        (("--task", '{"decimation": 0}'), r"error: config: decimation must be 1 or more; found 0"),
        (("--task", "[1]"), r"error: config: expected a mapping of fields; found \[1\]"),
    ],
)
def test_a_bad_task_gives_one_clear_line_and_status_2(tmp_path, arguments, message):
    assert_refused(tmp_path, (*TINY, *arguments), message)


@pytest.mark.slow
def test_a_damaged_run_is_not_resumed(tiny_run, tmp_path):
    damaged = tmp_path / "damaged"
    shutil.copytree(tiny_run, damaged)
    (damaged / RESUME_FILE).write_bytes(b"PK nothing")
    done = subprocess.run(
        command(tmp_path / "runs", *TINY, "--resume", damaged), capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert re.search(rf"error: {damaged}/{RESUME_FILE}: cannot be read .*; train anew", done.stderr)
    assert not (tmp_path / "runs").exists()


@pytest.mark.slow
def test_runs_in_a_place_that_cannot_be_written_are_refused(tmp_path):
    (tmp_path / "file").write_text("")
    done = subprocess.run(command(tmp_path / "file", *TINY), capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert re.fullmatch(r"error: --runs: cannot make .*; name another place\n", done.stderr)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"action_mode": "torque"}, r"--action-mode: 'torque' is unknown; valid modes are position, residual"),
        ({"timesteps": 0}, r"--timesteps: expected 1 or more; found 0"),
        ({"num_envs": -1}, r"--num-envs: expected 1 or more; found -1"),
        ({"n_steps": 0}, r"--n-steps: expected 1 or more"),
        ({"n_epochs": 0}, r"--n-epochs: expected 1 or more"),
        ({"batch_size": 0}, r"--batch-size: expected 1 or more"),
        ({"batch_size": 1}, r"--batch-size: expected 2 or more"),
        ({"num_envs": 2, "n_steps": 4, "batch_size": 9}, r"--batch-size: 9 is more than the 8 samples.*lower it"),
        ({"seed": -1}, r"--seed: expected 0 to 4294967295; found -1"),
        ({"seed": 2**32}, r"--seed: expected 0 to 4294967295"),
        ({"seconds": 0.0}, r"--seconds: expected more than 0; found 0"),
        ({"seconds": float("nan")}, r"--seconds: expected more than 0; found nan"),
        ({"checkpoint_seconds": 0.0}, r"--checkpoint-seconds: expected more than 0"),
        ({"learning_rate": 0.0}, r"--learning-rate: expected more than 0"),
        ({"learning_rate": float("inf")}, r"--learning-rate: .*finite; found inf"),
        ({"gamma": 1.5}, r"--gamma: expected more than 0, and at most 1; found 1.5"),
        ({"gae_lambda": -0.1}, r"--gae-lambda: expected 0 to 1"),
        ({"clip_range": 0.0}, r"--clip-range: expected more than 0"),
        ({"ent_coef": -1.0}, r"--ent-coef: expected 0 or more"),
        ({"max_grad_norm": 0.0}, r"--max-grad-norm: expected more than 0"),
        ({"hidden": (64, 0)}, r"--hidden: expected widths of 1 or more; found \(64, 0\)"),
        ({"log_std_init": float("nan")}, r"--log-std-init: expected a finite number"),
        ({"name": "a/b"}, r"--name: 'a/b' cannot be part of a directory's name"),
        ({"name": ""}, r"--name: '' cannot"),
        ({"name": ".."}, r"--name: '\.\.' cannot"),
    ],
)
def test_a_bad_training_is_named_as_it_was_typed(values, message):
    with pytest.raises(QuadrupedError, match=message):
        TrainConfig(**values)


# --- the run directory ---


def test_runs_that_start_within_a_second_get_a_directory_each(tmp_path):
    runs = [Run(tmp_path, TrainConfig(), {}, "train") for _ in range(3)]
    for run in runs:
        run.close()
    assert len({run.directory for run in runs}) == 3
    assert (tmp_path / "latest").resolve() == runs[-1].directory.resolve()
    assert not list(tmp_path.glob(".latest*"))


@pytest.mark.parametrize("name", [CONFIG_FILE, CARD_FILE, TENSORS_FILE, RESUME_FILE])
def test_an_incomplete_run_is_not_resumed(tiny_run, tmp_path, name):
    incomplete = tmp_path / "run"
    shutil.copytree(tiny_run, incomplete)
    resumed_config(incomplete, TrainConfig())
    (incomplete / name).unlink()
    with pytest.raises(QuadrupedError, match=rf"--resume: {incomplete / name} is missing.*checkpoints/, or train anew"):
        resumed_config(incomplete, TrainConfig())


def training(task=None, **fields):
    """A run's config with some fields of its own."""
    fields = {"hidden": [8], "activation": "elu", "symmetric": True, **fields}
    return json.dumps({"training": fields, "task": task or {"action": {}}})


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", r"config.json: not valid JSON.*train anew"),
        ("{}", r"config.json: field 'training.hidden' is missing; train anew"),
        ("[]", r"config.json: field 'training.hidden' is missing; train anew"),
        ('{"training": {"hidden": [8]}}', r"config.json: field 'training.activation' is missing; train anew"),
        ('{"training": 3}', r"config.json: field 'training.hidden' is missing; train anew"),
        (training(hidden=5), r"config.json: training.hidden: expected a list of whole numbers.*found 5; train anew"),
        (training(hidden=[8, "x"]), r"config.json: training.hidden: expected .*found \[8, 'x'\]"),
        (training(activation=["elu"]), r"config.json: training.activation: expected one of tanh, .*found \['elu'\]"),
        (training(symmetric="yes"), r"config.json: training.symmetric: expected true or false; found 'yes'"),
        (training(task={"action": {"mode": "x"}}), r"config.json: task: .*train anew"),
    ],
)
def test_a_damaged_config_is_not_resumed(tiny_run, tmp_path, text, message):
    damaged = tmp_path / "run"
    shutil.copytree(tiny_run, damaged)
    (damaged / CONFIG_FILE).write_text(text)
    with pytest.raises(QuadrupedError, match=message):
        resumed_config(damaged, TrainConfig())
