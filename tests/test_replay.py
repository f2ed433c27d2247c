import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError, SinusoidalGait, forward_kinematics
from quadruped_env.evaluation.baseline import baseline_files, run_baseline
from quadruped_env.evaluation.progress import ProgressLine
from quadruped_env.evaluation.recording import MAX_SECONDS, play, publish, record
from quadruped_env.evaluation.replay import LIMIT_TOLERANCE, replay
from quadruped_env.evaluation.results import free_path, write_json
from quadruped_env.gait import PRESETS
from quadruped_env.policies import GaitController, ZeroController
from quadruped_env.robot import JOINT_POSITION_HIGH, LINK_NAMES, STANCE, STANCE_HEIGHT

EVALUATE = Path(__file__).parents[1] / "evaluate"


def assert_same(a, b):
    """Two trajectories, equal to the last bit."""
    for name in ("stamps", "positions", "velocities", "efforts"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name))


def standing(seconds=1.0, **changes):
    stamps = np.array([0, round(seconds * 1e9)])
    return JointTrajectory(**({"stamps": stamps, "names": JOINT_NAMES, "positions": np.tile(STANCE, (2, 1))} | changes))


class TestPublish:
    @pytest.mark.parametrize("seconds", [10.0, 0.99])
    def test_article_at_20_hz(self, seconds):
        commands = publish(SinusoidalGait.preset("article"), seconds, 20.0)
        t = np.arange(int(seconds * 20) + 1) / 20
        np.testing.assert_array_equal(commands.stamps, np.arange(len(t)) * 50_000_000)
        expected = SinusoidalGait.preset("article")
        np.testing.assert_allclose(commands.positions, expected.positions(t), rtol=0, atol=1e-12)
        np.testing.assert_allclose(commands.positions_at(t), expected.positions(t), rtol=0, atol=1e-12)
        np.testing.assert_allclose(commands.velocities, expected.velocities(t), rtol=0, atol=1e-12)

    @pytest.mark.parametrize(
        ("seconds", "rate", "message"),
        [
            (0.0, 50.0, "seconds: expected over 0 .*found 0"),
            (float("nan"), 50.0, "seconds: .*found nan"),
            (1e9, 50.0, "seconds: .*up to 21600 s; found 1e.09"),
            (1.0, 0.0, "rate: expected over 0 .*found 0"),
            (1.0, 1e4, "rate: .*up to 1000 Hz; found 10000"),
        ],
    )
    def test_numbers_that_make_no_sense(self, seconds, rate, message):
        with pytest.raises(QuadrupedError, match=message):
            publish(SinusoidalGait.preset("article"), seconds, rate)


class TestRecord:
    def test_begins_with_the_start_and_has_a_row_a_control_step(self):
        recording = record(ZeroController(), 0.5)
        np.testing.assert_array_equal(recording.joints.stamps, np.arange(26) * 20_000_000)
        np.testing.assert_array_equal(recording.joints.positions[0], STANCE)
        np.testing.assert_array_equal(recording.base_pose[0], [0, 0, STANCE_HEIGHT, 1, 0, 0, 0])
        assert not recording.joints.velocities[0].any()
        assert recording.joints.efforts[-1].any()
        assert recording.fell_at is None
        assert recording.outcome() == (
            "In 0.5 s the robot stayed on its feet and got 0.00 m ahead and 0.00 m to the left."
        )

    def test_velocities_are_the_derivative_of_positions(self):
        joints = record(GaitController(SinusoidalGait.preset("trot"), "trot"), 1.0).joints
        # Without the start, where the robot jumps into the gait. A landing foot stops its joints within a step.
        change = np.diff(joints.positions[5:], axis=0)
        mean_velocity = (joints.velocities[6:] + joints.velocities[5:-1]) / 2
        np.testing.assert_allclose(change / 0.02, mean_velocity, rtol=0, atol=2.0)
        assert np.corrcoef(change.ravel(), mean_velocity.ravel())[0, 1] > 0.95

    def test_a_gait_played_from_its_commands_is_the_gait(self):
        gait = SinusoidalGait.preset("tuned")
        played, walked = (
            play(publish(gait, 2.0, 50.0)),
            record(GaitController(gait, "tuned"), 2.0, start=gait.positions(0.0)),
        )
        assert_same(played.joints, walked.joints)
        np.testing.assert_array_equal(played.base_pose, walked.base_pose)

    def test_says_when_the_robot_fell_and_goes_on(self):
        # Legs swung back as far as they go: it lands on its belly.
        flat = np.tile([1.5, 0.0], 4)
        recording = play(standing(3.0, positions=np.stack([STANCE, flat]), stamps=[0, 1_000_000_000]))
        assert 0.0 < recording.fell_at <= 1.0
        assert len(recording.joints) == 51
        assert f"fell at {recording.fell_at:.2f} s" in recording.outcome()

    def test_progress_reaches_the_end(self):
        shares = []
        play(standing(0.2), progress=shares.append)
        assert shares == sorted(shares)
        assert (len(shares), shares[-1]) == (10, 1.0)


