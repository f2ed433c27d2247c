"""The program that writes the suite's reference rows."""

import argparse

import pytest
from comparisons import random_policy

import suite_references
from quadruped_env import QuadrupedError
from quadruped_env.evaluation.suite.definition import quick_suite
from quadruped_env.evaluation.suite.references import read_references
from quadruped_env.evaluation.suite.suite import COMPONENTS


def result_of(contender, suite, progress):
    """Results of a controller that is as good as its name is long."""
    score = len(contender.name) / 10.0
    estimate = {"mean": score, "low": score, "high": score, "count": 1}
    return {
        "suite": suite.identity,
        "conditions": {"robot": contender.robot.identity},
        "name": contender.name,
        "score": {"total": score, "components": dict.fromkeys(COMPONENTS, score)},
        "commands": {"met": estimate, "dead_zone": {"forwards": 0.0}},
        "pushes": {"half_survival": [estimate]},
        "terrain": {"rough": {"highest_level": 3, "crossed": []}},
        "recovery": {"side": {"recovered": estimate, "time": estimate}},
    }


def test_rows_of_all_references_are_written_and_can_be_read(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(suite_references, "run_suite", result_of)
    random_policy("position").save(tmp_path / "run")
    arguments = argparse.Namespace(policy=[f"mine={tmp_path / 'run'}"], quick=True, output=tmp_path / "references.json")
    assert suite_references.run(arguments) == 0
    rows = read_references(tmp_path / "references.json")
    assert [row["name"] for row in rows] == ["standing", "article", "tuned", "flat", "mine"]
    assert {row["suite"]["sha256"] for row in rows} == {quick_suite().sha256}
    assert rows[0]["terrain"] == {"rough": 3}
    assert rows[0]["recovery"]["side"]["mean"] == 0.8
    assert "standing  0.800" in capsys.readouterr().out


@pytest.mark.parametrize("entry", ["mine", "=run", "mine="])
def test_a_policy_needs_a_name_and_a_run(entry):
    with pytest.raises(QuadrupedError, match=r"--policy: expected NAME=RUN; found"):
        suite_references.named_policies([entry])
