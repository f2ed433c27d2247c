"""The program `convert.py`, run as a user runs it."""

import subprocess
import sys

import numpy as np
import pytest
from paths import ROOT
from trajectories import assert_same, random_trajectory

from quadruped_env import JOINT_NAMES, JointTrajectory

pytest.importorskip("rosbags")

PROGRAM = ROOT / "evaluate" / "convert.py"


def run(*arguments):
    return subprocess.run([sys.executable, PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)


def test_convert_to_a_bag_and_back_gives_the_same_recording(tmp_path):
    trajectory = random_trajectory(rows=100)
    trajectory.save(tmp_path / "a.csv")
    done = run(tmp_path / "a.csv", tmp_path / "bag", "--storage", "sqlite3", "--tf-rate", "50")
    assert done.returncode == 0, done.stderr
    assert "100 rows over 1.980 s, usually at 50 Hz: positions, velocities, efforts" in done.stdout
    assert done.stdout.endswith(f"written: {tmp_path / 'bag'}\n")
    done = run(tmp_path / "bag", tmp_path / "b.csv")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "b.csv").read_bytes() == (tmp_path / "a.csv").read_bytes()


def test_convert_reports_gaps_and_rows_that_it_left_out(tmp_path):
    stamps = np.delete(np.arange(100) * 20_000_000, np.r_[40:70])
    JointTrajectory(stamps, JOINT_NAMES, np.zeros((70, 8))).save(tmp_path / "a.csv")
    text = (tmp_path / "a.csv").read_text().splitlines(keepends=True)
    text[5] = text[5].replace("0.0", "nan", 1)
    (tmp_path / "a.csv").write_text("".join(text))
    refused = run(tmp_path / "a.csv", tmp_path / "b.csv")
    assert refused.returncode == 2
    assert "line 6, position.LF_hip_joint: nan is not finite" in refused.stderr
    assert "Traceback" not in refused.stderr
    assert not (tmp_path / "b.csv").exists()
    done = run(tmp_path / "a.csv", tmp_path / "b.csv", "--drop")
    assert done.returncode == 0, done.stderr
    assert "gap of 0.620 s at 0.780 s" in done.stdout
    assert "left out 1 of 70: a number is not finite" in done.stdout
    assert len(JointTrajectory.load(tmp_path / "b.csv")) == 69


def test_convert_with_options_changes_the_recording(tmp_path):
    trajectory = random_trajectory(rows=101, velocities=None, efforts=None)
    trajectory.save(tmp_path / "a.mcap")
    options = ["--start", "0.5", "--stop", "1.5", "--rate", "100", "--differentiate", "0.1"]
    done = run(tmp_path / "a.mcap", tmp_path / "b.csv", *options)
    assert done.returncode == 0, done.stderr
    expected = trajectory.slice(0.5, 1.5).resample(100.0).differentiate(0.1)
    assert_same(JointTrajectory.load(tmp_path / "b.csv", degrees=False), expected)


def test_convert_to_an_existing_file_without_overwrite_is_refused(tmp_path):
    random_trajectory().save(tmp_path / "a.csv")
    random_trajectory(rows=2).save(tmp_path / "b.csv")
    refused = run(tmp_path / "a.csv", tmp_path / "b.csv")
    assert refused.returncode == 2
    assert refused.stderr.startswith(f"mini-quadruped convert: error: {tmp_path / 'b.csv'}: exists already")
    assert len(JointTrajectory.load(tmp_path / "b.csv")) == 2
    refused = run(tmp_path / "a.csv", tmp_path / "a.csv", "--overwrite")
    assert "is the file that is read" in refused.stderr
    assert run(tmp_path / "a.csv", tmp_path / "b.csv", "--overwrite").returncode == 0
    assert_same(JointTrajectory.load(tmp_path / "b.csv"), random_trajectory())
