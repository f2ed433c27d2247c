"""The program `train`: its help, its final output, and refusal of bad arguments."""

import argparse
import contextlib
import dataclasses
import io
import re
import runpy
import shlex
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout

import pytest
from trainings import SCRIPT, TINY, command

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.cli.train import add_arguments
from quadruped_env.control.control_config import ACTION_MODES
from quadruped_env.evaluation.learning_gain import GAIN_HEADER, reward_in_words
from quadruped_env.policies import load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.training.algorithms import ALGORITHMS
from quadruped_env.training.default_settings import with_recipe
from quadruped_env.training.recipes import RECIPES
from quadruped_env.training.train_config import TrainConfig


def assert_refused(tmp_path, arguments, message):
    """One clear line, status 2, and no run begun."""
    output, errors = io.StringIO(), io.StringIO()
    with redirect_stdout(output), redirect_stderr(errors):
        try:
            status = main(["train", "-o", str(tmp_path / "runs"), *arguments])
        except SystemExit as ended:
            status = ended.code
    assert status == 2
    assert re.search(message, errors.getvalue(), re.MULTILINE), errors.getvalue()
    assert output.getvalue() == ""
    assert not (tmp_path / "runs").exists(), "no run was begun"


def stated_defaults(text):
    """Default of an option by the option that leads to it, from its help: 3 with --recipe rough, --algo sac."""
    first, *others = text.rpartition("(default: ")[2].removesuffix(")").split("; ")
    stated = {"": first}
    for value, _, options in (other.partition(" with ") for other in others):
        for option, names in (one.split(" ") for one in options.split(", ")):
            stated |= {f"{option} {name}": value for name in names.split("/")}
    return stated


def test_help_states_of_every_field_its_meaning_and_the_defaults_that_a_training_has():
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    with pytest.raises(SystemExit):
        parser.parse_args(["--help-all"])
    described = {action.dest: action.help for action in parser._actions}
    choices = {"recipe": RECIPES, "algo": ALGORITHMS, "action_mode": ACTION_MODES}
    for field in dataclasses.fields(TrainConfig):
        option = described[field.name]
        assert len(option.partition("(default")[0]) > 20, field.name
        if field.name in {"task", "name"}:
            continue
        stated = stated_defaults(option)
        for name, values in choices.items():
            for value in values:
                if name != field.name:
                    config = TrainConfig(**with_recipe({name: value}, MINI_QUADRUPED, ()))
                    expected = in_words(getattr(config, field.name))
                    choice = f"--{name.replace('_', '-')} {value}"
                    assert stated.pop(choice, stated[""]) == expected, f"{field.name} with {choice}"
        assert set(stated) == {""}, field.name
    assert {"output", "resume"} < set(described)


def in_words(value):
    words = {"True": "yes", "False": "no", "None": "none", "": "none"}
    return " ".join(map(str, value)) if isinstance(value, tuple) else words.get(str(value), str(value))


@pytest.fixture
def final_output(tmp_path, monkeypatch, capsys):
    """Function that runs the program with a training that takes no time; returns the lines that it prints."""

    def train(config, runs, *arguments, **others):
        directory = runs / "20260101-000000-flat"
        policy = load_policy("flat")
        policy.with_card({"timesteps": config.timesteps, "seconds": 2.4}).save(directory)
        with contextlib.suppress(FileNotFoundError):
            (runs / "latest").unlink()
        (runs / "latest").symlink_to(directory.name)
        return directory, True

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["train/ppo.py", "-o", str(tmp_path / "my runs"), *arguments])
        with pytest.raises(SystemExit) as ended:
            runpy.run_path(str(SCRIPT), run_name="__main__")
        assert ended.value.code == 0
        return capsys.readouterr().out.splitlines()

    monkeypatch.setattr("quadruped_env.training.train.train", train)
    monkeypatch.setattr("quadruped_env.cli.train.EPISODES", 2)
    return run


def test_commands_of_the_final_output_can_be_pasted(final_output, tmp_path):
    lines = final_output()
    commands = dict(line.split(":", 1) for line in lines if re.match(r"(evaluate|see)", line))
    assert set(commands) == {"evaluate it", "see it walk", "see curves"}
    for text in commands.values():
        words = shlex.split(text)
        assert str(tmp_path / "my runs") in words[-1]
        if "--logdir" in words:
            assert words[1:3] == ["-m", "tensorboard.main"]
        else:
            done = subprocess.run([*words[:-1], "--help"], capture_output=True, text=True, check=False)
            assert done.returncode == 0, done.stderr


