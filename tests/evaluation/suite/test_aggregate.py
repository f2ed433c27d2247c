"""Interquartile mean and its stratified bootstrap, against SciPy and direct computation."""

import itertools
import math

import numpy as np
import pytest
from scipy.stats import trim_mean

from quadruped_env import QuadrupedError
from quadruped_env.evaluation.results import COMPONENTS, aggregate, interquartile_mean, stratified_interquartile_mean
from quadruped_env.evaluation.suite.suite_definition import full_suite, quick_suite


def test_interquartile_mean_by_hand():
    assert interquartile_mean([8.0, 1.0, 3.0, 2.0]) == pytest.approx(2.5)
    assert interquartile_mean([1.0, 100.0, 3.0]) == pytest.approx(104.0 / 3.0)  # three quarters of a value: none
    np.testing.assert_allclose(interquartile_mean([[0.0, 1.0, 2.0, 9.0], [5.0, 5.0, 5.0, 5.0]]), [1.5, 5.0])


@pytest.mark.parametrize("count", [1, 3, 4, 5, 7, 8, 35])
def test_interquartile_mean_is_scipys_trimmed_mean(count):
    values = np.random.default_rng(count).random(count)
    assert interquartile_mean(values) == pytest.approx(trim_mean(values, 0.25))


def test_interval_is_that_of_all_possible_resamples():
    """Two runs of two tasks have 16 equally likely resamples: the runs of a task are drawn independently."""
    scores = np.array([[0.0, 0.3], [0.4, 0.8]])
    exact = [
        trim_mean([scores[a, 0], scores[b, 0], scores[c, 1], scores[d, 1]], 0.25)
        for a, b, c, d in itertools.product((0, 1), repeat=4)
    ]
    found = stratified_interquartile_mean(scores)
    np.testing.assert_allclose([found.low, found.high], np.quantile(exact, [0.025, 0.975]), atol=1e-9)


def test_interval_agrees_with_a_direct_bootstrap():
    scores = np.random.default_rng(3).random((5, 6))
    generator = np.random.default_rng(4)
    means = []
    for _ in range(4000):
        resample = [scores[generator.integers(0, 5, 5), task] for task in range(6)]
        means.append(trim_mean(np.concatenate(resample), 0.25))
    found = stratified_interquartile_mean(scores)
    np.testing.assert_allclose([found.low, found.high], np.quantile(means, [0.025, 0.975]), atol=0.012)


def test_one_run_has_no_interval():
    found = stratified_interquartile_mean([[0.1, 0.2, 0.6, 0.9]])
    assert found.mean == pytest.approx(0.4)
    assert math.isnan(found.low)
    assert math.isnan(found.high)


def document(name, score, **levels):
    components = dict.fromkeys(COMPONENTS, score)
    return {
        "suite": full_suite().identity,
        "conditions": {"robot": {"name": "r", "sha256": "0"}},
        "name": name,
        "score": {"total": score, "components": components},
        "terrain": {kind: {"highest_level": level} for kind, level in levels.items()},
    }


def test_aggregate_of_training_seeds():
    runs = [document(f"seed {i}", score, rough=i + 3, steps=2) for i, score in enumerate((0.2, 0.4, 0.5, 0.9))]
    result = aggregate(runs)
    assert [run["name"] for run in result["runs"]] == ["seed 0", "seed 1", "seed 2", "seed 3"]
    assert [run["total"] for run in result["runs"]] == [0.2, 0.4, 0.5, 0.9]
    assert result["score"]["mean"] == pytest.approx(0.45)
    assert result["score"]["low"] < 0.45 < result["score"]["high"]
    assert result["components"]["gait"]["mean"] == pytest.approx(0.45)
    assert result["components"]["gait"]["count"] == 4
    assert result["terrain"] == {"rough": 3, "steps": 2}  # what all runs pass


def test_aggregate_refuses_results_that_cannot_be_compared():
    other = document("quick", 0.5, rough=1)
    other["suite"] = quick_suite().identity
    with pytest.raises(QuadrupedError, match=r"full \(1\) and quick \(2\) cannot be compared: suite.quick"):
        aggregate([document("full", 0.5, rough=1), other])
