"""Definition of a sweep: its trials, their settings, its checks and its files."""

import json
from concurrent.futures import ThreadPoolExecutor

import pytest

from quadruped_env import QuadrupedError
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.sweep import Dimension, SweepConfig
from quadruped_env.sweep.search import Proposals
from quadruped_env.sweep.sweep_records import SweepFolder
from quadruped_env.training.recipes import with_recipe

RATE = Dimension("learning_rate", 1e-4, 1e-2, log=True)
HIDDEN = Dimension("hidden", choices=((8,), (16, 16)))
SLIP = Dimension("task.reward.weights.foot_slip", -1.0, 0.0)


def make(fields):
    return with_recipe(fields, MINI_QUADRUPED)


def test_trials_are_every_seed_of_every_setting():
    config = SweepConfig({"seed": 5}, space=(RATE,), settings=2, seeds=3)
    assert list(config.trials()) == [(0, 0, 5), (1, 0, 6), (2, 0, 7), (3, 1, 5), (4, 1, 6), (5, 1, 7)]


def test_fields_of_a_trial_are_those_of_the_training_with_its_values():
    task = {"reward": {"weights": {"fall": -9.0}}}
    config = SweepConfig({"timesteps": 99, "task": task}, space=(RATE, SLIP), settings=2)
    assert config.fields_of({"learning_rate": 1e-3, SLIP.field: -0.5}, 7) == {
        "timesteps": 99,
        "seed": 7,
        "learning_rate": 1e-3,
        "task": {"reward": {"weights": {"fall": -9.0, "foot_slip": -0.5}}},
    }
    assert task == {"reward": {"weights": {"fall": -9.0}}}


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"seeds": 0}, r"--seeds: expected 1 or more, and at most 1000000000; found 0"),
        ({"settings": 3}, r"--trials: found 3 without a field that varies; .*--seeds 3"),
        ({"space": (RATE,), "search": "grid"}, r"a grid needs choices, and learning_rate has a range"),
        ({"space": (HIDDEN,), "search": "grid", "settings": 3}, r"found 3; this grid has 2 settings"),
        ({"scheduler": "asha", "seeds": 4, "training": {"seconds": 5.0}}, r"give --timesteps in place of --seconds"),
        ({"scheduler": "asha", "seeds": 4, "score": "none"}, r"--score: found none with --scheduler asha"),
        ({"space": (RATE, RATE), "settings": 2}, r"--vary learning_rate: found twice"),
        ({"seeds": 100_001}, r"--trials: 100001 trainings are more than 100000"),
        ({"seeds": 9, "training": {"seed": 999_800}}, r"--seeds: found 999800 to .*reserved for evaluation"),
    ],
)
def test_definition_that_does_not_fit_together_is_an_error(changes, message):
    with pytest.raises(QuadrupedError, match=message):
        SweepConfig(**changes)


def test_end_of_a_range_that_no_training_accepts_is_an_error_before_the_first_trial():
    config = SweepConfig(space=(Dimension("gamma", 0.9, 1.5),), settings=2)
    with pytest.raises(QuadrupedError, match=r"--vary gamma: 1\.5 is not valid: gamma: expected more than 0"):
        config.check(make)
    tilt = SweepConfig(space=(Dimension("task.termination.max_tilt", -2.0, 1.0),), settings=2)
    with pytest.raises(QuadrupedError, match=r"--vary task\.termination\.max_tilt: -2\.0 is not valid"):
        tilt.check(make)
    SweepConfig(space=(RATE, HIDDEN, SLIP), settings=2).check(make)


def test_random_settings_depend_on_their_number_alone_and_a_grid_has_each_combination_once():
    config = SweepConfig(space=(RATE, HIDDEN), settings=8)
    forward = [Proposals(config).values(setting) for setting in range(8)]
    source = Proposals(config)
    assert [source.values(setting) for setting in reversed(range(8))] == forward[::-1]
    assert len({values["learning_rate"] for values in forward}) == 8
    config = SweepConfig(space=(HIDDEN, Dimension("activation", choices=("elu", "tanh"))), settings=4, search="grid")
    found = [tuple(Proposals(config).values(setting).values()) for setting in range(4)]
    assert sorted(found) == [((8,), "elu"), ((8,), "tanh"), ((16, 16), "elu"), ((16, 16), "tanh")]


