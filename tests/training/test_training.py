"""Training: the files of a run, repeated and stopped runs, and refusal of bad arguments."""

import contextlib
import dataclasses
import errno
import json
import os
import re
import runpy
import shlex
import signal
import subprocess
import sys
import types
from pathlib import Path

import numpy as np
import pytest
from trainings import ENDLESS, SCRIPT, TINY, assert_complete, command, progress, running, scalars, train
from waiting import output_of

import quadruped_env
from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.control.policy import TENSORS_FILE
from quadruped_env.envs import ENV_ID
from quadruped_env.policies import load_policy
from quadruped_env.task import TaskConfig
from quadruped_env.training import TrainConfig
from quadruped_env.training.run import (
    CONFIG_FILE,
    PROGRESS_COLUMNS,
    Run,
)


def assert_refused(tmp_path, arguments, message):
    """One clear line, status 2, and no run begun."""
    done = subprocess.run(command(tmp_path / "runs", *arguments), capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert re.search(message, done.stderr), done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""
    assert not (tmp_path / "runs").exists(), "no run was begun"


@pytest.fixture(scope="module")
def tiny_run(tmp_path_factory):
    """A finished tiny training: its directory, its seed 0."""
    return train(tmp_path_factory.mktemp("runs"), *TINY)


# --- files of a run ---


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
    described = dict(re.findall(r"--([a-z-]+)(?:, --no-[a-z-]+)? (.*?)(?= -o DIR,| --[a-z-]+[ ,]|$)", text))
    for field in dataclasses.fields(TrainConfig):
        option = described[field.name.replace("_", "-")]
        default = {} if field.default is dataclasses.MISSING else field.default
        assert option.endswith(f"(default: {default})"), field.name
        assert len(option) > len(f"(default: {default})") + 20, field.name
    assert {"output", "resume"} < set(described)


def test_policy_of_a_run_acts_in_the_environment(tiny_run):
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
    directory = train(tmp_path, *TINY, "--seconds", 2, "--timesteps", 256)
    card = assert_complete(directory).card
    assert card["seconds"] >= 2.0
    assert card["timesteps"] > 256, "not the budget in steps"
    assert all(float(row["seconds"]) < 2.0 for row in progress(directory)[:-1]), "the first update past it is the last"


# --- stopped ---


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_a_training_which_saves_and_exits_cleanly(tmp_path, number):
    with running(tmp_path, *ENDLESS) as process:
        process.send_signal(number)
        output, errors = output_of(process)
    assert process.returncode == 0, errors
    assert "stopped, and saved what was learned" in output
    assert "Traceback" not in errors
    directory = (tmp_path / "latest").resolve()
    policy = assert_complete(directory)
    assert policy.card["timesteps"] == int(progress(directory)[-1]["timesteps"]) > 0


# --- final output ---


@pytest.fixture
def final_output(tmp_path, monkeypatch, capsys):
    """Function that runs the program with a training that takes no time; returns the lines that it prints."""

    def train(config, runs, command, resume, task_file):
        directory = runs / "20260101-000000-flat"
        policy = load_policy("flat")
        policy.with_card({"timesteps": config.timesteps}).save(directory)
        with contextlib.suppress(FileNotFoundError):
            (runs / "latest").unlink()
        (runs / "latest").symlink_to(directory.name)
        return directory, True

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["train/ppo.py", "--runs", str(tmp_path / "my runs"), *arguments])
        with pytest.raises(SystemExit) as ended:
            runpy.run_path(str(SCRIPT), run_name="__main__")
        assert ended.value.code == 0
        return capsys.readouterr().out.splitlines()

    monkeypatch.setitem(sys.modules, "quadruped_env.training.ppo", types.SimpleNamespace(train=train))
    return run


def test_commands_of_the_final_output_can_be_pasted(final_output, tmp_path):
    lines = final_output()
    commands = dict(line.split(":", 1) for line in lines if re.match(r"(evaluate|see)", line))
    assert set(commands) == {"evaluate it", "see it walk", "see curves"}
    for text in commands.values():
        words = shlex.split(text)
        assert str(tmp_path / "my runs") in words[-1]
        program = words[: words.index("--logdir")] if "--logdir" in words else words[:-1]
        done = subprocess.run([*program, "--help"], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


def test_short_training_reports_its_length_and_the_previous_latest_run(final_output, tmp_path):
    latest = tmp_path / "my runs" / "latest"
    lines = final_output("--timesteps", "10000")
    assert lines[1] == f"{latest} now means this run"
    assert lines[2].startswith("it has learned for only 10,000 steps; in mode 'residual' a policy takes about 62,000 ")
    (latest.parent / "20250101-000000-other").mkdir()
    latest.unlink()
    latest.symlink_to("20250101-000000-other")
    lines = final_output("--timesteps", "100000")
    assert lines[1] == f"{latest} now means this run, and no longer 20250101-000000-other"
    assert not any("it has learned for" in line for line in lines)
    assert any(
        "it has learned for" in line for line in final_output("--timesteps", "100000", "--action-mode", "position")
    )


# --- bad arguments ---


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--batch-size", "99999"), r"error: --batch-size: 99999 is more than the \d+ samples of an update"),
        (("--action-mode", "torque"), r"--action-mode.*'torque'.*'position', 'residual'"),
        (("--task", "{"), r"""--task: expected a JSON object such as '{"command".*; found '\{' \(Expecting"""),
        (("--task", "x"), r"""--task: expected a JSON object such as '{"command".*; found 'x' \(Expecting value"""),
        (("--task", "[1]"), r"--task: expected a JSON object such as .*; found '\[1\]'$"),
        (("--task", "9" * 5000), r"--task: expected a JSON object such as .*; found '9{60}' \(Exceeds"),
        (("--task", "[" * 100_000), r"--task: expected a JSON object such as .*; found '\[{60}' \("),
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
    ],
)
def test_a_bad_task_gives_one_clear_line_and_status_2(tmp_path, arguments, message):
    assert_refused(tmp_path, (*TINY, *arguments), message)


