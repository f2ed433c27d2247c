"""The program that writes the suite's reference rows."""

import argparse
import functools
import json
import re

import numpy as np
import pytest
from comparisons import random_policy
from suites import tiny_suite

import suite_references
from benchmarks import shipping
from quadruped_env import QuadrupedError
from quadruped_env.evaluation.results import COMPONENTS, read_references
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite import run_suite
from quadruped_env.evaluation.suite.suite_definition import quick_suite
from quadruped_env.policies import load_policy
from quadruped_env.policies.files import SHIPPED


def result_of(measured, suite, progress=None, zero_action=False):
    """Results of a controller that is as good as its name is long."""
    score = len(measured.name) / 10.0
    estimate = {"mean": score, "low": score, "high": score, "count": 1}
    result = {
        "suite": suite.identity,
        "seed": suite.seed,
        "conditions": {"robot": measured.robot.identity},
        "name": measured.name,
        "score": {"total": score, "components": dict.fromkeys(COMPONENTS, score)},
        "commands": {"met": estimate, "met_closely": estimate, "envelope": {"forwards": 0.0}},
        "joystick": {"laws": {"undisturbed": {"falls_per_hour": estimate}}},
        "terrain": {"kinds": {"rough": {"highest_level": 3, "crossed": []}}},
    }
    if zero_action:
        result["zero_action"] = result_of(measured.zero_action(), suite)
    return result


@pytest.fixture(autouse=True)
def shipped_policies(monkeypatch):
    """Policies with random weights instead of the shipped ones."""

    def load(name):
        return random_policy("position") if name in SHIPPED else load_policy(name)

    monkeypatch.setattr(suite_references, "load_policy", load)


def asked(directory, **options):
    return argparse.Namespace(
        **{
            "policy": [],
            "only": None,
            "result": [],
            "seed": None,
            "quick": True,
            "output": directory / "references.json",
            **options,
        }
    )


def test_rows_of_all_references_are_written_and_can_be_read(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(suite_references, "run_suite", result_of)
    random_policy("position").save(tmp_path / "run")
    arguments = asked(tmp_path, policy=[f"mine={tmp_path / 'run'}"])
    assert suite_references.run(arguments) == 0
    rows = read_references(tmp_path / "references.json")
    assert [row["name"] for row in rows] == [
        *("standing", "article", "sinusoid", "tuned"),
        *(row for name in (*SHIPPED, "mine") for row in (name, f"{name}, zero action")),
    ]
    assert {row["origin"]["versions"]["numpy"] for row in rows} == {np.__version__}
    assert {row["suite"]["sha256"] for row in rows} == {quick_suite().sha256}
    assert rows[0]["terrain"] == {"rough": 3}
    assert re.search(r"^standing +0.800 ", capsys.readouterr().out, re.MULTILINE)


def test_some_rows_are_measured_again_and_the_others_stay(tmp_path, monkeypatch):
    monkeypatch.setattr(suite_references, "run_suite", result_of)
    suite_references.run(asked(tmp_path, only=["standing", "flat"]))
    first = read_references(tmp_path / "references.json")
    monkeypatch.setattr(suite_references, "git_commit", lambda: "later")
    suite_references.run(asked(tmp_path, only=["tuned", "flat"]))
    rows = {row["name"]: row for row in read_references(tmp_path / "references.json")}
    assert list(rows) == ["standing", "tuned", "flat", "flat, zero action"], "in the order of the references"
    assert rows["standing"] == first[0]
    assert len({row["seed"] for row in rows.values()}) == 1, "the seed of the rows that stay"
    assert (
        rows["tuned"]["origin"]["commit"] == rows["flat"]["origin"]["commit"] == "later" != first[1]["origin"]["commit"]
    )


def test_rows_of_another_suite_are_not_kept(tmp_path, monkeypatch):
    monkeypatch.setattr(suite_references, "run_suite", result_of)
    suite_references.run(asked(tmp_path, only=["standing"]))
    before = (tmp_path / "references.json").read_bytes()
    with pytest.raises(QuadrupedError, match="standing"):
        suite_references.run(asked(tmp_path, only=["flat"], quick=False))
    assert (tmp_path / "references.json").read_bytes() == before


@pytest.mark.parametrize("entry", ["mine", "=run", "mine="])
def test_a_policy_needs_a_name_and_a_run(entry):
    with pytest.raises(QuadrupedError, match=r"--policy: expected NAME=RUN; found"):
        suite_references.named_policies([entry])


@pytest.fixture
def shipped(tmp_path, monkeypatch):
    """A policy that ships as `flat`, in a directory of its own, and the file of the reference rows."""
    directory, output = tmp_path / "flat", tmp_path / "references.json"
    random_policy("position").with_card({"seed": 3}).save(directory)
    for module in (suite_references, shipping):
        monkeypatch.setattr(module, "load_policy", lambda name: load_policy(directory if name in SHIPPED else name))
    monkeypatch.setattr(shipping, "shipped_directory", lambda name: tmp_path / name)
    monkeypatch.setattr(suite_references, "REFERENCE_FILE", output)
    return directory


@functools.cache
def quick_result():
    """Results of the policy of `shipped`, which say that they are of the quick suite."""
    measured = Candidate.of_policy(random_policy("position"), "flat")
    result = run_suite(measured, tiny_suite(), zero_action=True)
    for part in (result, result["zero_action"]):
        part["suite"] = quick_suite().identity
    return result


def finished(directory, **changes):
    """`suite.json` of an evaluation of the shipped policy `flat`."""
    policy = load_policy(directory)
    path = directory.parent / "suite.json"
    path.write_text(json.dumps({**quick_result(), "policy": {"name": "flat", "card": policy.card}, **changes}))
    return path


def test_finished_results_give_the_row_and_go_onto_the_card(shipped, monkeypatch):
    path = finished(shipped)
    monkeypatch.setattr(suite_references, "run_suite", lambda *_: pytest.fail("the suite ran again"))
    for _ in range(2):  # the results still belong to the policy when they are on its card
        assert suite_references.run(asked(shipped.parent, only=["flat"], result=[path])) == 0
    row, zero = read_references(shipped.parent / "references.json")
    result = json.loads(path.read_text())
    card = load_policy(shipped).card
    assert card["seed"] == 3
    assert card["suite"]["score"] == row["score"] == result["score"]
    assert card["suite"]["terrain"] == row["terrain"]
    assert card["suite"]["zero_action"] == zero["score"]
    assert set(card["suite"]["envelope"]) == {"forwards", "backwards", "left", "right"}
    np.testing.assert_array_equal(load_policy(shipped).weights[0], random_policy("position").weights[0])


def test_finished_results_of_another_policy_or_suite_are_refused(shipped):
    path = finished(shipped, policy={"name": "flat", "card": {"seed": 4}})
    with pytest.raises(QuadrupedError, match=r"suite\.json: expected results of a shipped policy, as it is now; found"):
        suite_references.run(asked(shipped.parent, only=["flat"], result=[path]))
    path = finished(shipped)
    with pytest.raises(QuadrupedError, match=r"suite\.json: expected the suite .*'quick': False"):
        suite_references.run(asked(shipped.parent, only=["flat"], result=[path], quick=False))
    assert "suite" not in load_policy(shipped).card
