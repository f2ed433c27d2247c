"""The clips that a report shows."""

from dataclasses import replace

import numpy as np
from synthetic import falls

from quadruped_env.report.pages import clips
from quadruped_env.report.pages.clips import filmed


def test_film_shows_slow_and_fast_walking_turning_and_backwards(comparison):
    # Its commands forwards are 0.2 and 0.4 m/s.
    assert [clip.title for clip in filmed(comparison)] == [
        "forwards: 0.2 m/s",
        "forwards: 0.4 m/s",
        "turning: 0.5 rad/s",
        "backwards: -0.2 m/s",
    ]
    rollout, row = comparison.rollouts["policy"], comparison.commands.index((0.2, 0.0)) * len(comparison.seeds)
    start = round(3.0 / rollout.timestep) - round(clips.CLIP_SECONDS / rollout.timestep)
    for clip in filmed(comparison):
        assert clip.trace.seconds <= clips.CLIP_SECONDS + 1e-9
    shown = filmed(comparison)[0].trace.joint_position[0]
    np.testing.assert_array_equal(shown, rollout.joint_position[start, row], "not the start-up")


def test_recorded_joints_are_those_of_the_plotted_episode_until_its_fall(comparison):
    rollout = comparison.rollouts["policy"]
    command = comparison.commands.index((0.4, 0.0))
    for alive in (len(rollout), 40):
        valid = rollout.valid & (np.arange(len(rollout)) < alive)[:, None]
        shown = replace(comparison, rollouts={"policy": replace(rollout, fell=falls(valid))})
        joints = clips.recorded(shown).joints
        row = shown.episode(command)
        np.testing.assert_array_equal(joints.positions, rollout.joint_position[: valid[:, row].sum(), row])
        np.testing.assert_array_equal(joints.efforts, rollout.joint_torque[: valid[:, row].sum(), row])
