"""The command `convert`."""

import numpy as np
import pytest
from trajectories import assert_same, random_trajectory

from quadruped_env import JOINT_NAMES, JointTrajectory
from quadruped_env.cli.main import main

pytest.importorskip("rosbags")


@pytest.fixture
def run(capsys):
    """Runs the command; its status, output and errors."""

    def convert(*arguments):
        status = main(["convert", *map(str, arguments)])
        return status, *capsys.readouterr()

    return convert


def test_convert_to_a_bag_and_back_gives_the_same_recording(tmp_path, run):
    trajectory = random_trajectory(rows=100)
    trajectory.save(tmp_path / "a.csv")
    status, output, errors = run(tmp_path / "a.csv", tmp_path / "bag", "--storage", "sqlite3")
    assert status == 0, errors
    assert "100 rows over 1.980 s, usually at 50 Hz: positions, velocities, efforts" in output
    assert output.endswith(f"written: {tmp_path / 'bag'}\n")
    status, output, errors = run(tmp_path / "bag", tmp_path / "b.csv")
    assert status == 0, errors
    assert (tmp_path / "b.csv").read_bytes() == (tmp_path / "a.csv").read_bytes()


def test_convert_reports_gaps_and_rows_that_it_left_out(tmp_path, run):
    stamps = np.delete(np.arange(100) * 20_000_000, np.r_[40:70])
    JointTrajectory(stamps, JOINT_NAMES, np.zeros((70, 8))).save(tmp_path / "a.csv")
    text = (tmp_path / "a.csv").read_text().splitlines(keepends=True)
    text[5] = text[5].replace("0.0", "nan", 1)
    (tmp_path / "a.csv").write_text("".join(text))
    status, _, errors = run(tmp_path / "a.csv", tmp_path / "b.csv")
    assert status == 2
    assert "line 6, position.LF_hip_joint: nan is not finite" in errors
    assert not (tmp_path / "b.csv").exists()
    status, output, errors = run(tmp_path / "a.csv", tmp_path / "b.csv", "--repair", "drop")
    assert status == 0, errors
    assert "gap of 0.620 s at 0.780 s" in output
    assert "left out 1 of 70: a number is not finite" in output
    assert len(JointTrajectory.load(tmp_path / "b.csv")) == 69


def test_convert_with_options_changes_the_recording(tmp_path, run):
    trajectory = random_trajectory(rows=101, velocities=None, efforts=None)
    trajectory.save(tmp_path / "a.mcap")
    options = ["--start", "0.5", "--stop", "1.5", "--rate", "100", "--differentiate", "0.1"]
    status, _, errors = run(tmp_path / "a.mcap", tmp_path / "b.csv", *options)
    assert status == 0, errors
    expected = trajectory.slice(0.5, 1.5).resample(100.0).differentiate(0.1)
    assert_same(JointTrajectory.load(tmp_path / "b.csv", unit="rad"), expected)


def test_convert_to_an_existing_file_without_overwrite_is_refused(tmp_path, run):
    random_trajectory().save(tmp_path / "a.csv")
    random_trajectory(rows=2).save(tmp_path / "b.csv")
    status, _, errors = run(tmp_path / "a.csv", tmp_path / "b.csv")
    assert status == 2
    assert errors.startswith(f"mini-quadruped convert: error: {tmp_path / 'b.csv'}: exists already")
    assert len(JointTrajectory.load(tmp_path / "b.csv")) == 2
    _, _, errors = run(tmp_path / "a.csv", tmp_path / "a.csv", "--overwrite")
    assert "is the file that is read" in errors
    assert run(tmp_path / "a.csv", tmp_path / "b.csv", "--overwrite")[0] == 0
    assert_same(JointTrajectory.load(tmp_path / "b.csv"), random_trajectory())
