"""Means over the training seeds of one recipe."""

import numpy as np
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.evaluation.results import COMPONENTS, aggregate
from quadruped_env.evaluation.suite.suite_definition import full_suite, quick_suite


def document(name, score, **levels):
    components = dict.fromkeys(COMPONENTS, score)
    return {
        "suite": full_suite().identity,
        "conditions": {"robot": {"name": "r", "sha256": "0"}},
        "name": name,
        "score": {"total": score, "components": {**components, "gait": 0.5 * score}},
        "terrain": {kind: {"highest_level": level} for kind, level in levels.items()},
    }


def test_aggregate_has_the_means_over_the_training_seeds_with_intervals():
    scores = (0.2, 0.4, 0.5, 0.9)
    result = aggregate([document(f"seed {i}", score, rough=i + 3, steps=2) for i, score in enumerate(scores)])
    assert [run["name"] for run in result["runs"]] == ["seed 0", "seed 1", "seed 2", "seed 3"]
    assert [run["total"] for run in result["runs"]] == [0.2, 0.4, 0.5, 0.9]
    assert result["score"]["mean"] == pytest.approx(np.mean(scores))
    assert 0.2 < result["score"]["low"] < 0.5 < result["score"]["high"] < 0.9
    assert (result["components"]["gait"]["mean"], result["components"]["gait"]["count"]) == (pytest.approx(0.25), 4)
    assert result["terrain"] == {"rough": 3, "steps": 2}  # what all runs pass


def test_aggregate_of_one_run_has_no_interval():
    score = aggregate([document("alone", 0.4, rough=1)])["score"]
    assert (score["mean"], score["low"], score["high"]) == (pytest.approx(0.4), None, None)


def test_aggregate_refuses_results_that_cannot_be_compared():
    other = document("quick", 0.5, rough=1)
    other["suite"] = quick_suite().identity
    with pytest.raises(QuadrupedError, match=r"full \(1\) and quick \(2\) cannot be compared: suite.quick"):
        aggregate([document("full", 0.5, rough=1), other])
