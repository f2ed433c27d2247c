"""The program that writes reports: the policy that it finds, and its errors."""

import json
import subprocess
import sys
from pathlib import Path

import missing_opengl
import pytest
from comparisons import random_policy
from paths import ROOT

from quadruped_env import JOINT_NAMES, JointTrajectory, MissingExtraError, QuadrupedError
from quadruped_env.evaluation import evaluated_policy
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.report import report_directory


def test_default_is_the_latest_run_then_the_shipped_policy(run_directory, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    asked = []
    monkeypatch.setattr(
        evaluated_policy, "load_policy", lambda name, *_, **__: asked.append(name) or random_policy("position")
    )
    assert find_policy(None).output == Path("results/flat")
    assert asked == ["flat"]
    Path("runs").mkdir()
    Path("runs/latest").symlink_to(run_directory)
    found = find_policy(None)
    assert (found.name, found.output) == ("20260101-000000-ppo", Path("runs/latest/evaluation"))
    assert find_policy("flat", Path("there")).output == Path("there")


def test_a_missing_library_names_its_extra(tmp_path, monkeypatch):
    monkeypatch.setattr(report_directory.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(MissingExtraError, match=r"mini-quadruped\[report\]"):
        report_directory.prepare_output(tmp_path)


def test_an_output_that_cannot_be_made_is_named(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(QuadrupedError, match=r"file.*cannot be created.*choose another directory"):
        report_directory.prepare_output(tmp_path / "file" / "out")


def program(*arguments, cwd):
    return subprocess.run(
        [sys.executable, ROOT / "evaluate" / "policy.py", *map(str, arguments)],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.slow
def test_program_evaluates_a_run(run_directory, tmp_path):
    options = ["--seeds", 1, "--seconds", 2, "--no-video", "--output", tmp_path / "out", "--joints", "walk.csv"]
    result = program(run_directory, *options, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    joints = JointTrajectory.load(tmp_path / "walk.csv")
    assert (joints.names, joints.kinds) == (JOINT_NAMES, ("positions", "velocities", "efforts"))
    assert joints.stamps[0] == 20_000_000
    (tmp_path / "out" / "report.html").unlink()
    refused = program(run_directory, *options, cwd=tmp_path)
    assert (refused.returncode, "walk.csv: exists already" in refused.stderr) == (2, True), refused.stderr
    assert program(run_directory, *options, "--overwrite", cwd=tmp_path).returncode == 0
    assert "Forwards: velocity error (m/s)" in result.stdout
    assert str(tmp_path / "out" / "report.html") in result.stdout
    assert '<a href="walk.html">' in (tmp_path / "out" / "report.html").read_text()
    assert (tmp_path / "out" / "walk.html").is_file()
    assert json.loads((tmp_path / "out" / "metrics.json").read_text())["command_line"] == (
        "mini-quadruped evaluate runs/20260101-000000-ppo --seeds 1 --seconds 2"
    )


@pytest.mark.slow
def test_report_without_opengl_is_written_and_says_so_once_with_the_fix(without_opengl, tmp_path):
    options = ["--seeds", "1", "--seconds", "2", "--output", tmp_path / "out"]
    result = subprocess.run(
        without_opengl(sys.executable, "-m", "quadruped_env", "evaluate", "flat", *options),
        env=missing_opengl.environment(),
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert result.returncode == 0, result.stderr
    (message,) = [line for line in result.stderr.splitlines() if "%" not in line]
    assert message.startswith("No video: no OpenGL to render with: install")
    assert "libegl1" in message
    page = (tmp_path / "out" / "report.html").read_text()
    assert page.count("No video: no OpenGL") == 1
    assert "<video" not in page
