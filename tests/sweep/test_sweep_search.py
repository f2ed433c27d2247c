"""The space of a sweep, as typed, and the settings that Optuna finds in it."""

import math
import statistics

import numpy as np
import pytest
from sweeps import TASK, finish, make_sweep

from quadruped_env import QuadrupedError
from quadruped_env.sweep import search
from quadruped_env.sweep.search import setting_values
from quadruped_env.sweep.space import ends, in_words, parse_dimension, size

pytest.importorskip("optuna")


@pytest.mark.parametrize(
    ("text", "expected", "count"),
    [
        ("gamma=0.9..1", [0.9, 1.0], math.inf),
        ("learning_rate=1e-4..1e-2:log", [1e-4, 1e-2], math.inf),
        ("n_epochs=2..8", [2, 8], 7),
        ("timesteps=1e5..2e5", [100_000, 200_000], 100_001),
        ("hidden=64x64,128x128", [[64, 64], [128, 128]], 2),
        ("hidden=[64, 64],[8]", [[64, 64], [8]], 2),
        ("algo=ppo,sac", ["ppo", "sac"], 2),
        ("symmetric=true,false", [True, False], 2),
        ("task.reward.weights.foot_slip=-1..0", [-1.0, 0.0], math.inf),
        ("task.randomization.friction=[0.6,1.0],[0.4,1.2]", [[0.6, 1.0], [0.4, 1.2]], 2),
    ],
)
def test_text_of_vary_gives_the_ends_as_the_fields_type(text, expected, count):
    name, distribution = parse_dimension(text, TASK)
    assert (name, ends(distribution), size(distribution)) == (text.partition("=")[0], expected, count)
    assert [type(end) for end in ends(distribution)] == [type(end) for end in expected]
    assert getattr(distribution, "log", False) == text.endswith(":log")


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("gama=0.9,0.99", "vary 'gama': not a field that can vary; did you mean gamma?"),
        ("seed=1..3", "seeds are set with --seeds"),
        ("task.reward.weights=1,2", "not a field that can vary"),
        ("gamma", r"vary gamma: expected LOW..HIGH, .*; found ''"),
        ("gamma=0.9", "a single value is set with its option of 'train'"),
        ("gamma=0.9,0.9", "different choices"),
        ("gamma=1..0.9", "the lower end comes first"),
        ("gamma=0..1:log", "vary gamma: expected"),
        ("gamma=0.1..1:exp", "vary gamma: expected"),
        ("gamma=0..inf", "vary gamma: expected"),
        ("n_epochs=1.5..8", "whole numbers are needed"),
        ("hidden=8,1x2y", "vary hidden: expected"),
    ],
)
def test_text_that_is_no_range_and_no_choices_is_an_error(text, error):
    with pytest.raises(QuadrupedError, match=error):
        parse_dimension(text, TASK)


def test_each_combination_of_choices_is_tried_once(tmp_path):
    sweep = make_sweep(tmp_path, "gamma=0.9,0.95", "n_epochs=1..3", "hidden=[8],[16]")
    found = [in_words(setting_values(sweep, setting)) for setting in range(sweep.settings)]
    assert len(set(found)) == len(found) == 12
    # Whoever asks again gets the same.
    assert [in_words(setting_values(sweep, setting)) for setting in reversed(range(12))] == found[::-1]


def test_more_trials_than_settings_is_an_error(tmp_path):
    with pytest.raises(QuadrupedError, match="trials: found 5, but a setting is tried once, and there are 4"):
        make_sweep(tmp_path, "gamma=0.9,0.95", "n_epochs=1..2", settings=5)


def regrets(tmp_path, told):
    """Regret of the best of 40 settings in three fields, for 10 seeds; without `told`, of random settings."""
    found = []
    for seed in range(10):
        fields = ("gamma=0.5..1", "learning_rate=1e-5..1e-1:log", "clip_range=0.05..0.8")
        sweep = make_sweep(tmp_path / f"{told}{seed}", *fields, settings=40, training={"seed": 1000 * seed})
        generator, best = np.random.default_rng(seed), math.inf
        for setting in range(40):
            if told:
                x, y, z = setting_values(sweep, setting).values()
            else:
                x, y, z = generator.uniform(0.5, 1.0), 10.0 ** generator.uniform(-5, -1), generator.uniform(0.05, 0.8)
            regret = (4.0 * (x - 0.8)) ** 2 + (math.log10(y) + 3.0) ** 2 / 4.0 + (2.0 * (z - 0.2)) ** 2
            best = min(best, regret)
            if told:
                finish(sweep, setting, 1.0 - regret, {"gamma": x})
        found.append(best)
    return statistics.median(found)


def test_search_finds_an_optimum_with_at_most_half_of_the_regret_of_random_settings(tmp_path, monkeypatch):
    monkeypatch.setattr("os.fsync", lambda descriptor: None)  # it takes most of the time
    assert regrets(tmp_path, told=True) <= 0.5 * regrets(tmp_path, told=False)


def test_worker_that_is_lost_while_it_asks_leaves_a_study_that_goes_on(tmp_path):
    sweep = make_sweep(tmp_path, "gamma=0.5..1", settings=3)
    first = setting_values(sweep, 0)
    journal = sweep.path / "optuna.log"
    with journal.open("a") as file:
        file.write('{"op_code": 4, "wor')  # the disk was full, or the process was killed
    journal.with_name("optuna.log.lock").symlink_to("optuna.log")
    second = setting_values(sweep, 1)
    assert setting_values(sweep, 0) == first != second


def test_each_worker_proposes_other_settings_from_the_beginning(tmp_path):
    sweep = make_sweep(tmp_path, "gamma=0.5..1", settings=4)
    for setting in range(4):
        setting_values(sweep, setting)  # each time with a sampler of its own, as in a new process
    assert len(search._study(sweep, 0).trials) == 4, "a repeated proposal is a further trial of the study"


def test_study_in_a_database_is_shared_and_its_address_is_in_no_file(tmp_path, monkeypatch):
    monkeypatch.setenv("OPTUNA_STORAGE", f"sqlite:///{tmp_path}/secret.db")
    sweep = make_sweep(tmp_path, "gamma=0.5..1", settings=2)
    values = setting_values(sweep, 0)
    assert setting_values(sweep, 0) == values
    assert not (sweep.path / "optuna.log").exists()
    assert not any("secret" in path.read_text() for path in sweep.path.rglob("*") if path.is_file())
    monkeypatch.delenv("OPTUNA_STORAGE")
    with pytest.raises(QuadrupedError, match="the database of OPTUNA_STORAGE: cannot be used"):
        setting_values(sweep, 1)
