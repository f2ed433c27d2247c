"""The verdict on a comparison and its worst episodes, on invented numbers."""

import dataclasses
import math

import numpy as np
import pytest
from comparisons import TINY
from synthetic import falls

from quadruped_env.evaluation.comparison import Comparison, rank
from quadruped_env.evaluation.conditions import COMMANDS, motion_of
from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.evaluation.learning_gain import LearningGain, Performance
from quadruped_env.evaluation.measures import METRICS
from quadruped_env.evaluation.verdict import WORST_SHOWN, reached_share, verdict, worst_episodes
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig


def invented(velocity, fallen=(), yaw_rate=None, commands=COMMANDS, tuned_error=0.05, tuned_fallen=(), slow=None):
    """A comparison whose policy reaches a share of every velocity and falls under the commands with these indices.

    `slow` has the share of the forward velocity under some commands, by index.
    """
    seeds = 3
    command = np.array(commands)
    empty = {name: np.full((len(commands), seeds), np.nan) for name in METRICS}

    def controller(shares, falls=(), error=None):
        reached = command * shares
        values = {name: value.copy() for name, value in empty.items()}
        values["forward_velocity"][:] = reached[:, :1]
        values["yaw_rate"][:] = reached[:, 1:]
        values["forward_velocity_error"][:] = np.abs(reached - command)[:, :1] if error is None else error
        values["yaw_rate_error"][:] = np.abs(reached - command)[:, 1:] if error is None else error
        values["distance"][:] = 20.0 * reached[:, :1]
        values["fall_rate"][:] = 0.0
        values["peak_torque"][:] = 6.0
        for i in falls:
            for name, value in values.items():
                value[i] = 1.0 if name == "fall_rate" else np.nan
        return values

    forward = np.full((len(commands), 1), velocity)
    for i, share in (slow or {}).items():
        forward[i] = share
    turn = np.full_like(forward, velocity if yaw_rate is None else yaw_rate)
    values = {
        "policy": controller(np.hstack([forward, turn]), fallen),
        "tuned": controller(0.9, tuned_fallen, tuned_error),
        "article": controller(0.0),
        "zero": controller(0.0),
    }
    return Comparison(tuple(commands), (1, 2, 3), 20.0, TaskConfig(), {}, values)


@pytest.mark.parametrize(
    ("numbers", "level", "headline"),
    [
        ({"velocity": 1.0}, "good", "at least as well as the scripted gait"),
        (
            {"velocity": 0.95, "tuned_error": 0.0},
            "fair",
            "less accurate than the scripted gait forwards, backwards",
        ),
        ({"velocity": 1.0, "yaw_rate": 0.2}, "fair", "does not follow 0.5 rad/s, -0.5 rad/s"),
        ({"velocity": 1.0, "fallen": [1, 3]}, "fair", "Not reliably: it walks, but it falls in 18 % of the episodes."),
        ({"velocity": 1.0, "fallen": [3, 4, 6, 7, 8, 9]}, "poor", "No: it falls in 55 % of the episodes."),
        (
            {"velocity": 0.4, "fallen": [1, 3]},
            "poor",
            "Hardly: it falls in 18 % of the episodes, and reaches 40 % of the ",
        ),
        # It always falls in turns, so that there is no yaw rate.
        (
            {"velocity": 1.0, "fallen": [7, 8, 9, 10]},
            "fair",
            "falls too early to be measured turning.",
        ),
        ({"velocity": 0.6}, "fair", "does not follow 0.3 m/s, 0.4 m/s, 0.5 m/s"),
        # On average the error forwards is 0.03 m/s.
        ({"velocity": 1.0, "slow": {4: 0.7}}, "fair", "does not follow 0.5 m/s"),
        ({"velocity": 0.0, "fallen": range(1, 10)}, "poor", "No: it falls in 82 % of the episodes."),
        ({"velocity": 0.4}, "poor", "Hardly: it reaches 40 %"),
        ({"velocity": 0.0}, "poor", "does not walk."),
        ({"velocity": -1.0, "fallen": [0, 6]}, "poor", "No: it falls in 18 % of the episodes, and does not walk."),
        ({"velocity": 1.0, "fallen": range(len(COMMANDS))}, "poor", "No: it always falls before"),
        ({"velocity": 1.0, "commands": [(0.0, 0.0)]}, "fair", "walking was not tested"),
    ],
)
def test_headline(numbers, level, headline):
    judged = verdict(invented(**numbers))
    assert judged.level == level
    assert headline in judged.headline
    assert "nan" not in judged.text().lower().split()