@pytest.mark.slow
def test_runs_in_a_place_that_cannot_be_written_are_refused(tmp_path):
    (tmp_path / "file").write_text("")
    done = subprocess.run(command(tmp_path / "file", *TINY), capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert re.fullmatch(r"ppo.py: error: --output: cannot create .*; name another place\n", done.stderr)


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
def test_bad_training_setting_is_named_by_its_flag(values, message):
    with pytest.raises(QuadrupedError, match=message):
        TrainConfig(**values)


# --- the run directory ---


def test_runs_that_start_within_a_second_get_a_directory_each(tmp_path):
    runs = [Run(tmp_path, TrainConfig(), {}, "train") for _ in range(3)]
    for run in runs:
        run.close()
    assert len({run.directory for run in runs}) == 3
    assert (tmp_path / "latest").resolve() == runs[-1].directory.resolve()
    assert not list(tmp_path.glob(".*"))


@pytest.mark.parametrize("make", [Path.mkdir, Path.touch])
def test_runs_in_which_latest_is_not_a_link_are_refused_and_kept(tmp_path, make):
    make(tmp_path / "latest")
    message = r"--output: .*latest is not a symbolic link.*; rename it, or name another"
    with pytest.raises(QuadrupedError, match=message):
        Run(tmp_path, TrainConfig(), {}, "train")
    assert [path.name for path in tmp_path.iterdir()] == ["latest"]
    assert not (tmp_path / "latest").is_symlink()


def test_run_that_cannot_be_started_leaves_no_files(tmp_path, monkeypatch):
    def fsync(descriptor):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", fsync)
    with pytest.raises(QuadrupedError, match=r"cannot be written \(No space left on device\); make room"):
        Run(tmp_path, TrainConfig(), {}, "train")
    assert not list(tmp_path.iterdir())


def test_a_row_of_progress_is_written_in_full_or_not_at_all(tmp_path):
    """A limit on the size of files stands in for a full disk: a part of the row still fits."""
    code = """
import resource, sys
from pathlib import Path
from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.training import TrainConfig
from quadruped_env.training.run import PROGRESS_COLUMNS, Run
run = Run(Path(sys.argv[1]), TrainConfig(), {}, "train")
row = dict.fromkeys(PROGRESS_COLUMNS, 1.5)
run.log(row)
size = (run.directory / "progress.csv").stat().st_size
resource.setrlimit(resource.RLIMIT_FSIZE, (size + 7, size + 7))
try:
    run.log(row)
except QuadrupedError as error:
    print(error)
"""
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path)], capture_output=True, text=True, check=True)
    assert re.search(r"progress\.csv: cannot be written \(.+\); make room", done.stdout)
    (row,) = progress(tmp_path / "latest")
    assert set(row.values()) == {"1.5"}


def test_a_training_on_a_full_disk_ends_with_one_clear_error_and_keeps_its_checkpoint(tmp_path, monkeypatch):
    from quadruped_env.training import ppo

    def fsync(descriptor):
        # Full from the end of the first checkpoint on.
        if list(tmp_path.glob("*/checkpoints/*s/policy.json")):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", fsync)
    config = TrainConfig(timesteps=10**9, num_envs=4, n_steps=8, batch_size=16, hidden=(8,), checkpoint_seconds=1e-3)
    with pytest.raises(QuadrupedError, match=r"cannot be written \(No space.*; what was saved before is kept in "):
        ppo.train(config, tmp_path, "train")
    (run,) = (path for path in tmp_path.iterdir() if not path.is_symlink())
    assert not list(run.rglob(".*"))
    with pytest.warns(QuadrupedWarning, match="last checkpoint"):
        assert load_policy(run).card["timesteps"] == 32


def test_a_training_whose_curves_cannot_be_written_ends_with_one_clear_error(tmp_path, monkeypatch, capfd):
    from tensorboard.summary.writer.record_writer import RecordWriter

    from quadruped_env.training import ppo

    written = []

    def fail(self, data):
        written.append(data)
        if len(written) > 1:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(RecordWriter, "write", fail)
    monkeypatch.setattr(ppo, "_LOG_INTERVAL", 0.0)
    config = TrainConfig(timesteps=10**9, num_envs=4, n_steps=8, batch_size=16, hidden=(8,))
    with pytest.raises(QuadrupedError, match=r"-ppo: cannot be written \(No space left on device\); make room"):
        ppo.train(config, tmp_path, "train")
    assert "Traceback" not in capfd.readouterr().err
    assert load_policy(tmp_path / "latest").card["timesteps"] > 0