def test_short_training_reports_its_length_and_the_previous_latest_run(final_output, tmp_path):
    latest = tmp_path / "my runs" / "latest"
    lines = final_output("--timesteps", "10000")
    assert lines[0] == "learned from 10,000 steps in 2 s"
    assert lines[2] == f"{latest} now means this run"
    (latest.parent / "20250101-000000-other").mkdir()
    latest.unlink()
    latest.symlink_to("20250101-000000-other")
    lines = final_output("--timesteps", "100000")
    assert lines[2] == f"{latest} now means this run, and no longer 20250101-000000-other"


def test_training_ends_with_what_it_added_over_the_zero_action_and_keeps_it_on_the_card(tmp_path, capsys):
    assert main(["train", "-o", str(tmp_path / "runs"), *TINY, "--hidden", "8"]) == 0
    lines = capsys.readouterr().out.splitlines()
    learning = load_policy(tmp_path / "runs" / "latest").card["learning"]
    assert learning["episodes"] == 2, "as many steps are measured as were trained, and two episodes at least"
    assert f"In its own task, 2 episodes of 20 s, it {learning['verdict']}" in lines
    first = next(i for i, line in enumerate(lines) if line.split() == " ".join(GAIN_HEADER).split()) + 1
    assert lines[first].startswith("own task  "), "motions take more steps than this training had"
    assert lines[first + 1] == reward_in_words(learning)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--batch-size", "99999"), r"error: --batch-size: 99999 is more than the \d+ samples of an update"),
        (("--action-mode", "torque"), r"--action-mode.*'torque'.*'position', 'residual'"),
        (("--task", "{"), r"""--task: expected a JSON object such as '{"command".*; found '\{' \(Expecting"""),
        (("--task", "9" * 5000), r"--task: expected a JSON object such as .*; found '9{60}' \(Exceeds"),
        (("--task", "[" * 100_000), r"--task: expected a JSON object such as .*; found '\[{60}' \("),
        (("--task", '{"decimation": 0}'), r"error: config: decimation must be 1 or more, at most 1000; found 0"),
        (("--resume", "nowhere"), r"error: --resume: nowhere is not a directory; name a run such as runs/latest"),
        (("--timesteps", "many"), r"--timesteps.*'many'"),
        (("--speed", "9"), r"unrecognized arguments: --speed 9"),
    ],
)
def test_bad_arguments_give_one_clear_line_and_status_2(tmp_path, arguments, message):
    assert_refused(tmp_path, arguments, message)


@pytest.mark.slow
def test_runs_in_a_place_that_cannot_be_written_are_refused(tmp_path):
    (tmp_path / "file").write_text("")
    done = subprocess.run(command(tmp_path / "file", *TINY), capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert re.fullmatch(r"mini-quadruped train: error: --output: cannot create .*; name another place\n", done.stderr)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"action_mode": "torque"}, r"--action-mode: 'torque' is unknown; valid modes are position, residual"),
        ({"timesteps": 0}, r"--timesteps: expected 1 or more, and at most .*; found 0"),
        ({"n_steps": 0}, r"--n-steps: expected 1 or more"),
        ({"batch_size": 1}, r"--batch-size: expected 2 or more"),
        ({"num_envs": 2, "n_steps": 4, "batch_size": 9}, r"--batch-size: 9 is more than the 8 samples.*lower it"),
        ({"seed": -1}, r"--seed: expected 0 or more, and at most 4294967295; found -1"),
        ({"seconds": float("nan")}, r"--seconds: expected .*more than 0, .*; found nan"),
        ({"learning_rate": float("inf")}, r"--learning-rate: .*at most 1; found inf"),
        ({"gamma": 1.5}, r"--gamma: expected more than 0, and at most 1; found 1.5"),
        ({"gae_lambda": -0.1}, r"--gae-lambda: expected 0 or more, and at most 1;"),
        ({"hidden": (64, 0)}, r"--hidden: expected .*widths of 1 or more, .*; found \(64, 0\)"),
        ({"log_std_init": float("nan")}, r"--log-std-init: expected -20 or more"),
        ({"name": "a/b"}, r"--name: 'a/b' cannot be part of a directory's name"),
        ({"name": ".."}, r"--name: '\.\.' cannot"),
    ],
)
def test_bad_training_setting_is_named_by_its_flag(values, message):
    with pytest.raises(QuadrupedError, match=message):
        TrainConfig(**values)
