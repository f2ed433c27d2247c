"""One trial without Ray: its result, its scores at ASHA's rungs, its failures, and the results of a sweep."""

import csv
import json
from types import SimpleNamespace

import pytest
from trainings import SMALL, learn

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.sweep import Dimension, SweepConfig, sweep_results, trial
from quadruped_env.sweep.search import Proposals
from quadruped_env.sweep.sweep_driver import TrialBook
from quadruped_env.sweep.sweep_records import SweepFolder
from quadruped_env.training.recipes import with_recipe

BUDGET = {**SMALL, "timesteps": 320}


def make(fields):
    return with_recipe(fields, MINI_QUADRUPED)


@pytest.fixture
def sweep(tmp_path):
    """Function that makes a sweep with all of its trials' settings; the folder and its book."""

    def create(training=BUDGET, **definition):
        folder = SweepFolder.create(tmp_path / "sweeps", "ppo", SweepConfig(dict(training), **definition), "sweep")
        said = []
        book = TrialBook(folder, make, Proposals(folder.config), said.append)
        while book.begin() is not None:
            pass
        return folder, book, said

    return create


def run(folder, number=0, report=lambda values: None):
    return trial.run(folder.path, folder.identity, number, report)


def policy_of(directory):
    return (directory / "policy.safetensors").read_bytes()


def test_trial_leaves_a_run_and_its_result_which_stands(sweep, tmp_path):
    folder, _, _ = sweep(score="none", seeds=2)
    # As an earlier version of the package wrote them.
    settings = folder.trial(1).settings()
    settings["training"] |= {"device": "cpu", "went": 1}
    folder.trial(1).write_settings(settings)
    reports = []
    found = run(folder, 1, reports.append)
    assert (found["state"], found["timesteps"], found["score"]) == ("finished", 320, None)
    assert reports == [{"rung": 8, "score": -1.0, "state": "finished", "number": 1}]
    by_hand = learn(tmp_path / "runs", make({**BUDGET, "seed": 1}))
    # One thread in the trial, all cores here: networks this small are updated by one.
    assert policy_of(folder.path / "trials" / "0001" / found["run"]) == policy_of(by_hand)
    # A trial that has a result is not trained again.
    assert run(folder, 1) == found
    assert len(list((folder.path / "trials" / "0001").glob("2*"))) == 1


def test_scores_at_the_rungs_do_not_change_the_policy(sweep, tmp_path, monkeypatch):
    seen = []

    def score(policy):
        seen.append(policy.card["timesteps"])
        return 0.1 * len(seen)

    monkeypatch.setattr("quadruped_env.sweep.trial.rung_score", score)
    monkeypatch.setattr("quadruped_env.sweep.trial.final_score", lambda *arguments: None)
    folder, _, _ = sweep(seeds=2, scheduler="asha")
    reports = []
    found = run(folder, 0, reports.append)
    # Rungs at 1/8, 1/4 and 1/2 of 320 steps; an update has 32.
    assert seen == [64, 96, 160]
    assert [(entry["rung"], entry["score"]) for entry in reports[:-1]] == [(1, 0.1), (2, 0.2), (4, pytest.approx(0.3))]
    assert [row["timesteps"] for row in folder.trial(0).scores()] == [64.0, 96.0, 160.0]
    assert policy_of(folder.path / "trials" / "0000" / found["run"]) == policy_of(learn(tmp_path, make(BUDGET)))


@pytest.mark.slow
def test_real_scores_at_the_rungs_do_not_change_the_policy(sweep, tmp_path):
    folder, _, _ = sweep(seeds=2, scheduler="asha", rungs=1)
    found = run(folder)
    assert found["state"] == "finished", found
    (row,) = folder.trial(0).scores()
    assert 0.0 <= row["score"] <= 1.0
    own = folder.path / "trials" / "0000" / found["run"]
    assert policy_of(own) == policy_of(learn(tmp_path, make(BUDGET)))
    assert found["score"] == json.loads((own / "evaluation" / "suite.json").read_text())["score"]


