"""A policy's report: one self-contained page, and its numbers as JSON."""

import base64
import dataclasses
import json
import math
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from comparisons import TINY, write_evaluation
from report_page import Page

from quadruped_env.evaluation.comparison import CONTROLLERS
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.measures import metrics_of
from quadruped_env.evaluation.suite.suite_definition import full_suite
from quadruped_env.evaluation.verdict import verdict
from quadruped_env.report import plots
from quadruped_env.report.pages import report
from quadruped_env.report.pages.tables import reward_terms, summary_table, terms_table
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig

SECTIONS = (
    "Following the command",
    "Gait: which feet are on the ground",
    "Cost of transport over speed",
    "Torque and speed against the motors' limits",
    "Learning curve",
    "Reward terms",
)
MOTIONS = ["forwards", "standing", "backwards", "turning"]


def test_report_holds_the_verdict_first_then_the_table_and_every_metric(written, comparison):
    page = Page(written.page)
    text = " ".join(" ".join(page.text).replace("\N{NO-BREAK SPACE}", " ").split())
    assert not page.open
    judged = verdict(comparison, gain=written.gain)
    places = [text.index(judged.headline)]
    places += [
        text.index("In numbers"),
        text.index("Forwards: velocity error"),
        text.index("What was compared"),
        text.index("See it walk"),
        *map(text.index, SECTIONS),
        text.index("The worst episodes"),
        text.index("Every metric"),
        text.index("How this was made"),
    ]
    assert places == sorted(places)
    for name in CONTROLLERS.values():
        assert name in text
    for metric in metrics_of(MINI_QUADRUPED).values():
        assert metric.label in text
        assert metric.meaning in text
    assert "python evaluate/policy.py runs/<name>" in text
    assert "20260101-000000-ppo" in text
    assert re.search(r"Seeds 1000000 to 1000001", text)
    assert "No video: it was switched off." in text
    assert '"physics_timestep"' in text
    assert full_suite().label not in text, "the suite was not run"


def test_report_needs_no_other_file(written):
    html = written.page
    page = Page(html)
    assert page.addresses
    assert all(address.startswith("data:") for address in page.addresses)
    assert not {"script", "link"} & set(page.tags)
    assert page.policy.startswith("default-src 'none';")
    assert "http" not in page.policy
    assert "@import" not in html
    assert "url(" not in html
    assert "http://" not in html
    for address in page.addresses:
        svg = ElementTree.fromstring(base64.b64decode(address.partition("base64,")[2]))  # noqa: S314
        links = [value for e in svg.iter() for name, value in e.attrib.items() if name.endswith("href")]
        assert all(link.startswith(("#", "data:")) for link in links)
    assert len(html) < 4_000_000


def test_report_names_no_directory_of_the_machine(written):
    for document in (re.sub(r"base64,[^\"]*", "", written.page), written.numbers):
        assert str(written.directory.parent) not in document
        assert str(Path.home()) not in document


def test_metrics_are_strict_json_with_a_value_for_every_metric(written, comparison):
    def refuse(constant):
        raise AssertionError(f"{constant} is not JSON")

    document = json.loads(written.numbers, parse_constant=refuse)
    assert set(document["controllers"]) == set(CONTROLLERS)
    assert document["policy"]["card"]["best return"] is None
    assert document["seeds"] == [1_000_000, 1_000_001]
    for entry in document["controllers"].values():
        assert set(entry["all"]) == set(metrics_of(MINI_QUADRUPED))
        assert list(entry["by_motion"]) == MOTIONS
        assert len(entry["by_command"]) == len(document["commands"]) == len(TINY)
        for estimate in entry["all"].values():
            assert estimate["mean"] is None or estimate["low"] <= estimate["mean"] <= estimate["high"]
    for kind in ("electrical", "mechanical"):
        assert document["controllers"]["zero"]["by_motion"]["standing"][f"{kind}_cost_of_transport"]["mean"] is None
        power = comparison.values["policy"][f"{kind}_power"][0].mean()
        assert document["controllers"]["policy"]["by_command"][0][f"{kind}_power"]["mean"] == pytest.approx(power)
    assert TaskConfig.from_dict(document["config"]).action.mode == "residual"


def test_table_has_a_row_for_every_motion(comparison):
    lines = summary_table(comparison).splitlines()
    assert [line.split(":")[0].split()[0] for line in lines[1:6]] == ["Falls", *(m.capitalize() for m in MOTIONS)]
    assert lines[-1] == "undisturbed, on the task's own ground: 2 starts of each command, 3 s"
    number = r"([\d.]+)(?: %)?"
    found = re.findall(rf"{number} \[{number}, {number}\]", "\n".join(lines))
    assert len(found) > 20
    assert all(float(low) <= float(mean) <= float(high) for mean, low, high in found)


# --- the learning curve


def test_learning_curve_reads_what_a_killed_run_left(run_directory):
    curve = plots.read_progress(run_directory / "progress.csv")
    np.testing.assert_equal(curve["timesteps"], [1000.0, 2000.0, 3000.0])
    np.testing.assert_equal(curve["return"], [math.nan, 5.5, math.nan])


def test_reward_terms_are_per_second_and_unknown_for_a_policy_that_always_falls(comparison, run_directory):
    policy, run = comparison.rollouts["policy"], {"policy": find_policy(str(run_directory))}
    assert not policy.fallen.any()
    terms = reward_terms(run, comparison)["policy"]
    mean = policy.reward_terms[50:].mean(axis=(0, 1)) * 50.0  # per second
    np.testing.assert_allclose([term["per_second"] for term in terms.values()], mean, rtol=1e-4, atol=1e-6)
    for _, cell in terms_table(run, comparison).rows:
        value, _, parts = cell.partition("\n")
        if value != "-":
            weight, mean = map(float, parts.split(" \N{MULTIPLICATION SIGN} "))
            assert weight * mean == pytest.approx(float(value), rel=0.02)
    fallen = dataclasses.replace(policy, fell=np.ones_like(policy.fell))
    fallen = dataclasses.replace(comparison, rollouts={**comparison.rollouts, "policy": fallen})
    rows = terms_table(run, fallen).rows
    assert len(rows) > 5
    assert {row[1][0] for row in rows} == {"-"}


def test_numbers_are_written_before_a_report_that_fails(
    run_directory, comparison, tmp_path, monkeypatch, without_figures
):
    def fail(*_, **__):
        raise ZeroDivisionError

    monkeypatch.setattr(report, "write_html", fail)
    with pytest.raises(ZeroDivisionError):
        write_evaluation(find_policy(str(run_directory), tmp_path), comparison)
    assert json.loads((tmp_path / "metrics.json").read_text())["verdict"]["headline"]