def test_policy_without_a_significant_gain_is_not_good():
    def judged(low):
        one = Performance(*[Estimate(1.0, 1.0, 1.0, 8)] * 4)
        gain = LearningGain(8, 20.0, (0.05, 0.1), one, one, Estimate(0.5, low, 1.0, 8))
        return verdict(invented(1.0), gain=gain)

    assert (judged(0.2).level, verdict(invented(1.0)).level) == ("good", "good")
    assert judged(-0.1).level == "fair"
    assert judged(-0.1).headline == "Yes, it walks, but it has no significant gain over the zero action."


@pytest.mark.parametrize(
    "falls",
    [
        {"fallen": [6]},
        {"tuned_fallen": [6]},
        # Every episode forwards falls in one of the two only: both have values, and no pair of episodes has.
        {"fallen": [0, 1], "tuned_fallen": [2, 3, 4]},
    ],
)
def test_controllers_without_values_have_no_rank(falls):
    judged = verdict(invented(1.0, **falls))
    assert "scripted gait" not in judged.headline
    assert "nan" not in judged.text().lower().split()


def test_one_seed_gives_no_intervals_and_no_ranks():
    several = invented(0.9)
    one = dataclasses.replace(
        several,
        seeds=(1,),
        values={name: {m: v[:, :1] for m, v in values.items()} for name, values in several.values.items()},
    )
    error = one.estimate("policy", "forward_velocity_error", "forwards")
    assert error.mean == pytest.approx(0.03)
    assert math.isnan(error.low)
    assert math.isnan(error.high)
    assert rank(one, "forward_velocity_error", "policy", "tuned", "forwards") == "not comparable"
    judged = verdict(one)
    assert "scripted gait" not in judged.headline
    assert "nan" not in judged.text().lower()


def test_policy_with_a_fall_does_not_stay_on_its_feet():
    comparison = invented(1.0)
    comparison.values["policy"]["fall_rate"][0, 0] = 1.0
    assert verdict(comparison).level == "good"
    assert "Yes, it walks: it falls in 3 % of the episodes, and follows" in verdict(comparison).headline


def test_reached_share_in_the_wrong_direction_is_negative():
    assert reached_share(invented(0.8), "policy", "backwards") == pytest.approx(0.8)
    assert reached_share(invented(-0.5), "policy", "backwards") == pytest.approx(-0.5)
    assert math.isnan(reached_share(invented(0.8, fallen=[6]), "policy", "backwards"))


def test_commands_are_classified_by_motion():
    assert [motion_of(c, MINI_QUADRUPED) for c in ((0.1, 0.0), (0.0, 0.0), (-0.1, 0.0), (0.0, 0.5), (0.3, -0.5))] == [
        "forwards", "standing", "backwards", "turning", "turning",
    ]  # fmt: skip


def with_falls(comparison, **ends):
    """The comparison, in which the policy falls in the given envs (r3 is the fourth) after the given samples."""
    policy = comparison.rollouts["policy"]
    valid = policy.valid.copy()
    for row, samples in ends.items():
        valid[samples:, int(row[1:])] = False
    fallen = dataclasses.replace(policy, fell=falls(valid))
    return dataclasses.replace(comparison, rollouts={**comparison.rollouts, "policy": fallen})


def test_falls_are_the_worst_and_the_earliest_first(comparison):
    found = worst_episodes(with_falls(comparison, r1=100, r4=50, r5=80))
    assert [failure.row for failure in found[:2]] == [4, 1]
    assert [failure.command for failure in found[:2]] == [TINY[2], TINY[0]]
    assert found[0].fell_at == pytest.approx(51 * 0.02)
    assert found[0].story.startswith("It fell at 1.0 s. Errors before: ")
    assert found[2].fell_at is None


def test_without_falls_the_worst_has_the_largest_error(comparison):
    errors = comparison.values["policy"]
    tolerated = np.maximum(errors["forward_velocity_error"] / 0.1, errors["yaw_rate_error"] / 0.2)
    worst = worst_episodes(with_falls(comparison))
    assert not any(math.isinf(failure.badness) for failure in worst)
    assert worst[0].badness == pytest.approx(np.nanmax(tolerated))
    assert worst[0].row == int(np.nanargmax(tolerated))
    assert "It did not fall. Errors: " in worst[0].story
    assert len({failure.command for failure in worst}) == len(worst) == WORST_SHOWN
