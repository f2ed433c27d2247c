"""Comparisons of several runs, and their page."""

import dataclasses
import json

import numpy as np
import pytest
from comparisons import TINY, random_policy, write_comparison
from report_page import Page

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.control.task_file import KEPT_FILE
from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.verdict import verdict
from quadruped_env.report.pages import run_comparison
from quadruped_env.report.pages.tables import summary_table
from quadruped_env.task import load_task_file


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
        "Bad falls more often; good and level are most accurate forwards, standing, backwards and turning."
    )
    assert run_comparison.headline(several, ["good", "level"]).startswith("All are equally accurate forwards")

    # Both have a value backwards, but in no common episode; of the turns, one has none at all.
    backwards, turning = TINY.index((-0.2, 0.0)), TINY.index((0.0, 0.5))
    values["good"]["forward_velocity_error"][backwards, 0] = np.nan
    values["bad"]["forward_velocity_error"][backwards, 1:] = np.nan
    values["bad"]["yaw_rate_error"][turning] = np.nan
    assert run_comparison.headline(several, ["good", "bad"]).startswith(
        "Bad falls more often; good is most accurate forwards and standing; not comparable backwards and turning, "
        "because of early falls"
    )


def test_runs_are_compared_on_one_page(run_directory, tmp_path):
    second = tmp_path / "second"
    random_policy("position").save(second)
    policies = run_comparison.find_policies([str(run_directory), str(second)], tmp_path / "out")
    compared = compare({name: found.policy for name, found in policies.items()}, 1, 2.0, TINY)
    assert list(compared.values) == ["20260101-000000-ppo", "second", "tuned", "article", "zero"]
    page, numbers = write_comparison(policies, compared, tmp_path / "out")
    text = " ".join(" ".join(Page(page.read_text()).text).replace("\N{NO-BREAK SPACE}", " ").split())
    for name in policies:
        assert f"{name} {verdict(compared.seen_as(name)).headline}" in text
    assert "A single start has no confidence interval" in text
    assert "ne start of each command gives no interval, so errors are not ranked" in text
    assert "No intervals: a single random start of each command has none." in summary_table(compared)
    assert "[" not in next(line for line in summary_table(compared).splitlines() if line.startswith("Forwards"))
    assert "script-src" not in page.read_text()
    assert set(json.loads(numbers.read_text())["policies"]) == set(policies)
    alone = compare(random_policy("position"), 1, 2.0, TINY)
    np.testing.assert_array_equal(alone.values["policy"]["distance"], compared.values["second"]["distance"])
    assert verdict(compared.seen_as("second")) == verdict(alone)


TASK = """
from quadruped_env.task import reward


@reward(weight={})
def hip_usage(context):
    # <b>Escaped</b>
    return abs(context.joint_offset[:, 0::2]).sum(axis=1)
"""


def test_runs_of_two_versions_of_a_task_file_are_compared_with_every_term_and_a_diff(tmp_path, without_figures):
    for name, weight in (("one", -0.5), ("two", -2.0)):
        run = tmp_path / name
        run.mkdir()
        (run / KEPT_FILE).write_text(TASK.format(weight))
        random_policy("residual", definition=load_task_file(run / KEPT_FILE)).save(run)
        curve = "timesteps,seconds,return,reward_hip_usage\n1000,1,2.0,-0.1\n2000,2,5.5,-0.2\n"
        (run / "progress.csv").write_text(curve)
    runs = [str(tmp_path / name) for name in ("one", "two")]
    policies = run_comparison.find_policies(runs, tmp_path / "out", trust_task=True)
    compared = compare({name: found.policy for name, found in policies.items()}, 1, 2.0, TINY)
    page, numbers = write_comparison(policies, compared, tmp_path / "out")
    text, html = " ".join(Page(page.read_text()).text), page.read_text()
    assert "hip_usage" in text
    assert "Learning curves by reward term" in text
    assert "-@reward(weight=-0.5) +@reward(weight=-2.0)" in " ".join(text.split())
    assert "# &lt;b&gt;Escaped" in html
    assert "<b>Escaped" not in html
    terms = {n: entry["reward_terms"] for n, entry in json.loads(numbers.read_text())["policies"].items()}
    assert terms["one"].keys() == terms["two"].keys() > {"hip_usage", "upright"}
    one, two = terms["one"]["hip_usage"], terms["two"]["hip_usage"]
    assert (one["weight"], two["weight"]) == (-0.5, -2.0)
    assert two["per_second"] == pytest.approx(4.0 * one["per_second"]), "the policies are the same"
    # All runs with one version of the code: each keeps its own weights.
    with pytest.warns(QuadrupedWarning, match=r"one: .*is not the version of the training"):
        policies = run_comparison.find_policies(runs, tmp_path / "out", tmp_path / "two" / KEPT_FILE)
    assert [found.policy.config.reward.weights["hip_usage"] for found in policies.values()] == [-0.5, -2.0]


def test_runs_that_cannot_be_compared_are_named(run_directory, tmp_path):
    with pytest.raises(QuadrupedError, match="at least two runs"):
        run_comparison.find_policies(["flat"], tmp_path)
    with pytest.raises(QuadrupedError, match="'flat' is named before"):
        run_comparison.find_policies(["flat", "flat"], tmp_path)
    with pytest.raises(QuadrupedError, match="'tuned' is the name of a scripted controller"):
        compare({"tuned": random_policy("position")}, 1, 2.0)
