"""The programs `replay.py` and `baseline.py`, run as a user runs them."""

import json
import subprocess
import sys

import numpy as np
import pytest
from paths import DYNA1, ROOT

from quadruped_env import JOINT_NAMES, JointTrajectory, SinusoidalGait, asset_path
from quadruped_env.evaluation.recorded_episode import play, publish

EVALUATE = ROOT / "evaluate"


def run(directory, script, *arguments):
    command = [sys.executable, str(EVALUATE / script), *map(str, arguments)]
    return subprocess.run(command, cwd=directory, capture_output=True, text=True, check=False)


class TestPrograms:
    def test_a_recording_is_repeated_to_the_last_bit(self, tmp_path):
        tiny = ("--seconds", "0.5", "--episodes", "1")
        for arguments in (tiny, (*tiny, "--commands")):
            done = run(tmp_path, "baseline.py", *arguments)
            assert (done.returncode, done.stderr) == (0, "")
        assert "Forward velocity" in done.stdout
        assert "results/baseline-tuned-commands.csv" in done.stdout
        done = run(tmp_path, "replay.py", "results/baseline-tuned-commands.csv")
        assert (done.returncode, done.stderr) == (0, "")
        assert "RH_knee_joint" in done.stdout
        results = tmp_path / "results"
        played = results / "replay-baseline-tuned-commands" / "joint_states.csv"
        assert played.read_bytes() == (results / "baseline-tuned.csv").read_bytes()

    def test_replay_program_compares_with_measurements(self, tmp_path):
        commands = publish(SinusoidalGait.preset("tuned"), 0.5, 50.0)
        commands.save(tmp_path / "told.csv")
        did = play(commands).joints
        names = (*JOINT_NAMES, "tail_joint")
        wider = [np.c_[array, np.zeros(len(did))] for array in (did.positions, did.velocities, did.efforts)]
        JointTrajectory(did.stamps, names, *wider).save(tmp_path / "did.csv")
        done = run(tmp_path, "replay.py", "told.csv", "--compare", "did.csv", "--out", "out")
        assert done.returncode == 0, done.stderr
        assert done.stderr == (
            "mini-quadruped replay: warning: did.csv: left out joints that this robot does not have: tail_joint\n"
        )
        assert "efforts (N m)" in done.stdout
        numbers = json.loads((tmp_path / "out" / "tracking.json").read_text())["comparison"]
        assert numbers["efforts"]["joints"]["RH_knee_joint"]["max"] == 0.0
        page = (tmp_path / "out" / "report.html").read_text()
        assert page.count("data:image/svg+xml") == 6
        assert "Recorded against simulated" in page

    def test_replay_program_reads_the_recording_of_another_robot(self, tmp_path):
        if not DYNA1.is_dir():
            pytest.skip("needs the recording of Dyna1 in ../shared/data/dyna1")
        layout = asset_path("dyna1.toml")
        files = (DYNA1 / "control.csv", "--compare", DYNA1 / "measured.csv", "--columns", layout, "--map", layout)
        done = run(tmp_path, "replay.py", *files, "--out", "out", "--no-report")
        assert done.returncode == 0, done.stderr
        report = json.loads((tmp_path / "out" / "tracking.json").read_text())
        assert report["motion"]["fell_at"] is None
        assert report["motion"]["feet_on_ground_at_start"] >= 3
        assert report["tracking_error"]["all"]["max"] < 0.1
        did = report["comparison"]["positions"]["joints"]
        assert did["RF_knee_joint"]["correlation"] > 0.99
        assert did["LF_hip_joint"]["rms"] > 0.1  # this motor of the real robot did not move
        refused = run(tmp_path, "replay.py", DYNA1 / "control.csv", "--columns", layout, "--out", "other")
        assert refused.returncode == 2
        assert "--" in refused.stderr

    def test_baseline_program_writes_the_tutorials_commands(self, tmp_path):
        arguments = ("--preset", "article", "--rate", "20", "--commands", "--seconds", "2", "--episodes", "1")
        assert run(tmp_path, "baseline.py", *arguments, "--out", "a.csv").returncode == 0
        commands = JointTrajectory.load(tmp_path / "a.csv")
        t = np.arange(41) / 20
        np.testing.assert_allclose(
            commands.positions, SinusoidalGait.preset("article").positions(t), rtol=0, atol=1e-12
        )
        again = run(tmp_path, "baseline.py", *arguments, "--out", "a.csv")
        assert again.returncode == 2
        assert again.stderr.startswith("mini-quadruped baseline: error: a.csv: exists already")
        assert "--overwrite" in again.stderr

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ("", "a.csv: the file is empty"),
            ("stamp_ns,position.LF_hip_joint\n0,0.0\n", "a.csv: joint 'LF_knee_joint' is missing"),
        ],
    )
    def test_a_bad_file_is_one_line_not_a_traceback(self, tmp_path, text, message):
        (tmp_path / "a.csv").write_text(text)
        done = run(tmp_path, "replay.py", "a.csv", "--mode", "kinematic")
        assert (done.returncode, done.stdout) == (2, "")
        assert done.stderr.startswith(f"mini-quadruped replay: error: {message}")
        assert done.stderr.count("\n") == 1
        assert not (tmp_path / "results").exists()

    @pytest.mark.parametrize("script", ["baseline.py", "replay.py"])
    def test_help_names_every_argument(self, script):
        done = run(".", script, "--help")
        assert done.returncode == 0
        for argument in ("--overwrite", "--output", "joint states", "rad", "last bit"):
            assert argument in done.stdout
