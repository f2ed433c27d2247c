"""The files of a small sweep without any training, and of the suite's results."""

import json

from quadruped_env.evaluation.results import COMPONENTS
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.sweep import Dimension, SweepConfig
from quadruped_env.sweep.search import Proposals
from quadruped_env.sweep.sweep_driver import TrialBook
from quadruped_env.sweep.sweep_records import SweepFolder
from quadruped_env.sweep.sweep_results import collect, table, write
from quadruped_env.training.recipes import with_recipe

SCORE = {"total": 0.5, "components": dict.fromkeys(COMPONENTS, 0.5)}
SUITE_RESULTS = {
    "suite": {"name": "mq-eval", "version": 1, "quick": True, "sha256": "a"},
    "conditions": {"robot": {"name": "mini"}, "mujoco": "4"},
    "name": "standing",
    "score": SCORE,
    **{name: {} for name in COMPONENTS},
    "terrain": {"stairs": {"highest_level": 3}},
    "policy": {"name": "standing", "card": {}},
}


def make(fields):
    """Settings of a training, as the program makes them."""
    return with_recipe(fields, MINI_QUADRUPED)


def write_sweep(parent):
    """A sweep of two settings and two seeds: three trials with results, and one that has begun."""
    space = (
        Dimension("gamma", 0.5, 1.0),
        Dimension("hidden", choices=((8,), (16, 16))),
        Dimension("task.reward.weights.foot_slip", -1.0, 0.0),
    )
    config = SweepConfig({"timesteps": 2048, "seed": 3}, (), space, 2, 2, scheduler="asha")
    folder = SweepFolder.create(parent, "ppo", config, "sweep")
    book = TrialBook(folder, make, Proposals(config), lambda line: None)
    while (number := book.begin()) is not None:
        trial = folder.trial(number)
        trial.write_scores([{"rung": 1, "timesteps": 256, "seconds": 1.0, "score": 0.1 * number}])
        if number == 3:
            continue
        evaluation = trial.path / "run" / "evaluation"
        evaluation.mkdir(parents=True)
        (evaluation / "suite.json").write_text(json.dumps(SUITE_RESULTS))
        own = {"run": "run", "timesteps": 2048, "training_seconds": 1.0, "scoring_seconds": 1.0, "score": SCORE}
        trial.finish({"state": "finished", "node": "here", "peak_memory_mb": 9.0, **own})
    return folder


def read_sweep(path):
    """Read all files of a sweep, and make its results; a damaged trial is an error."""
    folder = SweepFolder.open(path)
    make(folder.config.fields_of({}, 0))
    for number, _, _ in folder.config.trials():
        folder.trial(number).check()
    resume(path)


def resume(path):
    """Go on with a sweep up to its results, without training; the lines that it prints."""
    folder, said = SweepFolder.open(path), []
    book = TrialBook(folder, make, Proposals(folder.config), said.append)
    for number in set(range(len(folder.config))) - book.missing():
        book.ended(number)
    found = collect(folder, "sweep")
    write(folder, found)
    table(found)
    while book.begin() is not None:
        pass
    return said
