"""Comparisons of a policy with the scripted controllers, in the same episodes."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from comparisons import random_policy

from quadruped_env import QuadrupedError
from quadruped_env.evaluation.comparison import Comparison, compare
from quadruped_env.task import CommandConfig, TaskConfig


def test_pairs_share_their_starts_and_differences_are_of_pairs(comparison):
    starts = [rollout.orientation[0] for rollout in comparison.rollouts.values()]
    for start in starts[1:]:
        np.testing.assert_allclose(start, starts[0], atol=0.1)
    by_hand = (comparison.values["policy"]["distance"] - comparison.values["zero"]["distance"]).mean()
    assert comparison.difference("distance", "policy", "zero").mean == pytest.approx(by_hand)


def test_policy_can_be_compared_on_commands_beyond_its_training():
    narrow = random_policy("position", command=CommandConfig(forward_velocity=(0.0, 0.1), yaw_rate=(0.0, 0.0)))
    done = compare(narrow, num_seeds=1, seconds=2.0, commands=[(0.5, -0.5)])
    assert done.config.command.forward_velocity == (0.0, 0.5)
    assert done.config.command.yaw_rate == (-0.5, 0.0)


@pytest.mark.parametrize("seconds", [1.0, math.nan, math.inf, -3.0])
def test_episodes_too_short_to_measure_are_refused(seconds):
    with pytest.raises(QuadrupedError, match=r"seconds: expected 2 to 600; found"):
        compare(random_policy("position"), 1, seconds)


def test_condition_names_the_randomization_and_the_ground(comparison):
    assert comparison.condition == "undisturbed, on the task's own ground" == comparison.to_dict()["condition"]
    other = compare(random_policy("residual"), 1, 2.0, [(0.2, 0.0)], terrain="rough", randomization="hard")
    assert other.condition == "with the randomization hard, on the terrain rough"


def test_shown_episode_is_the_first_without_a_fall():
    valid = np.ones((10, 6), dtype=bool)
    valid[4:, 0] = False
    valid[3:, 3:] = False
    valid[5, 4] = valid[4, 4] = valid[3, 4] = True
    rollout = SimpleNamespace(valid=valid)
    numbers = Comparison(((0.1, 0.0), (0.2, 0.0)), (0, 1, 2), 1.0, TaskConfig(), {"policy": rollout}, {})
    assert numbers.episode(0) == 1
    assert numbers.episode(1) == 4


def test_tuned_gait_earns_the_reward_of_the_clock_from_every_start_and_with_every_policy():
    """Its clock is its own: in phase, whatever the start, and whatever the frequency of the policy's clock."""
    done = compare(random_policy("position", clock_frequency=5.0), num_seeds=4, seconds=3.0, commands=[(0.4, 0.0)])
    tuned = done.rollouts["tuned"]
    earned = tuned.reward_terms[50:, :, tuned.term_names.index("gait_clock")].mean(axis=0) / tuned.timestep
    assert earned.min() > 0.9 * earned.max() > 0.0
