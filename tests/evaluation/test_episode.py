"""Episodes of one robot: commands published from a gait, and motions recorded and played."""

import numpy as np
import pytest
from built_in import STANCE, STANCE_HEIGHT
from trajectories import assert_same_numbers, standing

from quadruped_env import QuadrupedError, SinusoidalGait
from quadruped_env.evaluation.recorded_episode import play, publish, record
from quadruped_env.policies import GaitController, ZeroController


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
        assert_same_numbers(played.joints, walked.joints)
        np.testing.assert_array_equal(played.base_pose, walked.base_pose)

    def test_reports_when_the_robot_fell_and_continues(self):
        # Legs swung back as far as they go: it lands on its belly.
        flat = np.tile([1.5, 0.0], 4)
        recording = play(standing(3.0, positions=np.stack([STANCE, flat]), stamps=[0, 1_000_000_000]))
        assert 0.0 < recording.fell_at <= 1.0
        assert len(recording.joints) == 51
        assert f"fell at {recording.fell_at:.2f} s" in recording.outcome()

    def test_robot_that_sits_tilted_did_not_stay_on_its_feet(self):
        # Fore legs straight, hind legs folded: its tail is low.
        sitting = np.array([0.3, -0.1, 0.3, -0.1, 0.5, -1.8, 0.5, -1.8])
        positions = np.stack([STANCE, sitting, sitting])
        recording = play(standing(positions=positions, stamps=[0, 1_000_000_000, 4_000_000_000]))
        assert recording.fell_at is None
        assert "the robot did not fall, but was tilted by more than 17 degrees for 3." in recording.outcome()
        assert "(up to 27 degrees) and got" in recording.outcome()
        assert not recording.stayed_on_its_feet
