"""Rollouts: contact and slip against readings and an independent computation."""

import numpy as np

from quadruped_env.evaluation import rollout
from quadruped_env.policies import CommandedGaitController
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig, quantities


def test_slip_speed_is_that_of_the_lowest_point_of_each_foot_on_the_ground(monkeypatch):
    read = []

    def sliding_squared(velocity, angular_velocity, radius):
        read.append((velocity.copy(), angular_velocity.copy()))
        return quantities.sliding_squared(velocity, angular_velocity, radius)

    monkeypatch.setattr(rollout, "sliding_squared", sliding_squared)
    walked = rollout.roll_out(CommandedGaitController(), [(0.3, 0.2)], [rollout.FIRST_SEED], 1.0)
    velocity, angular_velocity = (np.array(values) for values in zip(*read, strict=True))
    # The lowest point of a ball moves with the ball's centre and with its rotation.
    lowest = velocity + np.cross(angular_velocity, [0.0, 0.0, -MINI_QUADRUPED.foot_radius])
    expected = np.hypot(lowest[..., 0], lowest[..., 1]) * walked.contact
    assert np.ptp(expected) > 0.05, "feet slide, and feet are in the air"
    np.testing.assert_allclose(walked.slip_speed, expected, rtol=1e-4, atol=1e-6)


def test_contact_is_a_force_beyond_the_threshold():
    stands = TaskConfig().without_randomization()
    standing = rollout.roll_out(CommandedGaitController(), [(0.0, 0.0)], [rollout.FIRST_SEED], 1.0, stands)
    assert standing.contact.all(axis=-1)[25:].all(), "after it has come down"
    walking = rollout.roll_out(CommandedGaitController(), [(0.3, 0.0)], [rollout.FIRST_SEED], 2.0, stands)
    in_the_air = walking.foot_height > 0.003
    assert in_the_air.any()
    assert not walking.contact[in_the_air].any()
