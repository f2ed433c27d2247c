"""Replays of recordings, kinematic and dynamic, and their reports."""

import json

import numpy as np
import pytest
from grounds import platform, slope
from trajectories import assert_same_numbers, standing

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError, SinusoidalGait, forward_kinematics
from quadruped_env.evaluation.baseline import run_baseline
from quadruped_env.evaluation.recorded_episode import MAX_SECONDS, play, publish
from quadruped_env.gait import PRESETS
from quadruped_env.replay import replay as replaying
from quadruped_env.replay import replay_report
from quadruped_env.replay.replay import LIMIT_TOLERANCE, replay
from quadruped_env.replay.signal_comparison import comparison_report, lag, saturation, side_by_side
from quadruped_env.robot import JOINT_KINDS, MINI_QUADRUPED, JointMotor, MotorConfig

STANCE = MINI_QUADRUPED.stance


class TestReplay:
    @pytest.mark.parametrize("preset", ["article", "trot", "tuned"])
    @pytest.mark.parametrize("rate", [20.0, 50.0])
    def test_commands_give_the_motion_of_the_baseline(self, tmp_path, preset, rate):
        baseline = run_baseline(preset, seconds=1.0, rate=rate, episodes=1)
        baseline.commands.save(tmp_path / "a.csv")
        again = replay(JointTrajectory.load(tmp_path / "a.csv"))
        assert_same_numbers(again.played, baseline.recording.joints)
        np.testing.assert_array_equal(again.motion.base_pose, baseline.recording.base_pose)

    @pytest.mark.parametrize("ground", ["hills", slope.variant(angle=0.1)], ids=["hills", "slope"])
    def test_commands_on_a_terrain_give_the_motion_of_the_baseline_there(self, ground):
        baseline = run_baseline("tuned", seconds=2.0, episodes=1, terrain=ground)
        again = replay(baseline.commands, terrain=ground)
        assert_same_numbers(again.played, baseline.recording.joints)
        np.testing.assert_array_equal(again.motion.base_pose, baseline.recording.base_pose)
        assert again.motion.terrain == baseline.recording.terrain
        assert again.report["motion"]["terrain"] == again.motion.terrain.name
        level = replay(baseline.commands)
        assert not np.array_equal(level.motion.base_pose, again.motion.base_pose)
        assert level.report["motion"]["terrain"] == "flat"

    def test_feet_at_the_start_are_counted_over_the_ground_below_them(self):
        raised = replay(standing(0.1), terrain=platform)
        assert raised.motion.base_pose[0, 2] == pytest.approx(MINI_QUADRUPED.stance_height + 0.05, abs=1e-6)
        assert raised.report["motion"]["feet_on_ground_at_start"] == 4
        sloping = replay(standing(0.1), terrain=slope.variant(angle=0.3))
        assert sloping.report["motion"]["feet_on_ground_at_start"] == 0

    def test_terrain_of_a_kinematic_replay_is_refused(self):
        with pytest.raises(QuadrupedError, match="kinematic mode has no ground; leave the terrain out"):
            replay(standing(0.1), "kinematic", terrain="rough")
        with pytest.raises(QuadrupedError, match="terrain: 'swamp' is unknown; there are flat, rough, hills"):
            replay(standing(0.1), terrain="swamp")

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
        for link in MINI_QUADRUPED.link_names:
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
        report = result.report["tracking_error"]
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

    def test_positions_outside_the_limits_are_played_at_the_limit_and_said(self):
        positions = np.tile(STANCE, (2, 1))
        positions[1, 3], positions[1, 4] = 0.3, -1.7
        result = replay(standing(positions=positions), "kinematic")
        assert result.played.positions[1, 3:5].tolist() == [0.0, -1.5]
        np.testing.assert_allclose(result.tracking_error()[1, 3:5], [-0.3, 0.2])
        assert result.report["clipped"] == 2
        words = "2 recorded positions were moved to a joint's limit, first at 1.00 s: RF_knee_joint, LH_hip_joint."
        assert words in result.text()
        positions[1, 5] = -1e200
        with pytest.raises(QuadrupedError, match=r"row 1, position\.LH_knee_joint: -1e.200 rad at 1 s is far outside"):
            replay(standing(positions=positions))

    def test_a_joint_at_its_stop_may_be_measured_a_little_beyond(self):
        positions = np.tile(STANCE, (2, 1))
        positions[1, 1] = MINI_QUADRUPED.joint_position_high[1] + 0.9 * LIMIT_TOLERANCE
        assert replay(standing(positions=positions), "kinematic").clipped.sum() == 0

    def test_it_starts_in_the_first_pose_on_its_feet(self):
        """Of a gait, three or four feet are on the ground, none is below it, and nothing jumps at the start."""
        for preset in PRESETS:
            commands = publish(SinusoidalGait.preset(preset), 0.2, 50.0)
            result = replay(commands)
            np.testing.assert_array_equal(result.played.positions[0], commands.positions[0])
            soles = MINI_QUADRUPED.sole_heights(commands.positions[0], result.motion.base_pose[0])
            assert soles.min() == pytest.approx(0.0, abs=1e-12)
            assert (soles < 1e-9).sum() >= 3
            assert result.report["motion"]["feet_on_ground_at_start"] >= 3
            assert np.abs(np.diff(result.motion.base_pose[:3, 2])).max() < 2e-3

    def test_requests_beyond_the_motors_are_reported_as_saturation(self):
        """A step of 1 rad requests more torque than a motor has: kp times the step is 40 N m."""
        positions = np.tile(STANCE, (4, 1))
        positions[2:, 6] = STANCE[6] + 0.5
        stamps = np.array([0, 400, 401, 800]) * 1_000_000
        result = replay(standing(stamps=stamps, positions=positions))
        report = result.report["limits"]
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
        asked, excess = saturation(target, played, MotorConfig(), JOINT_KINDS * 4)
        # A target acts over the step that follows it.
        np.testing.assert_allclose(asked[:, 0], [0.0, 0.0, 0.1 * 40 - 2.0, -0.4 * 40 - 2.0])
        np.testing.assert_allclose(excess[:, 0], [0.0, 0.0, 0.0, 8.0])
        late, _ = saturation(target, played, MotorConfig(delay=0.02), JOINT_KINDS * 4)
        np.testing.assert_allclose(late[:, 0], [0.0, 0.0, -2.0, 0.1 * 40 - 2.0])
        targets[1, 0] = 0.3
        _, excess = saturation(JointTrajectory(stamps, JOINT_NAMES, targets), played, MotorConfig(), JOINT_KINDS * 4)
        assert excess[2, 0] == pytest.approx(0.3 * 40 - 2.0 - 6.0)

    def test_lag_is_the_known_delay(self):
        times = np.arange(0, 4, 0.02)
        target = JointTrajectory(np.rint(times * 1e9).astype(int), JOINT_NAMES, np.sin(3 * times)[:, None] * np.ones(8))
        late = JointTrajectory(target.stamps, JOINT_NAMES, target.positions_at(times - 0.06))
        assert lag(target, late) == [pytest.approx(0.06, abs=2e-3)] * 8
        assert lag(standing(4.0), standing(4.0)) == [None] * 8

    @pytest.mark.parametrize(("frequency", "share"), [(2.6, 0.05), (4.0, 0.3), (9.0, 0.8)])
    def test_lag_of_a_repeated_motion_is_the_first_that_fits(self, frequency, share):
        times = np.arange(0, 6, 0.01)
        delay = share / frequency
        noise = np.random.default_rng(0).normal(0.0, 0.002, (len(times), 8))
        angle = 2 * np.pi * frequency * times[:, None]
        target = JointTrajectory(np.rint(times * 1e9).astype(int), JOINT_NAMES, 0.2 * np.sin(angle) * np.ones(8))
        late = 0.2 * np.sin(angle - 2 * np.pi * share) + noise
        assert lag(target, JointTrajectory(target.stamps, JOINT_NAMES, late)) == [pytest.approx(delay, abs=3e-3)] * 8

    def test_lag_of_a_motion_that_does_not_repeat_is_the_best_fit_alone(self):
        times = np.arange(0, 6, 0.02)
        rng = np.random.default_rng(1)
        steps = np.repeat(rng.uniform(-0.2, 0.2, (30, 8)), 10, axis=0)
        target = JointTrajectory(np.rint(times * 1e9).astype(int), JOINT_NAMES, steps)
        late = JointTrajectory(target.stamps, JOINT_NAMES, target.positions_at(times - 0.3))
        assert lag(target, late) == [pytest.approx(0.3, abs=2e-3)] * 8

    def test_gaps_are_reported(self):
        stamps = np.array([0, 20, 40, 60, 640, 660]) * 1_000_000
        result = replay(standing(stamps=stamps, positions=np.tile(STANCE, (6, 1))), "kinematic")
        assert result.report["gaps"] == [{"start": 0.06, "seconds": 0.58}]
        assert "1 gaps in the recording, the longest of 0.58 s at 0.06 s" in result.text()

    def test_other_motors(self):
        weak = JointMotor(stall_torque=0.5)
        commands = publish(SinusoidalGait.preset("tuned"), 0.5, 50.0)
        result = replay(commands, motors=MotorConfig(hip=weak, knee=weak))
        assert np.abs(result.played.efforts).max() <= 0.5 + 1e-9
        assert result.report["limits"]["LF_knee_joint"]["saturated"]["share"] > 0.3

    def test_recorded_against_simulated(self, monkeypatch):
        commands = publish(SinusoidalGait.preset("tuned"), 1.0, 50.0)
        truth = play(commands).joints
        offset = JointTrajectory(truth.stamps, JOINT_NAMES, truth.positions - 0.1, truth.velocities, truth.efforts * 2)
        found = comparison_report(*replay(commands, measured=offset).comparison)
        for name in JOINT_NAMES:
            assert found["positions"]["joints"][name] == pytest.approx(
                {"rms": 0.1, "mean": 0.1, "max": 0.1, "correlation": 1.0}
            )
            assert found["velocities"]["joints"][name]["rms"] == 0.0
            assert found["efforts"]["joints"][name]["correlation"] == pytest.approx(1.0)
        positions_only = JointTrajectory(truth.stamps, JOINT_NAMES, truth.positions)
        result = replay(commands, measured=positions_only)
        assert list(comparison_report(*result.comparison)) == ["positions", "velocities"]
        assert "computed from its positions" in result.text(compare=True)
        part = replay(commands, measured=truth.slice(0.3, 0.7))
        recorded, simulated = part.comparison
        assert recorded.stamps.tolist() == simulated.stamps.tolist() == truth.stamps[15:35].tolist()
        plotted = []
        monkeypatch.setattr(
            replay_report, "joint_panels", lambda _, lines, *__: plotted.append(lines["recorded"].times)
        )
        monkeypatch.setattr(replay_report, "figure", lambda *_: {})
        replay_report._comparison_figures(part)
        np.testing.assert_allclose(plotted[0], truth.times[15:35])
        later = JointTrajectory(truth.stamps + 10**12, JOINT_NAMES, truth.positions)
        with pytest.raises(QuadrupedError, match="compare recordings from the same clock"):
            _ = replay(commands, measured=later).comparison

    @pytest.mark.parametrize("still", ["positions", "played", "both"])
    def test_correlation_with_a_joint_that_does_not_move_is_unknown_and_not_perfect(self, still):
        wave = np.sin(np.arange(50) / 5.0)[:, None] * np.ones(8)
        rest = np.full((50, 8), 0.3)
        stamps = np.arange(50) * 20_000_000
        recorded = JointTrajectory(stamps, JOINT_NAMES, wave if still == "played" else rest)
        played = JointTrajectory(stamps, JOINT_NAMES, wave if still == "positions" else rest)
        found = comparison_report(*side_by_side(recorded, played))["positions"]["joints"]["LF_hip_joint"]
        assert found["correlation"] is None
        assert found["rms"] == (0.0 if still == "both" else pytest.approx(np.sqrt(np.mean((wave[:, 0] - 0.3) ** 2))))

    def test_replay_asked_for_its_results_several_times_computes_them_once(self, tmp_path, monkeypatch):
        calls = []
        for name in ("lag", "side_by_side", "saturation"):
            function = getattr(replaying, name)
            monkeypatch.setattr(replaying, name, lambda *args, f=function, n=name: calls.append(n) or f(*args))
        result = replay(standing())
        for _ in range(2):
            result.text(compare=True)
        result.save(tmp_path, compare=True)
        assert sorted(calls) == ["lag", "saturation", "side_by_side"]
        assert json.loads((tmp_path / "tracking.json").read_text())["limits"] == result.report["limits"]

    def test_timestamp_from_another_clock_is_named(self):
        stamps = [0, 1_763_500_000_000_000_000, 1_763_500_000_020_000_000]
        with pytest.raises(QuadrupedError, match=r"lasts 1\.7635e.09 s, over 21600 s; its longest gap.*row 1; cut it"):
            replay(standing(stamps=stamps, positions=np.tile(STANCE, (3, 1))))
        assert MAX_SECONDS == 21600

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
