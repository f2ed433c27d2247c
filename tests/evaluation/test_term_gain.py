"""Rows of the reward terms that a user defined or changed: values by hand, and terms that cannot move."""

import dataclasses

import numpy as np
import pytest
from comparisons import random_policy
from synthetic import DT, synthetic_rollout

from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.evaluation.learning_gain import gain_rows
from quadruped_env.evaluation.term_gain import TermGain, changed_terms, term_gains, term_rows
from quadruped_env.task import TaskConfig, load_task_file
from quadruped_env.task.sections import values_for
from quadruped_env.training.recipes import RECIPES

OWN = """
from quadruped_env.task import reward
@reward(weight=-0.5, unit="m")
def height(context, wanted: float = 0.1):
    return context.base_height - wanted
@reward(weight=1.0)
def upright(context):
    return 1.0 + 0.0 * context.base_height
"""


def estimate(low, high):
    return Estimate(0.5 * (low + high), low, high, 8)


@pytest.fixture(scope="module")
def definition(tmp_path_factory):
    file = tmp_path_factory.mktemp("task") / "own.py"
    file.write_text(OWN)
    return load_task_file(file)


def test_own_replaced_and_changed_terms_have_rows_and_no_others(definition):
    assert changed_terms(TaskConfig(), "flat") == {}
    assert changed_terms(TaskConfig(definition=definition), "flat") == {"upright": "1", "height": "m"}
    config = TaskConfig.from_dict({"reward": {"weights": {"landing": -5.0}, "yaw_rate_std": 0.2}})
    assert changed_terms(config, "flat") == dict.fromkeys(("track_forward_velocity", "track_yaw_rate"), "1") | {
        "landing": "m^2/s^3"
    }


def test_what_a_recipe_sets_is_no_change_of_the_user(definition):
    task = values_for(RECIPES["walker"].task, TaskConfig().robot)
    config = TaskConfig.from_dict({"reward": task["reward"]})
    assert changed_terms(config, "walker") == {}
    assert set(changed_terms(config, "")) == {"steady_error", "gait_clock", "landing", "action_rate"}
    back = TaskConfig.from_dict({"reward": {"weights": task["reward"]["weights"]}})
    assert changed_terms(back, "walker") == {"gait_clock": "1"}, "with the default height of the steps"


def rewards(values, weight):
    """Rollout with two terms: one has these values in every step, one per episode, and the other is 0."""
    terms = np.multiply.outer(np.full(100, weight * DT), np.outer(values, [1.0, 0.0]))
    return dataclasses.replace(
        synthetic_rollout(100, len(values), reward_terms=terms), term_names=("height", "upright")
    )


def test_row_of_a_term_computed_by_hand(definition, tmp_path):
    policy = random_policy("residual", definition=definition).with_card({"recipe": "flat"})
    progress = tmp_path / "progress.csv"
    progress.write_text("timesteps,reward_height\n100,-0.04\n200,-0.01\n")
    ours, zeros = rewards([0.01, 0.02, 0.03], -0.5), rewards([0.04, 0.06, 0.08], -0.5)
    upright, height = term_gains(policy, ours, zeros, progress)
    assert (height.policy.mean, height.zero.mean, height.difference.mean) == pytest.approx((0.02, 0.06, -0.04))
    # Of three pairs with the differences -0.03, -0.04 and -0.05.
    assert (height.difference.low, height.difference.high) == pytest.approx((-0.05, -0.03), abs=0.003)
    rows = [
        ("upright", "1", "-", "0", "0", "+0.00", "not learned"),
        ("height (m)", "-0.5", "0.08", "0.02", "0.06", "-0.01", "better by 67 %"),
    ]
    assert term_rows({"terms": [upright.to_dict(), height.to_dict()]}) == rows
    assert (height.first, upright.first) == (0.08, None), "progress.csv has no such column"


@pytest.mark.parametrize(
    ("weight", "zero", "low", "high", "result"),
    [
        (-2.0, 1.0, -0.6, -0.4, "better by 50 %"),
        (2.0, 1.0, -0.6, -0.4, "worse by 50 %"),
        (2.0, -1.0, 0.4, 0.6, "better by 50 %"),
        (2.0, 1.0, 0.04, 0.06, "hardly learned by 5 %"),
        (2.0, 0.0, 0.04, 0.06, "better"),
        (2.0, 0.0, 0.0, 0.0, "not learned"),
        (2.0, 1.0, -0.1, 0.9, "not learned"),
        (-2.0, 1.0, -0.9, 0.0, "not learned"),
        (0.0, 1.0, 0.4, 0.6, "not counted"),
    ],
)
def test_result_needs_an_interval_on_the_side_of_the_weight(weight, zero, low, high, result):
    mean = estimate(zero, zero)
    assert TermGain("term", "m", weight, None, mean, mean, estimate(low, high)).result == result


def test_measures_are_in_mm_and_show_a_change_only_beyond_chance():
    one = {"name": "height", "metric": "base_height", "policy": 0.1691, "zero": 0.1839}
    rows = {}
    for low, high in ((-0.0150, -0.0146), (-0.03, 0.001), (None, None)):
        difference = {"mean": -0.0148, "low": low, "high": high}
        own = {"commands_met": {"count": 0}, "falls": {"mean": 0.0}, "electrical_power": {"mean": 1.0}}
        document = {"measures": [{**one, "difference": difference}], "policy": own, "zero": own}
        rows[high], _ = gain_rows(document)
    assert rows[-0.0146] == ("height", "169 mm", "", "", "184 mm", "", "", "-15 mm")
    assert rows[0.001][-1] == rows[None][-1] == ""
