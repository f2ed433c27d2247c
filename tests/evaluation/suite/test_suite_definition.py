"""The suite as data: version, hash and seeds."""

import hashlib
from dataclasses import replace

import numpy as np
import pytest
from half_robot import ROBOT, TIME

from quadruped_env import QuadrupedError
from quadruped_env.evaluation.results import COMPONENTS
from quadruped_env.evaluation.rollout import FIRST_SEED
from quadruped_env.evaluation.suite import changing, suite_definition
from quadruped_env.evaluation.suite.suite_definition import SEEDS, for_robot, full_suite, quick_suite
from quadruped_env.robot import MINI_QUADRUPED, QuadrupedDesign
from quadruped_env.simulation import TERRAINS
from quadruped_env.task import PRESETS
from quadruped_env.training.train import train
from quadruped_env.training.train_config import TrainConfig
from quadruped_env.utils.seeds import EVALUATION_SEEDS, check_training_seeds

SHA256_OF_VERSION_3 = "0dff12677316e5bb505614793fb577bec6eb423e3f558c05bc79753348abc9f3"
"""Changes if any number of the definition does, the preset `hard` and the terrains included: that is a new version."""


def test_hash_of_the_version_is_the_one_that_results_were_made_with():
    assert (suite_definition.NAME, suite_definition.VERSION) == ("mq-eval", 3)
    assert full_suite().sha256 == SHA256_OF_VERSION_3


def test_commands_that_are_drawn_are_the_ones_that_results_were_made_with():
    """Their ranges are not in the hash of the version."""
    joystick = full_suite().joystick
    schedules = [changing.schedule(joystick, seed, 0.02) for seed in joystick.seeds[:4]]
    found = [
        hashlib.sha256(np.array(values).tobytes()).hexdigest()[:16]
        for values in (full_suite().commands.drawn, schedules)
    ]
    assert found == ["cd0f21c7cc637155", "0778e680c3798555"]


def test_hash_covers_the_values_of_the_preset_and_of_the_terrains(monkeypatch):
    before = suite_definition.Suite().sha256
    document = full_suite().to_dict()
    assert document["regulation"]["together"]["randomization"]["push_speed"] == [0.75, 0.75]
    assert document["regulation"]["together"]["randomization"].keys() == PRESETS["hard"].keys()
    assert document["terrain"]["shapes"]["stairs"] == {"height": 0.02, "run": 0.2}
    changed = {**PRESETS["hard"], "friction": (0.4, 1.2)}
    monkeypatch.setattr(suite_definition, "PRESETS", {**PRESETS, "hard": changed})
    suite = replace(full_suite(), regulation=suite_definition.Regulation(4))
    assert suite.sha256 != before


def test_commands_are_drawn_evenly_and_none_is_close_to_standing():
    drawn = np.array(full_suite().commands.drawn)
    assert drawn.shape == (256, 2)
    moving = drawn[:248]
    assert not drawn[248:].any()
    assert (np.abs(moving) >= (0.1, 0.2)).any(axis=1).all()
    assert (moving >= (-0.3, -0.8)).all()
    assert (moving <= (0.6, 0.8)).all()
    counts, _, _ = np.histogram2d(*moving.T, bins=4, range=((-0.3, 0.6), (-0.8, 0.8)))
    assert counts.max() <= 19  # 256 over 16 fields are 16, less in those around standing
    assert counts.min() >= 8
    assert len(np.unique(moving, axis=0)) == 248


def test_regulation_covers_friction_payload_offsets_and_slopes_both_ways():
    factors = {factor.name: factor for factor in full_suite().regulation.factors}
    assert factors["friction_1.2"].randomization == {"friction": (1.2, 1.2)}
    assert factors["payload_-0.5_kg"].randomization == {"payload": (-0.5, -0.5)}
    assert factors["encoder_offset_0.04"].randomization == {"encoder_offset": 0.04}
    assert (factors["up_16_degrees"].slope, factors["down_4_degrees"].slope) == (16.0, -4.0)
    latencies = [factor.randomization for name, factor in factors.items() if name.startswith("latency")]
    assert latencies == [{"action_latency": (s, s)} for s in (0.02, 0.04, 0.06, 0.08)]
    assert {(0.5, 0.0), (0.0, 0.5)} <= set(full_suite().regulation.commands)
    assert len(factors) == 1 + 5 + 4 + 2 + 4 + 8


