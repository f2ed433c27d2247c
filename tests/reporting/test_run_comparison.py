"""Comparisons of several runs, and their page."""

import dataclasses
import json

import numpy as np
import pytest
from comparisons import TINY, random_policy
from report_page import Page

from quadruped_env import QuadrupedError
from quadruped_env.evaluation.comparison import compare, compare_policies
from quadruped_env.evaluation.verdict import verdict
from quadruped_env.reporting.pages import run_comparison


def test_runs_are_ranked_by_paired_differences(comparison):
    rng = np.random.default_rng(0)
    values = {name: {m: v.copy() for m, v in metrics.items()} for name, metrics in comparison.values.items()}
    values["good"], values["level"], values["bad"] = (
        {m: v.copy() for m, v in values["tuned"].items()} for _ in range(3)
    )
    for metric in ("forward_velocity_error", "yaw_rate_error", "fall_rate"):
        values["good"][metric][:] = 0.0
        values["level"][metric][:] = rng.uniform(0.0, 0.004, values["level"][metric].shape)
        values["bad"][metric][:] = 1.0
    values["level"]["fall_rate"][:] = 0.0
    several = dataclasses.replace(comparison, values=values)
    names = ["bad", "good", "level"]
    assert run_comparison.best_at(several, names, "forwards") == ["good", "level"]
    words = run_comparison.headline(several, names)
    assert words.startswith(
        "Good and level are most accurate forwards, standing, backwards and turning; bad falls more often."
    )
    assert run_comparison.headline(several, ["good", "level"]).startswith("All are equally accurate forwards")

    # Both have a value backwards, but in no common episode; of the turns, one has none at all.
    backwards, turning = TINY.index((-0.2, 0.0)), TINY.index((0.0, 0.5))
    values["good"]["forward_velocity_error"][backwards, 0] = np.nan
    values["bad"]["forward_velocity_error"][backwards, 1:] = np.nan
    values["bad"]["yaw_rate_error"][turning] = np.nan
    assert run_comparison.headline(several, ["good", "bad"]).startswith(
        "Good is most accurate forwards and standing; not comparable backwards and turning, because of early falls"
    )


def test_runs_are_compared_on_one_page(run_directory, tmp_path):
    second = tmp_path / "second"
    random_policy("position").save(second)
    subjects = run_comparison.find_subjects([str(run_directory), str(second)], tmp_path / "out")
    policies = {name: found.policy for name, found in subjects.items()}
    compared = compare_policies(policies, 1, 2.0, TINY)
    assert list(compared.values) == ["20260101-000000-ppo", "second", "tuned", "article", "zero"]
    page, numbers, _ = run_comparison.write_comparison(subjects, compared, tmp_path / "out", "", with_video=False)
    text = " ".join(Page(page.read_text()).text)
    for name in subjects:
        assert name in text
    assert "script-src" not in page.read_text()
    assert set(json.loads(numbers.read_text())["policies"]) == set(subjects)
    alone = compare(random_policy("position"), 1, 2.0, TINY)
    np.testing.assert_array_equal(alone.values["policy"]["distance"], compared.values["second"]["distance"])
    assert verdict(compared.seen_as("second")) == verdict(alone)


def test_runs_that_cannot_be_compared_are_named(run_directory, tmp_path):
    with pytest.raises(QuadrupedError, match="at least two runs"):
        run_comparison.find_subjects(["flat"], tmp_path)
    with pytest.raises(QuadrupedError, match="'flat' is named before"):
        run_comparison.find_subjects(["flat", "flat"], tmp_path)
    with pytest.raises(QuadrupedError, match="'tuned' is the name of a scripted controller"):
        compare_policies({"tuned": random_policy("position")}, 1, 2.0)
