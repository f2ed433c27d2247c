"""The suite in the reports: sections, files, ranking, and the programs' options."""

import argparse
import copy
import json
import re
from xml.etree import ElementTree

import pytest
from comparisons import random_policy, write_comparison, write_evaluation
from report_page import Page
from suites import tiny_suite

from benchmarks.shipping import reference_row
from quadruped_env import QuadrupedError
from quadruped_env.cli import compare
from quadruped_env.cli.main import main
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.results import COMPONENTS
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite import run_suite
from quadruped_env.evaluation.suite.suite_definition import SEEDS, full_suite, quick_suite
from quadruped_env.report.pages import suite_section
from quadruped_env.report.plots import suite_plots as plots


@pytest.fixture(scope="module")
def suite_result(run_directory):
    """Short results of the policy of `run_directory`."""
    evaluated = find_policy(str(run_directory))
    measured = Candidate.of_policy(evaluated.policy, evaluated.name)
    return run_suite(measured, tiny_suite(), zero_action=True)


def text_of(path):
    return " ".join(" ".join(Page(path.read_text()).text).replace("\N{NO-BREAK SPACE}", " ").split())


def test_report_holds_the_suite_and_its_numbers(
    run_directory, comparison, suite_result, tmp_path, monkeypatch, without_figures
):
    row = copy.deepcopy(reference_row(suite_result))
    row["name"], row["score"]["total"] = "reference", 0.987
    monkeypatch.setattr(suite_section, "read_references", lambda: [row])
    evaluated = find_policy(str(run_directory), tmp_path)
    page, numbers, _ = write_evaluation(evaluated, comparison, "the command", suite_result)
    text = text_of(page)
    for words in (
        "mq-eval 3 (quick)",
        "never comparable with the numbers of the full suite",
        "Every command",
        "Gait at every speed",
        "Every foot",
        "Heading drift",
        "Changes of the command",
        "emergency stop",
        "Pushes",
        "Changing commands",
        "undisturbed",
        "Regulation",
        "up 8 degrees",
        "zero action",
        "Terrain",
        "reference 0.987",
        "Seed 1500000",
        "A second physics engine is not part of the score, and was not measured",
    ):
        assert words in text
    # The reference has the better score and comes first.
    assert text.index("reference 0.987") < text.index(f"{evaluated.name} {suite_result['score']['total']:.3f}")
    stored = json.loads((tmp_path / "suite.json").read_text())
    assert {name: stored[name] for name in suite_result} == suite_result
    assert stored["policy"]["name"] == evaluated.name
    assert stored["command_line"] == "the command"
    document = json.loads(numbers.read_text())
    assert {name: document["suite"][name] for name in suite_result["suite"]} == suite_result["suite"]
    assert document["suite"]["score"] == suite_result["score"]


def test_figures_are_svg_and_survive_unknown_values(suite_result):
    unknown = copy.deepcopy(suite_result)
    for name in ("forward_velocity_error", "yaw_rate_error"):
        unknown["commands"][name]["signed"][0] = None
    unknown["commands"]["fall_share"][0] = 1.0
    for entry in unknown["gait"]["commands"]:
        entry["landing_speed"] = [None] * 4
        entry["clearance"] = [None] * 4
    unknown["regulation"]["disturbances"]["nominal"]["commands"][0]["share"] = [None, None]
    for draw in (plots.command_map, plots.pushes, plots.crossings):
        assert ElementTree.fromstring(draw(unknown)).tag.endswith("svg")  # noqa: S314
    gait = {row[0].partition("\n")[0]: row[1:] for row in suite_section.section(unknown)["tables"][1].rows}
    assert gait["Foot clearance"] == gait["Landing speed"] == ["-", "-"]