class TestReplay:
    @pytest.mark.parametrize("preset", PRESETS)
    @pytest.mark.parametrize("rate", [20.0, 50.0])
    def test_commands_give_the_motion_of_the_baseline(self, tmp_path, preset, rate):
        baseline = run_baseline(preset, seconds=1.0, rate=rate, episodes=1)
        baseline.save(tmp_path / "a.csv", commands=True)
        again = replay(JointTrajectory.load(tmp_path / "a.csv"))
        assert_same(again.played, baseline.recording.joints)
        np.testing.assert_array_equal(again.motion.base_pose, baseline.recording.base_pose)

    def test_kinematic_is_forward_kinematics(self, tmp_path):
        recorded = publish(SinusoidalGait.preset("article"), 1.0, 20.0)
        result = replay(recorded, "kinematic")
        assert not result.tracking_error().any()
        for link, (position, quaternion) in forward_kinematics(recorded.positions).items():
            np.testing.assert_array_equal(result.link_poses()[link][0], position)
            np.testing.assert_array_equal(result.link_poses()[link][1], quaternion)

        result.save(tmp_path)
        assert sorted(path.name for path in tmp_path.iterdir()) == ["link_poses.csv", "tracking.json"]
        table = np.genfromtxt(tmp_path / "link_poses.csv", delimiter=",", names=True, deletechars="")
        np.testing.assert_array_equal(table["stamp_ns"], recorded.stamps)
        for link in LINK_NAMES:
            position, quaternion = result.link_poses()[link]
            np.testing.assert_array_equal(np.stack([table[f"{link}.{c}"] for c in "xyz"], axis=1), position)
            np.testing.assert_array_equal(
                np.stack([table[f"{link}.{c}"] for c in ("qw", "qx", "qy", "qz")], axis=1), quaternion
            )

    def test_dynamic_poses_are_in_the_world(self):
        result = replay(standing(0.2))
        position, quaternion = result.link_poses()["base_link"]
        np.testing.assert_array_equal(position, result.motion.base_pose[:, :3])
        np.testing.assert_allclose(quaternion, result.motion.base_pose[:, 3:], atol=1e-15)
        # The centre of the foot's ball is 0.14 m down the leg, and its sole 0.02 m below that, on the ground.
        knee, (_, x, y, _) = result.link_poses()["LF_leg"][0][-1], result.link_poses()["LF_leg"][1][-1]
        assert knee[2] - 0.14 * (1 - 2 * (x * x + y * y)) - 0.02 == pytest.approx(0.0, abs=2e-3)

    def test_error_is_played_minus_recorded_at_the_same_time(self):
        recorded = publish(SinusoidalGait.preset("tuned"), 1.0, 20.0)
        result = replay(recorded)
        error = result.tracking_error()
        expected = [np.interp(result.played.times, recorded.times, column) for column in recorded.positions.T]
        np.testing.assert_allclose(error, result.played.positions - np.transpose(expected), rtol=0, atol=1e-12)
        report = result.report()["tracking_error"]
        knee = report["joints"]["RH_knee_joint"]
        assert knee["rms"] == pytest.approx(np.sqrt((error[:, 7] ** 2).mean()))
        assert knee["max"] == np.abs(error[:, 7]).max() == abs(error[round(knee["max_at"] * 50), 7])
        assert report["all"]["max"] == max(joint["max"] for joint in report["joints"].values())
        assert 0.01 < report["all"]["rms"] < 0.3

    def test_keeps_the_recordings_clock_and_takes_joints_in_any_order(self):
        first = 10**18 + 1
        recorded = standing(0.2)
        late = JointTrajectory(recorded.stamps + first, JOINT_NAMES[::-1], recorded.positions[:, ::-1])
        played, expected = replay(late).played, replay(recorded).played
        np.testing.assert_array_equal(played.stamps, expected.stamps + first)
        np.testing.assert_array_equal(played.positions, expected.positions)

    def test_positions_outside_the_limits_are_named_or_clipped_on_purpose(self):
        positions = np.tile(STANCE, (2, 1))
        positions[1, 3], positions[1, 4] = 0.3, -1.7
        bad = standing(positions=positions)
        message = (
            r"JointTrajectory: row 1, position\.RF_knee_joint: 0\.3 rad at 1 s is outside -2 to 0 rad; "
            r"values outside: 2; clip \(--clip\)"
        )
        for mode in ("kinematic", "dynamic"):
            with pytest.raises(QuadrupedError, match=message):
                replay(bad, mode)
        result = replay(bad, "kinematic", clip=True)
        assert result.played.positions[1, 3:5].tolist() == [0.0, -1.5]
        np.testing.assert_allclose(result.tracking_error()[1, 3:5], [-0.3, 0.2])
        assert result.report()["clipped"] == 2
        assert "2 recorded positions were moved" in result.table()
        positions[1, 5] = -1e200
        with pytest.raises(QuadrupedError, match=r"LH_knee_joint: -1e.200 rad .*too far to clip: mend"):
            replay(standing(positions=positions), clip=True)

    def test_a_joint_at_its_stop_may_be_measured_a_little_beyond(self):
        positions = np.tile(STANCE, (2, 1))
        positions[1, 1] = JOINT_POSITION_HIGH[1] + 0.9 * LIMIT_TOLERANCE
        assert replay(standing(positions=positions), "kinematic").clipped.sum() == 0

    def test_one_row_is_the_start(self):
        result = replay(JointTrajectory([7], JOINT_NAMES, [STANCE]))
        assert result.played.stamps.tolist() == [7]
        assert result.report()["tracking_error"]["all"] == {"rms": 0.0, "max": 0.0}

    def test_a_stamp_from_another_clock_is_named(self):
        stamps = [0, 1_763_500_000_000_000_000, 1_763_500_000_020_000_000]
        with pytest.raises(QuadrupedError, match=r"lasts 1\.7635e.09 s, over 21600 s; its longest gap.*row 1; cut it"):
            replay(standing(stamps=stamps, positions=np.tile(STANCE, (3, 1))))
        assert MAX_SECONDS == 21600

    def test_unknown_mode(self):
        with pytest.raises(QuadrupedError, match="unknown mode 'fast'; valid modes are kinematic, dynamic"):
            replay(standing(), "fast")

    def test_results_are_never_overwritten_unasked(self, tmp_path):
        replay(standing(0.1)).save(tmp_path / "new")
        assert sorted(p.name for p in (tmp_path / "new").iterdir()) == [
            "joint_states.csv",
            "link_poses.csv",
            "tracking.json",
        ]
        with pytest.raises(QuadrupedError, match=r"link_poses\.csv: exists already; name another"):
            replay(standing(0.1)).save(tmp_path / "new")
        replay(standing(0.2)).save(tmp_path / "new", overwrite=True)
        assert json.loads((tmp_path / "new" / "tracking.json").read_text())["seconds"] == 0.2


