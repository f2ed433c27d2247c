"""Inverse kinematics of robots with one leg in each corner."""

import numpy as np
import pytest
import twelve_joints
from second_robot import ROBOT

from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.corners import postures_with_feet_at

ROBOTS = pytest.mark.parametrize("robot", [MINI_QUADRUPED, ROBOT], ids=["built-in", "second"])


@ROBOTS
def test_feet_within_reach_are_where_they_were_asked_to_be(robot):
    rng = np.random.default_rng(0)
    postures = robot.stance + rng.uniform(-0.4, 0.4, (50, 8))
    feet = robot.skeleton.foot_centres(np.clip(postures, robot.joint_position_low, robot.joint_position_high))
    found = postures_with_feet_at(robot, feet)
    assert found.shape == (50, 8)
    np.testing.assert_allclose(robot.skeleton.foot_centres(found), feet, atol=1e-6)


@ROBOTS
def test_a_foot_out_of_reach_gets_near_with_joints_in_their_ranges(robot):
    """A leg that reaches down is straight at its end: the foot is as far down as it can be."""
    feet = robot.skeleton.foot_centres(robot.stance)[None].repeat(2, axis=0)
    feet[1, 0, 2] -= 0.1
    found = postures_with_feet_at(robot, feet)
    np.testing.assert_allclose(found[0], robot.stance, atol=1e-9)
    assert np.isfinite(found).all()
    assert (found >= robot.joint_position_low).all()
    assert (found <= robot.joint_position_high).all()
    other_legs = [joint for joint in range(8) if joint // 2 != 0]
    np.testing.assert_allclose(found[1, other_legs], robot.stance[other_legs], atol=1e-9)
    reached = robot.skeleton.foot_centres(found[1])[0, 2]
    assert reached < robot.skeleton.foot_centres(robot.stance)[0, 2] - 0.005


def test_a_joint_at_its_limit_leaves_the_rest_to_the_others():
    """The foot can rise no farther forward than the hip's range allows, and the knee takes what it can."""
    hip = ROBOT.skeleton.joint_frames(ROBOT.stance)[0][0]
    feet = ROBOT.skeleton.foot_centres(ROBOT.stance)[None].copy()
    feet[0, 0, [0, 2]] = hip[[0, 2]] + [-0.21, 0.0]
    found = postures_with_feet_at(ROBOT, feet)
    assert found[0, 0] == ROBOT.joint_position_high[0]
    directions = np.linspace(ROBOT.joint_position_low[1], ROBOT.joint_position_high[1], 500)
    others = np.tile(found, (500, 1))
    others[:, 1] = directions
    distances = np.linalg.norm(ROBOT.skeleton.foot_centres(others)[:, 0] - feet[0, 0], axis=1)
    assert np.linalg.norm(ROBOT.skeleton.foot_centres(found)[0, 0] - feet[0, 0]) <= distances.min() + 1e-4


def test_feet_of_three_joints_are_where_they_were_asked_to_be_in_all_directions():
    robot = twelve_joints.robot()
    rng = np.random.default_rng(0)
    postures = robot.stance + rng.uniform(-0.4, 0.4, (50, 12))
    feet = robot.skeleton.foot_centres(np.clip(postures, robot.joint_position_low, robot.joint_position_high))
    found = postures_with_feet_at(robot, feet)
    np.testing.assert_allclose(robot.skeleton.foot_centres(found), feet, atol=1e-6)
    assert np.ptp(feet[..., 1], axis=0).min() > 0.1