@pytest.fixture
def two_runs(run_directory, suite_result, tmp_path, monkeypatch):
    """Two runs that differ in their seed, and their results."""
    monkeypatch.chdir(tmp_path)
    for i, name in enumerate(("one", "two")):
        policy = random_policy("residual")
        policy.with_card({**policy.card, "seed": i}).save(tmp_path / name)
        training = {"action_mode": "residual", "seed": i, "name": "ppo", "learning_rate": 0.002}
        (tmp_path / name / "config.json").write_text(json.dumps({"training": training, "task": {"a": 1}}))
        result = copy.deepcopy(suite_result)
        del result["zero_action"]
        for component in COMPONENTS:
            result["score"]["components"][component] = 0.25 * (i + 1)
        result["score"]["total"] = 0.25 * (i + 1)
        result["name"] = name
        evaluated = find_policy(name, tmp_path / name / "evaluation")
        suite_section.write_results(evaluated, result, "")
    return tmp_path


def policies(*names):
    return {name: find_policy(name, None) for name in names}


def results_of(found):
    return {name: suite_section.stored_results(evaluated) for name, evaluated in found.items()}


def ranked(*names):
    found = policies(*names)
    return suite_section.ranking(found, results_of(found))


def test_policies_are_ranked_by_their_score_and_training_seeds_aggregated(two_runs):
    found = ranked("one", "two")
    assert [(entry["name"], entry["total"]) for entry in found["policies"]] == [("two", 0.5), ("one", 0.25)]
    (recipe,) = found["recipes"]
    assert [run["name"] for run in recipe["runs"]] == ["one", "two"]
    assert recipe["score"]["mean"] == pytest.approx(0.375)
    best, other = found["policies"]
    assert best["difference"] is None
    assert other["difference"]["score"]["mean"] == -0.25
    # A part with a single episode leaves no interval.
    assert suite_section.ranking_in_words(found) == (
        "Score in mq-eval 3 (quick) with the seed 1500000, the best first: two 0.500, one 0.250 (-0.250)."
    )
    assert [row[-1] for row in suite_section.ranking_table(found).rows] == ["", "-0.250", ""]


def test_the_zero_action_has_a_row_of_its_own_in_rankings(two_runs):
    path = two_runs / "one" / "evaluation" / "suite.json"
    stored = json.loads(path.read_text())
    total = {"total": 0.3, "components": dict.fromkeys(COMPONENTS, 0.3)}
    zero = {**stored, "name": "one, zero action", "score": total}
    path.write_text(json.dumps({**stored, "zero_action": zero}))
    assert [entry["name"] for entry in ranked("one", "two")["policies"]] == ["two", "one, zero action", "one"]


def test_results_of_another_suite_or_policy_are_not_those_of_a_policy(two_runs):
    path = two_runs / "two" / "evaluation" / "suite.json"
    stored = json.loads(path.read_text())
    (two,) = policies("two").values()
    assert suite_section.stored_results(two, stored["suite"]) == stored
    path.write_text(json.dumps({**stored, "suite": full_suite().identity}))
    assert suite_section.stored_results(two, stored["suite"]) is None
    with pytest.raises(QuadrupedError, match=r"one and two cannot be compared: suite\.quick"):
        ranked("one", "two")
    path.write_text(json.dumps({**stored, "policy": {"name": "two", "card": {"seed": 7}}}))
    assert suite_section.stored_results(two) is None
    path.write_text("{}")
    with pytest.raises(QuadrupedError, match=r"suite.json: suite is missing; evaluate the policy with --suite"):
        suite_section.stored_results(two)
    path.unlink()
    assert suite_section.stored_results(two) is None


def test_comparing_measures_what_is_not_stored_with_the_seed(two_runs, suite_result, monkeypatch):
    """The seed is the option's, or the one of the first results; what has it is not measured again."""
    asked = []

    def run(candidate, suite, progress):
        asked.append((candidate.name, suite.seed))
        return {**suite_result, "seed": suite.seed, "suite": suite.identity}

    monkeypatch.setattr("quadruped_env.evaluation.suite.suite.run_suite", run)
    for name, seed in ("one", 1_600_000), ("two", 1_700_000):
        path = two_runs / name / "evaluation" / "suite.json"
        path.write_text(json.dumps({**json.loads(path.read_text()), "seed": seed, "suite": quick_suite().identity}))
    found = policies("one", "two")
    for seed, quick, expected in (
        (None, True, [("two", 1_600_000)]),
        (1_700_000, True, [("one", 1_700_000)]),
        (1_800_000, False, [("one", 1_800_000), ("two", 1_800_000)]),
    ):
        asked.clear()
        arguments = argparse.Namespace(quick=quick, seed=seed)
        results = compare._suite_results(found, arguments)
        assert asked == expected
        assert {result["seed"] for result in results.values()} == {arguments.seed}
    arguments = argparse.Namespace(quick=False, seed=None)
    assert len({result["seed"] for result in compare._suite_results(found, arguments).values()}) == 1
    assert arguments.seed in SEEDS


