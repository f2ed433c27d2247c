"""The baseline: a scripted gait, recorded and measured."""

import numpy as np
import pytest

from quadruped_env import QuadrupedError, SinusoidalGait
from quadruped_env.evaluation.baseline import run_baseline


class TestBaseline:
    def test_invalid_numbers_are_refused(self):
        for arguments, message in {
            ("preset", "gallop"): "preset must be one of .*'gallop'",
            ("episodes", 0): "episodes: expected 1 or more; found 0",
        }.items():
            with pytest.raises(QuadrupedError, match=message):
                run_baseline(**dict([arguments]))

    def test_a_bag_has_the_base_in_its_odometry_frame(self, tmp_path):
        reader = pytest.importorskip("mcap_ros2.reader")
        baseline = run_baseline("tuned", seconds=1.0, episodes=1)
        baseline.recording.save(tmp_path / "walk.mcap")
        messages = [m.ros_msg for m in reader.read_ros2_messages(str(tmp_path / "walk.mcap"), topics=["/tf"])]
        first, last = (message.transforms[0] for message in (messages[0], messages[-1]))
        assert (last.header.frame_id, last.child_frame_id) == ("odom", "base_link")
        end = baseline.recording.base_pose[-1]
        assert last.transform.translation.x == pytest.approx(end[0], abs=1e-9)
        assert last.transform.rotation.w == pytest.approx(end[3], abs=1e-9)
        assert first.transform.translation.x == pytest.approx(0.0, abs=1e-9)

    def test_violations_are_reported(self):
        baseline = run_baseline("tuned", seconds=0.1, episodes=1)
        greedy = SinusoidalGait(2.0, 0.0, 0.1, -0.5, 1.0, (0.0,) * 8)
        table = type(baseline)(**{**vars(baseline), "gait": greedy}).table()
        assert "targets exceed limits:\n  LF_hip_joint: -2.000 to 2.000 rad is outside -1.5 to 1.5 rad" in table

    def test_measured_speed_beyond_the_limit_is_marked(self):
        baseline = run_baseline("tuned", seconds=2.0, episodes=1)
        for speed, marked in ((5.6, True), (4.9, False)):
            metrics = {**baseline.metrics, "peak_joint_speed": np.array([speed])}
            table = type(baseline)(**{**vars(baseline), "metrics": metrics}).table()
            assert ("5 rad/s, exceeded" in table) is marked
            assert "The joint targets are within the limits.\n" in table

    def test_tuned_walks_and_article_hardly_moves(self):
        tuned, article = (run_baseline(preset, seconds=5.0, episodes=4) for preset in ("tuned", "article"))
        assert tuned.estimate("fall_rate").mean == article.estimate("fall_rate").mean == 0.0
        assert tuned.estimate("forward_velocity").mean > 0.25
        assert tuned.estimate("distance").mean == pytest.approx(tuned.metrics["distance"].mean())
        assert np.ptp(tuned.metrics["distance"]) > 0.0
        assert abs(article.estimate("forward_velocity").mean) < 0.03