class TestBaseline:
    def test_numbers_that_make_no_sense(self):
        for arguments, message in {
            ("preset", "gallop"): "unknown preset 'gallop'",
            ("episodes", 0): "episodes: expected 1 or more; found 0",
            ("seed", -1): "seed: expected 0 or more; found -1",
        }.items():
            with pytest.raises(QuadrupedError, match=message):
                run_baseline(**dict([arguments]))

    def test_a_robot_too_short_of_time_for_a_metric_is_reported_all_the_same(self, tmp_path):
        baseline = run_baseline("tuned", seconds=0.1, episodes=2)
        baseline.save(tmp_path / "a.csv")
        report = json.loads((tmp_path / "a.json").read_text())
        assert report["metrics"]["forward_velocity"]["episodes"] == [None, None]
        assert report["metrics"]["fall_rate"]["mean"] == 0.0
        assert "Forward velocity" in baseline.table()

    def test_a_name_that_is_not_a_csv_is_refused_before_the_work(self):
        with pytest.raises(QuadrupedError, match=r"a\.json: end the name in \.csv; found '\.json'"):
            baseline_files(Path("a.json"))

    def test_violations_are_reported(self):
        baseline = run_baseline("tuned", seconds=0.1, episodes=1)
        greedy = SinusoidalGait(2.0, 0.0, 0.1, -0.5, 1.0, (0.0,) * 8)
        table = type(baseline)(**{**vars(baseline), "gait": greedy}).table()
        assert "Asks for more than it can do:\n  LF_hip_joint: -2.000 to 2.000 rad is outside -1.5 to 1.5 rad" in table

    def test_tuned_walks_and_article_hardly_moves(self):
        tuned, article = run_baseline("tuned", episodes=10), run_baseline("article", episodes=10)
        assert tuned.estimate("fall_rate").mean == article.estimate("fall_rate").mean == 0.0
        assert tuned.estimate("forward_velocity").mean > 0.25
        assert abs(article.estimate("forward_velocity").mean) < 0.03