def test_suite_of_another_robot_has_the_same_numbers_in_its_units():
    full, half = full_suite(), for_robot(full_suite(), ROBOT)
    units = TIME, 1.0 / TIME
    np.testing.assert_allclose(half.commands.drawn, np.multiply(full.commands.drawn, units), rtol=0, atol=2e-4)
    for part in ("gait", "pushes", "regulation"):
        np.testing.assert_allclose(getattr(half, part).commands, np.multiply(getattr(full, part).commands, units), 1e-5)
    assert half.commands.axes["left"][-1] == (0.0, 2.26274)
    tolerance = half.commands.tolerance
    assert (tolerance.met, tolerance.missed) == ((0.0353553, 0.141421), (0.0707107, 0.282843))
    assert (tolerance.least, tolerance.share) == ((0.0141421, 0.0707107), 0.1)
    assert {getattr(half, part).tolerance for part in COMPONENTS} == {tolerance}
    assert half.transients.changes[0].then == (0.353553, 0.0)
    np.testing.assert_allclose(half.pushes.unit, (TIME, TIME, 0.5 * TIME, *(2.0 / TIME,) * 3), 1e-5)
    assert (half.gait.bounce, half.gait.full_clearance) == (0.001, 0.005)
    assert (half.gait.soft_landing, half.gait.little_slip) == (0.141421, 0.0353553)
    assert half.terrain.command == (0.282843, 0.0)
    # Scaled where they are used, or the same for all.
    assert half.regulation.factors == full.regulation.factors
    assert (half.gait.seconds, half.transients.window) == (full.gait.seconds, full.transients.window)
    assert for_robot(full, MINI_QUADRUPED) == full


def test_suite_pushes_a_narrow_robot_less():
    """As in training: what tips a rigid robot over follows the distance of its feet over its height."""
    full = full_suite()
    narrow = QuadrupedDesign(name="narrow", base_size=(0.3, 0.07, 0.08), hip_offset=(0.15, 0.06)).robot()  # not 0.1
    pushes = replace(full.pushes, unit=(0.6, 0.6, 0.3, 1.2, 1.2, 1.2))
    assert for_robot(full, narrow) == replace(full, pushes=pushes)


def test_every_terrain_with_levels_is_crossed():
    assert set(full_suite().terrain.kinds) == {entry.name for entry in TERRAINS if entry.hardest}


def test_quick_suite_is_marked_and_has_every_part():
    full, quick = full_suite().to_dict(), quick_suite().to_dict()
    assert (full["quick"], quick["quick"]) == (False, True)
    assert full.keys() == quick.keys()
    for part in COMPONENTS:
        assert full[part].keys() == quick[part].keys()
        assert quick[part]["num_seeds"] < full[part]["num_seeds"]
    assert (full_suite().label, quick_suite().label) == ("mq-eval 3", "mq-eval 3 (quick)")


def test_seeds_change_every_episode_and_not_the_definition():
    """Nobody can tune a policy on commands, starts, pushes or worlds that are drawn afterwards."""
    one, other = full_suite(1_600_000), full_suite(1_700_123)
    assert (one.seed, one.sha256) == (1_600_000, other.sha256)
    assert "first_seed" not in str(one.to_dict())
    assert not {*one.commands.drawn[:248]} & {*other.commands.drawn}
    for part in COMPONENTS:
        assert getattr(one, part).first_seed == getattr(other, part).first_seed - 100_123
    assert full_suite(1_600_000) == full_suite().seeded(1_600_000)
    assert quick_suite(1_700_123).seeded(SEEDS.start) == quick_suite()
    drawn = {suite_definition.draw_seed() for _ in range(20)}
    assert len(drawn) > 15
    assert drawn <= set(SEEDS)


@pytest.mark.parametrize("seed", [0, SEEDS.start - 1, SEEDS.stop])
def test_seeds_of_other_evaluations_are_refused(seed):
    with pytest.raises(QuadrupedError, match=rf"--seed: expected 1500000 to 1899999 for the suite; found {seed}"):
        full_suite(seed)


def test_seeds_of_the_parts_are_reserved_and_differ_from_each_other_and_from_other_evaluations():
    seen = set(range(FIRST_SEED, FIRST_SEED + 10_000))
    for part in COMPONENTS:
        seeds = getattr(full_suite(SEEDS.stop - 1), part).seeds
        assert EVALUATION_SEEDS.start <= seeds.start < seeds.stop <= EVALUATION_SEEDS.stop
        assert not seen.intersection(seeds)
        seen.update(seeds)
    full = full_suite()
    assert len(full.pushes.sizes) * full.pushes.num_seeds < 10_000
    assert full.regulation.together_seeds < 10_000


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
    with pytest.raises(QuadrupedError, match=r"seed: found 999745 to 1000000; .*choose a smaller seed"):
        TrainConfig(seed=1_000_000 - 255, num_envs=256)
