import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from paths import DYNA1, ROOT

from quadruped_env import (
    JOINT_NAMES,
    JointTrajectory,
    QuadrupedError,
    SinusoidalGait,
    asset_path,
    forward_kinematics,
)
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.evaluation.baseline import check_target, run_baseline
from quadruped_env.evaluation.episode import MAX_SECONDS, play, publish, record
from quadruped_env.files import free_path, write_json
from quadruped_env.gait import PRESETS
from quadruped_env.policies import GaitController, ZeroController
from quadruped_env.replay import replay as replaying
from quadruped_env.replay.replay import LIMIT_TOLERANCE, replay
from quadruped_env.replay.saturation import saturation
from quadruped_env.replay.signal_comparison import lag
from quadruped_env.robot import (
    JOINT_POSITION_HIGH,
    LINK_NAMES,
    STANCE,
    STANCE_HEIGHT,
    JointMotor,
    MotorConfig,
    sole_heights,
)

EVALUATE = ROOT / "evaluate"


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
    def test_invalid_numbers_are_refused(self, seconds, rate, message):
        with pytest.raises(QuadrupedError, match=message):
            publish(SinusoidalGait.preset("article"), seconds, rate)


class TestRecord:
    def test_begins_with_the_start_and_has_one_row_per_control_step(self):
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

    def test_reports_when_the_robot_fell_and_continues(self):
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

    def test_positions_outside_the_limits_are_named_or_clipped_on_request(self):
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
        with pytest.raises(QuadrupedError, match=r"LH_knee_joint: -1e.200 rad .*too far to clip: fix"):
            replay(standing(positions=positions), clip=True)

    def test_a_joint_at_its_stop_may_be_measured_a_little_beyond(self):
        positions = np.tile(STANCE, (2, 1))
        positions[1, 1] = JOINT_POSITION_HIGH[1] + 0.9 * LIMIT_TOLERANCE
        assert replay(standing(positions=positions), "kinematic").clipped.sum() == 0

    def test_it_starts_in_the_first_pose_on_its_feet(self):
        """Of a gait, three or four feet are on the ground, none is below it, and nothing jumps at the start."""
        for preset in PRESETS:
            commands = publish(SinusoidalGait.preset(preset), 0.2, 50.0)
            result = replay(commands)
            np.testing.assert_array_equal(result.played.positions[0], commands.positions[0])
            soles = sole_heights(commands.positions[0], result.motion.base_pose[0])
            assert soles.min() == pytest.approx(0.0, abs=1e-12)
            assert (soles < 1e-9).sum() >= 3
            assert result.report()["motion"]["feet_on_ground_at_start"] >= 3
            assert np.abs(np.diff(result.motion.base_pose[:3, 2])).max() < 2e-3

    def test_requests_beyond_the_motors_are_reported_as_saturation(self):
        """A step of 1 rad asks for more than a motor has: kp times the step is 40 N m."""
        positions = np.tile(STANCE, (4, 1))
        positions[2:, 6] = STANCE[6] + 0.5
        stamps = np.array([0, 400, 401, 800]) * 1_000_000
        result = replay(standing(stamps=stamps, positions=positions))
        report = result.report()["limits"]
        hip = report["RH_hip_joint"]
        assert hip["saturated"]["share"] > 0.0
        assert hip["saturated"]["first_at"] == pytest.approx(0.42, abs=0.021)
        assert hip["saturated"]["largest_torque_asked"] > 10.0
        assert hip["largest_torque"] <= 10.0 + 1e-9
        assert hip["fastest_recorded"] > 5.0
        assert "Recorded faster than the motors' 5 rad/s: RH_hip_joint." in result.remarks()
        assert report["LF_knee_joint"]["saturated"] == {
            "share": 0.0,
            "largest_torque_asked": pytest.approx(report["LF_knee_joint"]["saturated"]["largest_torque_asked"]),
            "first_at": None,
        }

    def test_requested_torque_and_its_excess_by_hand(self):
        """By hand: kp 40, kd 1; at 2 rad/s forwards a motor has 10 - 2 * 2 = 6 N m left, and 10 N m to brake with."""
        stamps = np.array([0, 20, 40, 60]) * 1_000_000
        positions, velocities = np.zeros((2, 4, 8))
        positions[:, 1::2] = -1.0
        velocities[2:, 0] = 2.0
        targets = positions.copy()
        targets[1:3, 0] = 0.1, -0.4
        target, played = (JointTrajectory(stamps, JOINT_NAMES, p, velocities) for p in (targets, positions))
        found = saturation(target, played, MotorConfig())
        # A target acts over the step that follows it.
        np.testing.assert_allclose(found.asked[:, 0], [0.0, 0.0, 0.1 * 40 - 2.0, -0.4 * 40 - 2.0])
        np.testing.assert_allclose(found.excess[:, 0], [0.0, 0.0, 0.0, 8.0])
        late = saturation(target, played, MotorConfig(delay=0.02))
        np.testing.assert_allclose(late.asked[:, 0], [0.0, 0.0, -2.0, 0.1 * 40 - 2.0])
        targets[1, 0] = 0.3
        pulled = saturation(JointTrajectory(stamps, JOINT_NAMES, targets), played, MotorConfig())
        assert pulled.excess[2, 0] == pytest.approx(0.3 * 40 - 2.0 - 6.0)

    def test_lag_is_the_known_delay(self):
        times = np.arange(0, 4, 0.02)
        target = JointTrajectory(np.rint(times * 1e9).astype(int), JOINT_NAMES, np.sin(3 * times)[:, None] * np.ones(8))
        late = JointTrajectory(target.stamps, JOINT_NAMES, target.positions_at(times - 0.06))
        assert lag(target, late) == [pytest.approx(0.06, abs=2e-3)] * 8
        assert lag(standing(4.0), standing(4.0)) == [None] * 8

    def test_gaps_are_reported(self):
        stamps = np.array([0, 20, 40, 60, 640, 660]) * 1_000_000
        result = replay(standing(stamps=stamps, positions=np.tile(STANCE, (6, 1))), "kinematic")
        assert result.report()["gaps"] == [{"start": 0.06, "seconds": 0.58}]
        assert "1 gaps in the recording, the longest of 0.58 s at 0.06 s" in result.table()

    def test_other_motors(self):
        weak = JointMotor(stall_torque=0.5)
        commands = publish(SinusoidalGait.preset("tuned"), 0.5, 50.0)
        result = replay(commands, motors=MotorConfig(hip=weak, knee=weak))
        assert np.abs(result.played.efforts).max() <= 0.5 + 1e-9
        assert result.saturation().report()["LF_knee_joint"]["share"] > 0.3

    def test_recorded_against_simulated(self):
        commands = publish(SinusoidalGait.preset("tuned"), 1.0, 50.0)
        truth = play(commands).joints
        offset = JointTrajectory(truth.stamps, JOINT_NAMES, truth.positions - 0.1, truth.velocities, truth.efforts * 2)
        found = replay(commands, measured=offset).comparison().report()
        for name in JOINT_NAMES:
            assert found["positions"]["joints"][name] == pytest.approx(
                {"rms": 0.1, "mean": 0.1, "max": 0.1, "correlation": 1.0}
            )
            assert found["velocities"]["joints"][name]["rms"] == 0.0
            assert found["efforts"]["joints"][name]["correlation"] == pytest.approx(1.0)
        positions_only = JointTrajectory(truth.stamps, JOINT_NAMES, truth.positions)
        signals = replay(commands, measured=positions_only).comparison()
        assert list(signals.recorded) == ["positions", "velocities"]
        assert "computed from its positions" in signals.table()
        later = JointTrajectory(truth.stamps + 10**12, JOINT_NAMES, truth.positions)
        with pytest.raises(QuadrupedError, match="compare recordings from the same clock"):
            replay(commands, measured=later).comparison()

    def test_replay_asked_for_its_results_several_times_computes_them_once(self, tmp_path, monkeypatch):
        calls = []
        for name in ("lag", "side_by_side", "saturation"):
            function = getattr(replaying, name)
            monkeypatch.setattr(replaying, name, lambda *args, f=function, n=name: calls.append(n) or f(*args))
        result = replay(standing())
        for _ in range(2):
            result.table()
            result.comparison().table()
        result.save(tmp_path, compare=True)
        assert sorted(calls) == ["lag", "saturation", "side_by_side"]
        assert json.loads((tmp_path / "tracking.json").read_text())["limits"] == result.report()["limits"]

    def test_one_row_is_the_start(self):
        result = replay(JointTrajectory([7], JOINT_NAMES, [STANCE]))
        assert result.played.stamps.tolist() == [7]
        assert result.report()["tracking_error"]["all"] == {"rms": 0.0, "max": 0.0}

    def test_timestamp_from_another_clock_is_named(self):
        stamps = [0, 1_763_500_000_000_000_000, 1_763_500_000_020_000_000]
        with pytest.raises(QuadrupedError, match=r"lasts 1\.7635e.09 s, over 21600 s; its longest gap.*row 1; cut it"):
            replay(standing(stamps=stamps, positions=np.tile(STANCE, (3, 1))))
        assert MAX_SECONDS == 21600

    def test_unknown_mode(self):
        with pytest.raises(QuadrupedError, match="unknown mode 'fast'; valid modes are kinematic, dynamic"):
            replay(standing(), "fast")

    def test_existing_results_without_overwrite_are_kept(self, tmp_path):
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
    def test_invalid_numbers_are_refused(self):
        for arguments, message in {
            ("preset", "gallop"): "unknown preset 'gallop'",
            ("episodes", 0): "episodes: expected 1 or more; found 0",
            ("seed", -1): "seed: expected 0 or more; found -1",
        }.items():
            with pytest.raises(QuadrupedError, match=message):
                run_baseline(**dict([arguments]))

    def test_run_too_short_for_a_metric_is_still_reported(self, tmp_path):
        baseline = run_baseline("tuned", seconds=0.1, episodes=2)
        baseline.save(tmp_path / "a.csv")
        report = json.loads((tmp_path / "a.json").read_text())
        assert report["metrics"]["forward_velocity"]["episodes"] == [None, None]
        assert report["metrics"]["fall_rate"]["mean"] == 0.0
        assert "Forward velocity" in baseline.table()

    def test_unknown_file_format_is_refused_before_the_simulation(self):
        with pytest.raises(QuadrupedError, match=r"a\.json: unknown ending '\.json'"):
            check_target(Path("a.json"), overwrite=False)

    def test_a_bag_has_the_base_in_its_odometry_frame(self, tmp_path):
        reader = pytest.importorskip("mcap_ros2.reader")
        baseline = run_baseline("tuned", seconds=1.0, episodes=1)
        baseline.save(tmp_path / "walk.mcap")
        assert (tmp_path / "walk.json").exists()
        messages = [m.ros_msg for m in reader.read_ros2_messages(str(tmp_path / "walk.mcap"), topics=["/tf"])]
        first, last = (message.transforms[0] for message in (messages[0], messages[-1]))
        assert (last.header.frame_id, last.child_frame_id) == ("odom", "base_link")
        end = baseline.recording.base_pose[-1]
        assert last.transform.translation.x == pytest.approx(end[0], abs=1e-9)
        assert last.transform.rotation.w == pytest.approx(end[3], abs=1e-9)
        assert first.transform.translation.x == pytest.approx(0.0, abs=1e-9)
        check_target(tmp_path / "other", overwrite=False)
        with pytest.raises(QuadrupedError, match="exists already"):
            check_target(tmp_path / "walk.mcap", overwrite=False)

    def test_violations_are_reported(self):
        baseline = run_baseline("tuned", seconds=0.1, episodes=1)
        greedy = SinusoidalGait(2.0, 0.0, 0.1, -0.5, 1.0, (0.0,) * 8)
        table = type(baseline)(**{**vars(baseline), "gait": greedy}).table()
        assert "Exceeds the joint limits:\n  LF_hip_joint: -2.000 to 2.000 rad is outside -1.5 to 1.5 rad" in table

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
    assert capsys.readouterr().err == "playing:  25%, 8 s left\nplaying: 100%, 0 s left\n"