def test_free_path_counts_up(tmp_path):
    path = tmp_path / "a.csv"
    assert free_path(path) == path
    path.touch()
    (tmp_path / "a-2.csv").touch()
    assert free_path(path) == tmp_path / "a-3.csv"
    with pytest.raises(QuadrupedError, match="cannot be written"):
        write_json(path / "b.json", {})


def test_progress_is_quiet_until_it_takes_long(capsys, monkeypatch):
    now = [0.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    line = ProgressLine("playing")
    for now[0], share in ((0.5, 0.1), (2.0, 0.25), (4.0, 0.5), (8.0, 1.0)):
        line(share)
    assert capsys.readouterr().err == "playing:  25%, 6 s left\nplaying: 100%, 0 s left\n"


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

    def test_the_articles_publisher(self, tmp_path):
        arguments = ("--preset", "article", "--rate", "20", "--commands", "--seconds", "2", "--episodes", "1")
        assert run(tmp_path, "baseline.py", *arguments, "--out", "a.csv").returncode == 0
        commands = JointTrajectory.load(tmp_path / "a.csv")
        t = np.arange(41) / 20
        np.testing.assert_allclose(
            commands.positions, SinusoidalGait.preset("article").positions(t), rtol=0, atol=1e-12
        )
        again = run(tmp_path, "baseline.py", *arguments, "--out", "a.csv")
        assert again.returncode == 1
        assert again.stderr.startswith("baseline.py: a.csv: exists already")
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
        assert (done.returncode, done.stdout) == (1, "")
        assert done.stderr.startswith(f"replay.py: {message}")
        assert done.stderr.count("\n") == 1
        assert not (tmp_path / "results").exists()

    @pytest.mark.parametrize("script", ["baseline.py", "replay.py"])
    def test_help_names_every_argument(self, script):
        done = run(".", script, "--help")
        assert done.returncode == 0
        for argument in ("--overwrite", "--out", "joint states", "rad", "last bit"):
            assert argument in done.stdout
