"""The worst episodes of a policy."""

import dataclasses
import math

import numpy as np
import pytest
from comparisons import TINY
from synthetic import falls

from quadruped_env.evaluation import failures


def with_falls(comparison, **ends):
    """The comparison, in which the policy falls in the given envs (r3 is the fourth) after the given samples."""
    policy = comparison.rollouts["policy"]
    valid = policy.valid.copy()
    for row, samples in ends.items():
        valid[samples:, int(row[1:])] = False
    fallen = dataclasses.replace(policy, fell=falls(valid))
    return dataclasses.replace(comparison, rollouts={**comparison.rollouts, "policy": fallen})


def test_falls_are_the_worst_and_the_earliest_first(comparison):
    found = failures.worst_episodes(with_falls(comparison, r1=100, r4=50, r5=80))
    assert [failure.row for failure in found[:2]] == [4, 1]
    assert [failure.command for failure in found[:2]] == [TINY[2], TINY[0]]
    assert found[0].fell_at == pytest.approx(51 * 0.02)
    assert found[0].story.startswith("It fell at 1.0 s. Errors before: ")
    assert found[2].fell_at is None


def test_without_falls_the_worst_has_the_largest_error(comparison):
    errors = comparison.values["policy"]
    tolerated = np.maximum(errors["forward_velocity_error"] / 0.1, errors["yaw_rate_error"] / 0.2)
    worst = failures.worst_episodes(with_falls(comparison))
    assert not any(math.isinf(failure.badness) for failure in worst)
    assert worst[0].badness == pytest.approx(np.nanmax(tolerated))
    assert worst[0].row == int(np.nanargmax(tolerated))
    assert "It did not fall. Errors: " in worst[0].story
    assert len({failure.command for failure in worst}) == len(worst) == failures.SHOWN
