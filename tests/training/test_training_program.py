"""The program `train`: its help, its final output, and refusal of bad arguments."""

import argparse
import contextlib
import dataclasses
import io
import json
import re
import runpy
import shlex
import subprocess
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from types import SimpleNamespace

import pytest
from trainings import SCRIPT, TINY, command

from quadruped_env.cli.main import main
from quadruped_env.cli.train import add_arguments
from quadruped_env.policies import load_policy
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


def test_help_states_of_every_option_its_meaning_and_default():
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    with pytest.raises(SystemExit):
        parser.parse_args(["--help"])
    described = {action.dest: action.help for action in parser._actions}
    for field in dataclasses.fields(TrainConfig):
        if field.name in described:
            meaning, _, default = described[field.name].partition(" (default: ")
            assert len(meaning) > 20, field.name
            assert default.endswith(")") or field.name == "task", field.name
    assert {"timesteps", "hidden", "output", "resume"} < set(described)
    assert described["hidden"].endswith("(default: 128 128)")


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
    gain = SimpleNamespace(table=str, verdict=str, episodes=2, seconds=20.0, is_better=True)
    monkeypatch.setattr("quadruped_env.cli.train.measure_learning", lambda *arguments: gain)
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
            assert Path(words[0]).is_file()
            with pytest.raises(SystemExit) as ended:
                main([*words[1:-1], "--help"])
            assert ended.value.code == 0


def test_training_says_what_the_motors_of_its_task_lack(final_output):
    assert not any(line.startswith("note: ") for line in final_output())
    soft = {"kp": 1.0}
    lines = final_output("--task", json.dumps({"motor": {"hip": soft, "knee": soft}}))
    assert lines[0].startswith("note: mini_quadruped: kp 1 N m/rad: in a trot the robot sinks by ")


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


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--batch-size", "99999"), r"error: --batch-size: 99999 is more than the \d+ samples of an update"),
        (("--action-mode", "torque"), r"--action-mode.*'torque'.*'position', 'residual'"),
        (("--task", "{"), r"--task: found '\{': not valid JSON: Expecting.*; expected a JSON object such as"),
        (("--task", "9" * 5000), r"--task: found '9{60}': a number of over 300 digits"),
        (("--task", "[" * 100_000), r"--task: found '\[{60}': nested too deeply"),
        (("--task", '{"decimation": 0}'), r"error: config.decimation must be a whole number from 1 to 1000; found 0"),
        (("--resume", "nowhere"), r"error: nowhere is not a directory; name a run such as runs/latest"),
        (("--hidden", "63"), r"error: --hidden: expected even widths"),
        (("--algo", "a2c", "--n-epochs", "2"), r"error: --n-epochs: a2c does not use it"),
        (("--tau", "0.1"), r"unrecognized arguments: --tau 0.1"),
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
    assert re.fullmatch(r"mini-quadruped train: error: cannot create .*; name another place\n", done.stderr)
