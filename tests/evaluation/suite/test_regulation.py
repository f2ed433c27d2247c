"""Regulation: what counts as kept, and the incline, against hand-computed values and the simulated motion."""

import math
from dataclasses import replace

import numpy as np
import pytest

from quadruped_env.evaluation.suite import steady
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.evaluation.suite.suite import PARTS
from quadruped_env.evaluation.suite.suite_definition import Disturbance, full_suite
from quadruped_env.policies import GaitController, ZeroController
from quadruped_env.task import TaskConfig

PART = replace(full_suite().regulation, commands=((0.3, 0.0), (-0.2, 0.0), (0.3, 0.5)))
COMMANDS = np.array(PART.commands)[:, None]


@pytest.mark.parametrize(
    ("error", "expected"),
    [
        ((0.0, 0.0), [1, 1, 1]),
        ((0.04, 0.1), [1, 1, 1]),  # 20 % of 0.2 m/s and of 0.5 rad/s
        ((0.06, -0.1), [1, 0, 1]),
        ((-0.061, 0.0), [0, 0, 0]),
        ((0.0, 0.101), [0, 0, 0]),
        ((math.nan, 0.0), [0, 0, 0]),
    ],
)
def test_kept_is_a_fifth_of_the_command_or_the_tolerance_where_it_is_zero(error, expected):
    fallen = np.zeros((3, 1), dtype=bool)
    np.testing.assert_array_equal(steady.keeps(PART, COMMANDS + error, fallen)[:, 0], expected)
    assert not steady.keeps(PART, COMMANDS + error, ~fallen).any()


def test_score_is_the_mean_of_one_disturbance_and_of_all():
    part = replace(PART, factors=(Disturbance("a"), Disturbance("b")))
    result = {
        "a": {"kept": {"mean": 0.2}},
        "b": {"kept": {"mean": 0.6}},
        "hard": {"kept": {"mean": 0.0}, "held": {"mean": 0.9}},
    }
    assert PARTS["regulation"][1](result, part) == pytest.approx(0.65)


@pytest.mark.parametrize("slope", [16.0, -16.0])
def test_robots_stand_on_an_incline_as_on_its_plane(slope):
    """At rest on friction of 1.2 the tilt against gravity is the slope, nose up or down, and no robot falls."""
    part = replace(PART, num_seeds=2, seconds=2.0)
    factor = Disturbance("slope", {"start_heading": 0.0, "friction": (1.2, 1.2)}, slope)
    standing = Candidate("standing", ZeroController(), TaskConfig())
    rollout = steady.regulated(part, standing, factor, part.seeds, part.seconds)
    assert not rollout.fallen.any()
    pitch = np.degrees(2.0 * np.arctan2(rollout.orientation[-1, :, 2], rollout.orientation[-1, :, 0]))
    np.testing.assert_allclose(pitch, -slope, atol=3.0)
    along = rollout.base_position[-1, :, 0]
    assert np.abs(along).max() < 0.2
    assert rollout.contact[-1].all()


def test_measures_hold_the_signed_share_of_each_command():
    part = replace(
        PART, num_seeds=2, seconds=4.0, commands=((0.3, 0.0), (-0.2, 0.0)), factors=(Disturbance("nominal"),)
    )
    part = replace(part, together=Disturbance("hard"), together_seeds=1, together_seconds=2.0)
    result = steady.run_regulation(part, Candidate("tuned", GaitController(), TaskConfig()))
    ahead, back = result["nominal"]["commands"]
    assert ahead["share"][0] == pytest.approx(ahead["velocity"][0] / 0.3)
    assert (ahead["share"][1], back["share"][1]) == (None, None)
    assert ahead["share"][0] == pytest.approx(1.0, abs=0.25)
    assert back["share"][0] == pytest.approx(1.0, abs=0.25)
    assert result["hard"]["held"]["count"] == 2
