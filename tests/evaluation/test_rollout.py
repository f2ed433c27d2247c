"""Rollouts: contact and slip against readings and an independent computation."""

import numpy as np

from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
from quadruped_env.policies import CommandedGaitController
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import Task, TaskConfig


def test_slip_is_the_speed_of_the_lowest_point_of_each_foot(monkeypatch):
    read, act = [], Task.act

    def acted(self, *arguments):
        transition = act(self, *arguments)
        now = self.context.substeps
        read.append((now.foot_velocity.copy(), now.foot_angular_velocity.copy()))
        return transition

    monkeypatch.setattr(Task, "act", acted)
    walked = roll_out(CommandedGaitController(), [(0.3, 0.2)], [FIRST_SEED], 1.0, physics=True)
    velocity, angular_velocity = (np.concatenate(values) for values in zip(*read, strict=True))
    # The lowest point of a ball moves with the ball's centre and with its rotation.
    lowest = velocity + np.cross(angular_velocity, [0.0, 0.0, -MINI_QUADRUPED.foot_radius])
    expected = np.hypot(lowest[..., 0], lowest[..., 1])
    assert np.ptp(expected) > 0.05
    np.testing.assert_allclose(walked.physics.slip, expected, rtol=1e-4, atol=1e-6)


def test_contact_is_a_force_beyond_the_threshold():
    stands = TaskConfig().without_randomization()
    standing = roll_out(CommandedGaitController(), [(0.0, 0.0)], [FIRST_SEED], 1.0, stands)
    assert standing.contact.all(axis=-1)[25:].all(), "after it has come down"
    walking = roll_out(CommandedGaitController(), [(0.3, 0.0)], [FIRST_SEED], 2.0, stands, physics=True)
    in_the_air = walking.physics.height > 0.003
    assert in_the_air.any()
    assert not walking.physics.force[in_the_air].any()
