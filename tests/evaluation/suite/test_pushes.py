"""Survival of pushes: isotonic fit and 50 % point against known curves, and the push against the simulated motion."""

from dataclasses import replace

import numpy as np
import pytest

from quadruped_env.evaluation.suite import pushes
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite_definition import full_suite
from quadruped_env.policies import ZeroController
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import TaskConfig

PART = full_suite().pushes
SIZES = np.array(PART.sizes)


def pooled(values):
    """Non-increasing isotonic regression by pooling adjacent violators, one after the other."""
    blocks = []
    for value in values:
        blocks.append([value, 1])
        while len(blocks) > 1 and blocks[-2][0] < blocks[-1][0]:
            last, before = blocks.pop(), blocks.pop()
            count = last[1] + before[1]
            blocks.append([(last[0] * last[1] + before[0] * before[1]) / count, count])
    return [value for value, count in blocks for _ in range(count)]


def test_isotonic_fit_by_hand_and_by_pooling():
    np.testing.assert_allclose(pushes.non_increasing(np.array([[1.0, 0.4, 0.6, 0.2]])), [[1.0, 0.5, 0.5, 0.2]])
    lines = np.random.default_rng(0).integers(0, 17, (200, 11)) / 16.0
    np.testing.assert_allclose(pushes.non_increasing(lines), [pooled(line) for line in lines])


@pytest.mark.parametrize(
    ("shares", "expected"),
    [
        ([1.0, 1.0, 0.0, 0.0], 0.3),
        ([1.0, 0.75, 0.25, 0.0], 0.3),
        ([1.0, 0.5, 0.0, 0.0], 0.2),
        ([1.0, 0.9, 0.8, 0.7], 0.6),  # more than half survive the largest push
        ([0.4, 0.2, 0.0, 0.0], 0.0),  # most fall without a push
    ],
)
def test_half_point_is_interpolated(shares, expected):
    assert pushes.half_point(np.array([0.0, 0.2, 0.4, 0.6]), np.array([shares]))[0] == pytest.approx(expected)


def logistic(middle, width, seeds, generator):
    """Survival of a logistic law with a known 50 % point (K, S)."""
    return generator.random((len(SIZES), seeds)) < 1.0 / (1.0 + np.exp((SIZES[:, None] - middle) / width))


@pytest.mark.parametrize("middle", [0.55, 0.9, 1.3])
def test_half_survival_of_a_logistic_law_is_its_middle(middle):
    generator = np.random.default_rng(1)
    found = pushes.half_survival(SIZES, logistic(middle, 0.1, 4000, generator))
    assert found["mean"] == pytest.approx(middle, abs=0.02)
    assert found["low"] <= found["mean"] <= found["high"]
    assert found["high"] - found["low"] < 0.03
    assert not found["censored"]


def test_interval_of_the_half_point_covers_the_truth_about_as_often_as_it_says():
    generator = np.random.default_rng(2)
    covered = 0
    for _ in range(100):
        found = pushes.half_survival(SIZES, logistic(0.9, 0.15, PART.num_seeds, generator))
        covered += found["low"] - 0.02 <= 0.9 <= found["high"] + 0.02  # interpolation errs by less than 0.02
    assert covered >= 88


def test_half_survival_of_a_robot_that_never_falls_is_censored():
    found = pushes.half_survival(SIZES, np.ones((len(SIZES), 16), dtype=bool))
    assert found == {"mean": 2.0, "low": 2.0, "high": 2.0, "censored": True}


def test_summary_by_size_and_direction():
    part = replace(PART, sizes=(0.0, 0.5, 1.0), directions=(0.0, 90.0))
    survived = np.zeros((3, 2, 4), dtype=bool)
    survived[0] = True
    survived[1, 0] = True
    survived[1, 1, :2] = True
    result = pushes.summary(part, survived)
    assert result["survived"] == [[1.0, 1.0], [1.0, 0.5], [0.0, 0.0]]
    assert [entry["mean"] for entry in result["by_size"]] == [1.0, 0.75, 0.0]
    assert [entry["count"] for entry in result["by_size"]] == [8, 8, 8]
    assert [entry["mean"] for entry in result["half_survival"]] == [0.75, 0.5]
    # Episodes without a push are not part of the score.
    assert result["all"]["mean"] == pytest.approx(6 / 16)


def test_push_has_its_size_and_direction_relative_to_the_heading(monkeypatch):
    part = replace(PART, sizes=(0.0, 0.4), directions=(0.0, 90.0, 225.0), before=0.5, after=0.1, num_seeds=3)
    pushed, push = [], BatchSimulation.push

    def record(self, env_ids, velocity):
        pushed.append((env_ids.copy(), velocity.copy(), self.readings.orientation[env_ids].copy()))
        push(self, env_ids, velocity)

    monkeypatch.setattr(BatchSimulation, "push", record)
    result = pushes.run(part, MeasuredController("standing", ZeroController(), TaskConfig()))
    assert np.array(result["survived"]).shape == (2, 3)
    ((env_ids, velocity, orientation),) = pushed
    np.testing.assert_array_equal(env_ids, np.arange(9, 18))  # the first nine are not pushed
    np.testing.assert_allclose(np.hypot(velocity[:, 0], velocity[:, 1]), 0.4)
    np.testing.assert_array_equal(velocity[:, 2], 0.0)
    heading = 2.0 * np.arctan2(orientation[:, 3], orientation[:, 0])
    relative = np.arctan2(velocity[:, 1], velocity[:, 0]) - heading
    expected = np.repeat(np.radians(part.directions), 3)
    np.testing.assert_allclose(np.cos(relative - expected), 1.0, atol=2e-3)
    assert np.ptp(heading) > 1.0