def test_trial_whose_fields_do_not_fit_together_fails_alone(sweep):
    space = Dimension("batch_size", choices=(16, 4096))
    folder, book, said = sweep(score="none", space=(space,), settings=2, search="grid")
    for number in range(2):
        run(folder, number)
        book.ended(number)
    document = sweep_results.collect(folder, "sweep")
    assert [entry["state"] for entry in document["trials"]] == ["finished", "failed"]
    assert "batch_size: 4096 is more than the 32 samples" in document["trials"][1]["error"]
    assert "Traceback" in (folder.path / "trials" / "0001" / "error.txt").read_text()
    assert "trial 1, seed 0, batch_size=4096: failed (QuadrupedError: batch_size" in said[-1]
    assert "2 of 2 done" in said[-1]
    assert not book.missing()
    _, table = sweep_results.write(folder, document)
    with table.open() as file:
        rows = list(csv.DictReader(file))
    assert [(row["trial"], row["batch_size"], row["state"]) for row in rows] == [
        ("0", "16", "finished"),
        ("1", "4096", "failed"),
    ]


def test_directory_that_a_node_does_not_see_is_an_error(tmp_path):
    with pytest.raises(
        QuadrupedError, match=r"does not see this directory; put sweeps into a directory that all nodes"
    ):
        trial.run(tmp_path / "nowhere", "identity", 0, lambda values: None)


def test_book_of_a_resumed_sweep_has_the_values_and_the_trials_that_are_left(sweep):
    space = (Dimension("learning_rate", 1e-4, 1e-2, log=True), Dimension("hidden", choices=((8,), (16, 16))))
    folder, _, _ = sweep(space=space, settings=3, seeds=2)
    drawn = [folder.trial(number).settings()["values"] for number in range(6)]
    assert drawn[0] == drawn[1] != drawn[2]
    folder.trial(2).finish({"state": "finished", "score": {"total": 0.5, "components": {}}})

    told = {}
    source = SimpleNamespace(tell=lambda setting, values, score: told.update({setting: (values, score)}))
    book = TrialBook(folder, make, source, lambda line: None)  # all settings have their values
    assert book.missing() == {0, 1, 3, 4, 5}
    assert told == {}
    folder.trial(3).finish({"state": "finished", "score": {"total": 0.7, "components": {}}})
    book.ended(3)
    values, score = told[1]
    assert score == pytest.approx(0.6)
    assert isinstance(values["hidden"], tuple)
    assert [book.begin() for _ in range(5)] == [0, 1, 4, 5, None]


def test_trial_that_asha_stops_or_ray_gives_up_counts_once(sweep):
    folder, book, said = sweep(seeds=3, scheduler="asha")
    book.ended(0, stopped=True)
    book.ended(0, stopped=True)
    book.ended(1, error="the node was lost")
    book.ended(2)
    assert [(folder.trial(number).result() or {}).get("state") for number in range(3)] == ["stopped", "failed", None]
    assert book.missing() == {2}
    assert ["1 of 3 done" in said[0], "2 of 3 done" in said[1], len(said)] == [True, True, 2]
    document = sweep_results.collect(folder, "sweep")
    assert document["states"] == {"begun": 1, "failed": 1, "stopped": 1}
    assert document["best"] is None


def test_importance_is_that_of_the_field_that_the_score_depends_on():
    pytest.importorskip("optuna")
    space = (Dimension("gamma", 0.5, 1.0), Dimension("learning_rate", 1e-4, 1e-2, log=True))
    config = SweepConfig(space=space, settings=40)
    source = Proposals(config)
    settings = []
    for setting in range(40):
        values = source.values(setting)
        score = 1.0 - abs(values["gamma"] - 0.7)
        settings.append({"values": values, "suite": {"runs": [{"total": score}]}})
    found = sweep_results.importance(config, settings)["fields"]
    assert found["gamma"] > 0.8
    assert sum(found.values()) == pytest.approx(1.0, abs=1e-5)
    assert sweep_results.importance(config, settings[:3])["missing"] == "3 settings have a score; 4 are needed"
