"""The suite as data: version, hash and seeds."""

import hashlib
import json
from dataclasses import replace

import pytest

from quadruped_env import QuadrupedError
from quadruped_env.evaluation.rollout import FIRST_SEED
from quadruped_env.evaluation.suite import suite_definition
from quadruped_env.evaluation.suite.suite_definition import full_suite, quick_suite
from quadruped_env.simulation import TERRAINS
from quadruped_env.task import PRESETS
from quadruped_env.training.train import train
from quadruped_env.training.train_config import TrainConfig
from quadruped_env.utils.seeds import EVALUATION_SEEDS, check_training_seeds

SHA256_OF_VERSION_1 = "378825e1babf0dc0ad4ce135a2dc6395bc33f735079768d8470e9b8b3b3e3e23"
"""Changes if any number of the definition does, the preset `hard` and the terrains included: that is a new version."""
PARTS = ("commands", "gait", "transients", "pushes", "disturbances", "terrain", "recovery")


def test_hash_of_the_version_is_the_one_that_results_were_made_with():
    assert (suite_definition.NAME, suite_definition.VERSION) == ("mq-eval", 1)
    assert full_suite().sha256 == SHA256_OF_VERSION_1


def test_hash_is_that_of_the_definition_as_json():
    suite = full_suite()
    text = json.dumps(suite.to_dict(), sort_keys=True, separators=(",", ":"))
    assert suite.sha256 == hashlib.sha256(text.encode()).hexdigest()
    # Read back from a file, it has the same hash.
    again = json.dumps(json.loads(text), sort_keys=True, separators=(",", ":"))
    assert hashlib.sha256(again.encode()).hexdigest() == suite.sha256


@pytest.mark.parametrize(
    "change",
    [
        lambda s: replace(s, commands=replace(s.commands, num_seeds=5)),
        lambda s: replace(s, pushes=replace(s.pushes, sizes=(0.0, 1.0))),
        lambda s: replace(s, terrain=replace(s.terrain, terrain_seed=1)),
        lambda s: replace(s, transients=replace(s.transients, band=0.2)),
        lambda s: replace(s, quick=True),
    ],
)
def test_every_change_of_a_number_changes_the_hash(change):
    assert change(full_suite()).sha256 != full_suite().sha256


def test_hash_covers_the_values_of_the_preset_and_of_the_terrains(monkeypatch):
    before = suite_definition.Suite().sha256
    document = full_suite().to_dict()
    assert document["disturbances"]["together"]["randomization"]["push_speed"] == [0.75, 0.75]
    assert document["disturbances"]["together"]["randomization"].keys() == PRESETS["hard"].keys()
    assert document["terrain"]["shapes"]["stairs"] == {"height": 0.02, "run": 0.2}
    changed = {**PRESETS["hard"], "friction": (0.4, 1.2)}
    monkeypatch.setattr(suite_definition, "PRESETS", {**PRESETS, "hard": changed})
    suite = replace(full_suite(), disturbances=suite_definition.Disturbances(12, full_suite().disturbances.first_seed))
    assert suite.sha256 != before


def test_every_quantity_of_hard_is_a_factor():
    varied = {name for factor in full_suite().disturbances.factors for name in factor.randomization}
    # Where the payload sits matters only with a payload, and then as the offset of the centre of mass does.
    assert varied == PRESETS["hard"].keys() - {"payload_position"}


def test_every_terrain_with_levels_is_crossed():
    assert set(full_suite().terrain.kinds) == {entry.name for entry in TERRAINS if entry.hardest}


def test_quick_suite_is_marked_and_has_every_part():
    full, quick = full_suite().to_dict(), quick_suite().to_dict()
    assert (full["quick"], quick["quick"]) == (False, True)
    assert full.keys() == quick.keys()
    for part in PARTS:
        assert full[part].keys() == quick[part].keys()
        assert quick[part]["num_seeds"] < full[part]["num_seeds"]
    assert (full_suite().label, quick_suite().label) == ("mq-eval 1", "mq-eval 1 (quick)")


def test_seeds_of_the_parts_are_reserved_and_differ_from_each_other_and_from_other_evaluations():
    seen = set(range(FIRST_SEED, FIRST_SEED + 10_000))
    for part in PARTS:
        seeds = set(getattr(full_suite(), part).seeds)
        assert seeds <= set(EVALUATION_SEEDS)
        assert not seeds & seen
        seen |= seeds
    assert full_suite().terrain.terrain_seed in EVALUATION_SEEDS
    together = full_suite().disturbances
    assert together.first_seed + together.together_seeds <= full_suite().terrain.first_seed


@pytest.mark.parametrize(("first", "count"), [(1_000_000, 1), (1_999_999, 1), (999_999, 2), (0, 3_000_000)])
def test_no_training_may_use_a_seed_of_an_evaluation(first, count):
    with pytest.raises(QuadrupedError, match=r"--seed: found .*1000000 to 1999999 are reserved for evaluation"):
        check_training_seeds("--seed", first, count)


@pytest.mark.parametrize(("first", "count"), [(0, 1_000_000), (999_999, 1), (2_000_000, 10)])
def test_other_seeds_are_free(first, count):
    check_training_seeds("--seed", first, count)


def test_the_ground_of_a_training_may_use_none(tmp_path):
    settings = TrainConfig(num_envs=2, batch_size=2, task={"terrain": {"name": "rough", "seed": 1_500_000}})
    with pytest.raises(QuadrupedError, match=r"config\.terrain\.seed: found 1500000; "):
        train(settings, tmp_path, "")
    assert not list(tmp_path.iterdir())


def test_training_counts_the_seeds_of_all_its_envs():
    TrainConfig(seed=1_000_000 - 256, num_envs=256)
    with pytest.raises(QuadrupedError, match=r"--seed: found 999745 to 1000000; .*choose a smaller seed"):
        TrainConfig(seed=1_000_000 - 255, num_envs=256)