def test_optuna_proposes_better_settings_with_the_results_of_an_earlier_process():
    pytest.importorskip("optuna")
    config = SweepConfig(space=(Dimension("gamma", 0.5, 1.0), HIDDEN), settings=60, search="optuna")

    def score(values):
        return 1.0 - abs(values["gamma"] - 0.7) + (0.1 if values["hidden"] == (8,) else 0.0)

    first = Proposals(config)
    done = {}
    for setting in range(30):
        done[setting] = first.values(setting)
        first.tell(setting, done[setting], score(done[setting]) if setting != 3 else None)
    later = Proposals(config)
    for setting, values in done.items():
        later.tell(setting, values, score(values))
    found = []
    for setting in range(30, 50):
        found.append(later.values(setting))
        later.tell(setting, found[-1], score(found[-1]))
    assert all(0.5 <= values["gamma"] <= 1.0 and values["hidden"] in HIDDEN.choices for values in found)
    # Random settings are 0.13 away from the best one in the mean.
    assert sum(abs(values["gamma"] - 0.7) for values in found) / 20 < 0.09


def test_sweep_is_read_from_its_files_as_it_was_written(tmp_path):
    config = SweepConfig({"hidden": (8, 8), "seed": 3}, ("terrain",), (RATE, HIDDEN, SLIP), 2, 3, "optuna", "asha")
    made = SweepFolder.create(tmp_path, "ppo", config, "sweep")
    assert SweepFolder.open(made.path) == made


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"format_version": 9}, r"sweep\.json: format_version: expected 1; found 9"),
        ({"sweep": 3}, r"sweep\.json: not the definition of a sweep"),
        ({"space": [1]}, r"sweep\.json: not the definition of a sweep"),
        ({"seeds": 0}, r"sweep\.json: --seeds: expected 1 or more"),
    ],
)
def test_damaged_definition_is_an_error_that_names_its_file(tmp_path, change, message):
    folder = SweepFolder.create(tmp_path, "ppo", SweepConfig(), "sweep")
    file = folder.path / "sweep.json"
    file.write_text(json.dumps({**json.loads(file.read_text()), **change}))
    with pytest.raises(QuadrupedError, match=message):
        SweepFolder.open(folder.path)


def test_directory_without_a_sweep_is_an_error_that_says_what_it_is(tmp_path):
    (run := tmp_path / "run").mkdir()
    (run / "config.json").write_text("{}")
    for path, message in {
        tmp_path / "nowhere": r"--resume: .*there is no such directory",
        tmp_path: r"it has no sweep\.json",
        run: r"run directory of one training: continue it with 'train --resume'",
    }.items():
        with pytest.raises(QuadrupedError, match=message):
            SweepFolder.open(path)


def test_trial_of_another_sweep_is_refused(tmp_path):
    one, other = (SweepFolder.create(tmp_path, name, SweepConfig(), "sweep") for name in ("one", "other"))
    one.trial(0).write_settings({"number": 0, "setting": 0, "seed": 0, "values": {}, "training": {}})
    one.trial(0).finish({"state": "finished"})
    (one.path / "trials" / "0000").rename(other.path / "trials" / "0000")
    with pytest.raises(QuadrupedError, match=r"0000/trial\.json: this is a trial of another sweep"):
        other.trial(0).settings()
    with pytest.raises(QuadrupedError, match=r"0000/result\.json: this is a trial of another sweep"):
        other.trial(0).result()


def test_first_result_of_a_trial_stands(tmp_path):
    trial = SweepFolder.create(tmp_path, "ppo", SweepConfig(), "sweep").trial(0)
    trial.path.mkdir()
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(lambda number: trial.finish({"state": "finished", "by": number})["by"], range(8)))
    assert len(set(found)) == 1
    assert [path.name for path in trial.path.iterdir()] == ["result.json"]


def test_second_process_on_a_sweep_is_refused(tmp_path):
    folder = SweepFolder.create(tmp_path, "ppo", SweepConfig(), "sweep")
    message = r"another process runs the sweep in"
    with folder.locked(), pytest.raises(QuadrupedError, match=message), folder.locked():
        pass
    with folder.locked():
        pass
