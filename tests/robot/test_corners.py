"""Inverse kinematics of robots with one leg in each corner."""

import numpy as np
import pytest
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