def test_comparison_page_has_the_ranking(two_runs, comparison, tmp_path, without_figures):
    names = ["one", "two"]
    found = {**policies(*names)}
    several = comparison.seen_as("policy")
    for name in names:
        several.rollouts[name], several.values[name] = several.rollouts["policy"], several.values["policy"]
    page, numbers = write_comparison(found, several, tmp_path / "out", ranked=ranked(*names))
    text = text_of(page)
    assert "the best first: two 0.500, one 0.250 (-0.250)." in text
    row = text.partition("2 training seeds of one recipe (one and two): mean 0.375")[2][:300]
    assert row.count("0.38") == len(COMPONENTS)
    assert json.loads(numbers.read_text())["suite"]["policies"][0]["name"] == "two"


def test_page_has_the_second_engine_where_it_was_measured(suite_result):
    assert not suite_section.section(suite_result)["second_engine"]
    engine = {
        "engines": [{"name": "MuJoCo"}, {"name": "Drake"}],
        "commands": [
            {"command": [0.3, 0.5], "here": [0.29, 0.5], "there": [0.3, None], "falls_here": 0, "falls_there": 2}
        ],
        "largest_change": {"straight": None, "turning": -0.17},
    }
    found = suite_section.section({**suite_result, "second_engine": engine})
    table = found["tables"][-1]
    assert found["second_engine"]
    assert table.rows == [["0.3 m/s, 0.5 rad/s", "0.290 / 0.500", "0.300 / -", "0", "2"]]
    assert table.note.endswith("Largest change of a commanded velocity: straight -, turning -17 %")


@pytest.mark.parametrize("options", [["--quick"], ["--seed", "1600000"]])
@pytest.mark.parametrize("program", [["evaluate", "flat"], ["compare", "flat", "rough"]])
def test_options_of_the_suite_need_it(program, options, capsys):
    assert main([*program, *options]) == 2
    assert f"{options[0]}: found without --suite" in capsys.readouterr().err


@pytest.mark.slow
def test_evaluate_prints_scores_and_writes_results(
    run_directory, suite_result, comparison, tmp_path, monkeypatch, capsys, without_figures
):
    """The program with the comparison and the suite that were made before."""
    asked = []

    def run(measured, suite, progress, zero_action):
        asked.append((measured.name, suite.quick, zero_action))
        return {**suite_result, "seed": suite.seed}

    monkeypatch.setattr("quadruped_env.evaluation.suite.suite.run_suite", run)
    monkeypatch.setattr("quadruped_env.api.compare", lambda *_, **__: comparison)
    arguments = ["evaluate", str(run_directory), "--suite", "--quick", "--no-video", "-o", str(tmp_path / "out")]
    assert main(arguments) == 0
    assert asked == [("20260101-000000-ppo", True, True)]
    out = capsys.readouterr().out
    assert re.search(r"score +commands +joystick +gait", out)
    assert f"{suite_result['score']['total']:.3f}" in out
    stored = json.loads((tmp_path / "out" / "suite.json").read_text())
    assert stored["seed"] in SEEDS
    assert f"--suite --quick --seed {stored['seed']}" in stored["command_line"]
    assert f"suite seed: {stored['seed']}" in out
    assert main([*arguments, "--seed", "1612345"]) == 0
    assert json.loads((tmp_path / "out" / "suite.json").read_text())["seed"] == 1612345
