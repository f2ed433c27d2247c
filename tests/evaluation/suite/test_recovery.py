"""Recovery of limp robots: starts by hand, and robots that must and that cannot recover."""

import math
from dataclasses import replace

import numpy as np
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.evaluation.suite import recovery
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import Release, full_suite
from quadruped_env.policies import ZeroController
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig
from quadruped_env.utils import rotations

PART = full_suite().recovery
STANDING = MeasuredController("standing", ZeroController(), TaskConfig())


def test_start_poses_have_their_height_tilt_and_joints():
    poses = recovery.start_poses(MINI_QUADRUPED, Release("tilted", 0.3, 60.0, True), range(5, 45))
    np.testing.assert_allclose(poses[:, :3], np.tile([0.0, 0.0, 0.3], (40, 1)))
    np.testing.assert_allclose(rotations.tilt(poses[:, 3:7]), math.radians(60.0))
    up = rotations.up_in_body(poses[:, 3:7])
    assert np.ptp(np.arctan2(up[:, 1], up[:, 0])) > math.pi  # it falls to all sides
    assert np.ptp(rotations.yaw(poses[:, 3:7])) > math.pi
    joints = poses[:, 7:]
    assert ((joints >= MINI_QUADRUPED.joint_position_low) & (joints <= MINI_QUADRUPED.joint_position_high)).all()
    assert (joints.std(axis=0) > 0.1).all()
    np.testing.assert_array_equal(
        poses[1:], recovery.start_poses(MINI_QUADRUPED, Release("again", 0.3, 60.0, True), range(6, 45))
    )
    stance = recovery.start_poses(MINI_QUADRUPED, Release("drop", 0.5, 0.0, False), range(2))
    np.testing.assert_allclose(stance[:, 7:], np.tile(MINI_QUADRUPED.stance, (2, 1)))
    np.testing.assert_allclose(rotations.tilt(stance[:, 3:7]), 0.0, atol=1e-7)


def test_a_robot_on_its_feet_recovers_and_one_on_its_back_does_not():
    part = replace(PART, limp_seconds=0.1, seconds=14.0, num_seeds=1, walk_seconds=1.0)
    feet = np.concatenate([MINI_QUADRUPED.resting_pose(MINI_QUADRUPED.stance), MINI_QUADRUPED.stance])
    back = feet.copy()
    back[2], back[3:7] = 0.2, [0.0, 1.0, 0.0, 0.0]
    times = recovery.recover(part, STANDING, np.array([feet, back]))
    # 20 states at rest, a ramp of at least 1 s, and 0.5 s in the stance.
    assert 1.5 < times[0] < 13.0
    assert math.isnan(times[1])


def test_time_on_the_feet_must_be_unbroken(monkeypatch):
    """A robot that is thrown over half a second after it got on its feet has not recovered."""
    part = replace(PART, limp_seconds=0.1, seconds=14.0, num_seeds=1, walk_seconds=1.0)
    feet = np.concatenate([MINI_QUADRUPED.resting_pose(MINI_QUADRUPED.stance), MINI_QUADRUPED.stance])[None]
    undisturbed = recovery.recover(part, STANDING, feet)[0]
    steps, act = [], recovery._act

    def throw(robots, simulation, *others):
        act(robots, simulation, *others)
        steps.append(1)
        if len(steps) == round((undisturbed + 0.5) / 0.02):
            simulation.push(np.array([0]), np.array([[0.0, 4.0, 1.0]]))

    monkeypatch.setattr(recovery, "_act", throw)
    assert math.isnan(recovery.recover(part, STANDING, feet)[0])


def test_summary_counts_recoveries_and_averages_their_times(monkeypatch):
    part = replace(PART, num_seeds=2, releases=PART.releases[:2])
    monkeypatch.setattr(recovery, "recover", lambda *_: np.array([2.0, 4.0, np.nan, 5.0]))
    result = recovery.run(part, STANDING)
    assert result["drop_10cm"]["recovered"]["mean"] == 1.0
    assert result["drop_10cm"]["time"]["mean"] == pytest.approx(3.0)
    assert result["drop_30cm"]["recovered"]["mean"] == 0.5
    assert (result["drop_30cm"]["time"]["mean"], result["drop_30cm"]["time"]["count"]) == (5.0, 1)


def test_a_controller_that_no_robot_can_run_recovers_nowhere_for_a_reason(monkeypatch):
    def refuse(*_, **__):
        raise QuadrupedError("policy: it observes foot_force, which the robot does not measure")

    monkeypatch.setattr(recovery, "LiveController", refuse)
    result = recovery.run(replace(PART, num_seeds=2, releases=PART.releases[:2]), STANDING)
    for release in result.values():
        assert (release["recovered"]["mean"], release["time"]["mean"]) == (0.0, None)
        assert release["refused"] == "policy: it observes foot_force, which the robot does not measure"