def test_progress_estimates_from_the_first_step_and_not_from_what_came_before(capsys, monkeypatch):
    now = [0.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    line = ProgressLine("filming")
    # Ten seconds of plots, then a second for every twentieth of the film.
    for number in range(1, 5):
        now[0] = 10.0 + number
        line(number / 20)
    assert capsys.readouterr().err == "filming:  10%, 18 s left\n"


def test_progress_starts_again_with_the_next_piece_of_work(capsys, monkeypatch):
    now = [0.0]
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    line = ProgressLine("filming")
    for now[0], share in ((0.0, 0.5), (0.5, 1.0), (20.0, 0.1), (22.0, 0.3)):
        line(share)
    assert capsys.readouterr().err == "filming:  30%, 7 s left\n"


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
        assert done.stderr == "replay.py: warning: did.csv: left out joints that this robot does not have: tail_joint\n"
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
        assert again.stderr.startswith("baseline.py: error: a.csv: exists already")
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
        assert done.stderr.startswith(f"replay.py: error: {message}")
        assert done.stderr.count("\n") == 1
        assert not (tmp_path / "results").exists()

    @pytest.mark.parametrize("script", ["baseline.py", "replay.py"])
    def test_help_names_every_argument(self, script):
        done = run(".", script, "--help")
        assert done.returncode == 0
        for argument in ("--overwrite", "--output", "joint states", "rad", "last bit"):
            assert argument in done.stdout
