"""The commands `replay` and `baseline`."""

import json

import numpy as np
import pytest
from paths import DYNA1

from quadruped_env import JOINT_NAMES, JointTrajectory, SinusoidalGait, asset_path
from quadruped_env.cli.main import main
from quadruped_env.evaluation.recorded_episode import play, publish


@pytest.fixture
def run(tmp_path, monkeypatch, capsys):
    """Runs a command in `tmp_path`; its status, output and errors."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments):
        status = main([*map(str, arguments)])
        return status, *capsys.readouterr()

    return run


@pytest.fixture
def without_report(monkeypatch):
    """A replay's page takes longer than the replay."""
    monkeypatch.setattr("quadruped_env.replay.replay_report.write_replay_report", lambda *_: None)


class TestPrograms:
    @pytest.mark.usefixtures("without_report")
    def test_a_recording_is_repeated_to_the_last_bit(self, tmp_path, run):
        tiny = ("--seconds", "0.5", "--episodes", "1")
        for arguments in (tiny, (*tiny, "--commands")):
            status, output, errors = run("baseline", *arguments)
            assert (status, errors) == (0, "")
        assert "Forward velocity" in output
        assert "results/baseline-tuned-commands.csv" in output
        status, output, errors = run("replay", "results/baseline-tuned-commands.csv")
        assert (status, errors) == (0, "")
        assert "RH_knee_joint" in output
        results = tmp_path / "results"
        played = results / "replay-baseline-tuned-commands" / "joint_states.csv"
        assert played.read_bytes() == (results / "baseline-tuned.csv").read_bytes()

    @pytest.mark.filterwarnings("default")
    def test_replay_program_compares_with_measurements(self, tmp_path, run):
        commands = publish(SinusoidalGait.preset("tuned"), 0.5, 50.0)
        commands.save(tmp_path / "told.csv")
        did = play(commands).joints
        names = (*JOINT_NAMES, "tail_joint")
        wider = [np.c_[array, np.zeros(len(did))] for array in (did.positions, did.velocities, did.efforts)]
        JointTrajectory(did.stamps, names, *wider).save(tmp_path / "did.csv")
        status, output, errors = run("replay", "told.csv", "--compare", "did.csv", "-o", "out")
        assert status == 0
        assert errors == (
            "mini-quadruped replay: warning: did.csv: left out joints that this robot does not have: tail_joint\n"
        )
        assert "efforts (N m)" in output
        numbers = json.loads((tmp_path / "out" / "tracking.json").read_text())["comparison"]
        assert numbers["efforts"]["joints"]["RH_knee_joint"]["max"] == 0.0
        page = (tmp_path / "out" / "report.html").read_text()
        assert page.count("data:image/svg+xml") == 6
        assert "Recorded against simulated" in page

    @pytest.mark.usefixtures("without_report")
    def test_replay_program_reads_the_recording_of_another_robot(self, tmp_path, run):
        if not DYNA1.is_dir():
            pytest.skip("needs the recording of Dyna1 in ../shared/data/dyna1")
        layout = asset_path("dyna1.toml")
        files = (DYNA1 / "control.csv", "--compare", DYNA1 / "measured.csv", "--columns", layout, "--map", layout)
        status, _, errors = run("replay", *files, "-o", "out")
        assert status == 0, errors
        report = json.loads((tmp_path / "out" / "tracking.json").read_text())
        assert report["motion"]["fell_at"] is None
        assert report["motion"]["feet_on_ground_at_start"] >= 3
        assert report["tracking_error"]["all"]["max"] < 0.1
        did = report["comparison"]["positions"]["joints"]
        assert did["RF_knee_joint"]["correlation"] > 0.99
        assert did["LF_hip_joint"]["rms"] > 0.1  # this motor of the real robot did not move
        assert run("replay", DYNA1 / "control.csv", "--columns", layout, "-o", "other")[0] == 2

    def test_baseline_program_writes_the_tutorials_commands(self, tmp_path, run):
        arguments = ("--preset", "article", "--rate", "20", "--commands", "--seconds", "2", "--episodes", "1")
        assert run("baseline", *arguments, "-o", "a.csv")[0] == 0
        commands = JointTrajectory.load(tmp_path / "a.csv")
        t = np.arange(41) / 20
        np.testing.assert_allclose(
            commands.positions, SinusoidalGait.preset("article").positions(t), rtol=0, atol=1e-12
        )
        status, _, errors = run("baseline", *arguments, "-o", "a.csv")
        assert status == 2
        assert errors.startswith("mini-quadruped baseline: error: a.csv: exists already")

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ("", "a.csv: the file is empty"),
            ("stamp_ns,position.LF_hip_joint\n0,0.0\n", "a.csv: joint 'LF_knee_joint' is missing"),
        ],
    )
    def test_a_bad_file_is_one_line_not_a_traceback(self, tmp_path, run, text, message):
        (tmp_path / "a.csv").write_text(text)
        status, output, errors = run("replay", "a.csv", "--mode", "kinematic")
        assert (status, output) == (2, "")
        assert errors.startswith(f"mini-quadruped replay: error: {message}")
        assert errors.count("\n") == 1
        assert not (tmp_path / "results").exists()
