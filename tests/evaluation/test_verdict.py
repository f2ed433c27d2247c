"""The verdict on a comparison, on invented numbers."""

import dataclasses
import math

import numpy as np
import pytest

from quadruped_env.evaluation.comparison import COMMANDS, Comparison, motion_of, rank
from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.evaluation.learning_gain import LearningGain, Performance
from quadruped_env.evaluation.metrics import METRICS
from quadruped_env.evaluation.verdict import reached_share, verdict
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
        ({"velocity": 1.0}, "good", "at least as well as the searched gait"),
        (
            {"velocity": 0.95, "tuned_error": 0.0},
            "fair",
            "less accurate than the searched gait forwards, backwards",
        ),
        ({"velocity": 1.0, "yaw_rate": 0.2}, "fair", "turns at 20 % of the commanded rate"),
        ({"velocity": 1.0, "fallen": [1, 3]}, "fair", "Not reliably: it walks, but it falls in 18 % of the episodes."),
        ({"velocity": 1.0, "fallen": [3, 4, 6, 7, 8, 9]}, "poor", "No: it falls in 55 % of the episodes."),
        (
            {"velocity": 0.4, "fallen": [1, 3]},
            "poor",
            "Hardly: it falls in 18 % of the episodes, and reaches 40 % of the ",
        ),
        # It always falls in turns, so that there is no yaw rate.
        ({"velocity": 1.0, "fallen": [7, 8, 9, 10]}, "fair", "falls too early in turns to measure its yaw rate."),
        ({"velocity": 0.6}, "fair", "does not follow 0.3, 0.4 and 0.5 m/s"),
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
        one = Performance(*[Estimate(1.0, 1.0, 1.0, 8)] * 4, own_action=0.1)
        gain = LearningGain(8, 20.0, (0.05, 0.1), one, one, Estimate(0.5, low, 1.0, 8), 2.5)
        return verdict(invented(1.0), gain=gain)

    assert (judged(0.2).level, verdict(invented(1.0)).level) == ("good", "good")
    assert judged(0.2).findings[1] == (
        "Learning",
        "in its own task, it is better than the zero action by 0.50 return/s (2.5 standard errors).",
    )
    assert judged(-0.1).level == "fair"
    assert judged(-0.1).headline == "Yes, it walks, but it has no significant gain over the zero action."
    assert (
        judged(-0.1)
        .findings[1][1]
        .endswith("it has no significant gain over the zero action: +0.50 return/s (95 % interval -0.10 to +1.00).")
    )


def test_findings_say_how_far_it_gets_and_where_it_falls():
    findings = dict(verdict(invented(0.9, fallen=[1])).findings)
    assert "travels 9.0 m in 20 s" in findings["Forwards"]
    assert findings["Falls"].startswith("3 in 33 episodes of 20 s, 9.1 % (95 % interval ")
    assert findings["Falls"].endswith("3 of 3 at 0.2 m/s.")
    assert "-0.18 m/s of the commanded -0.20 m/s" in findings["Backwards"]
    assert "reaches 90 % of the commanded yaw rate, the searched gait 90 %" in findings["Turning"]
    assert "peaks of 6.0 N m (within the limit of 10 N m) in any joint" in findings["Effort"]
    assert "more accurate forwards (0.032 against 0.050 m/s), standing" in findings["Searched gait"]
    assert "more accurate forwards" in findings["Article's gait"]


NO_VALUE = [
    ({"fallen": [6]}, "more accurate forwards (0.000 against 0.050 m/s), standing (0.000 against 0.050 m/s) and"),
    ({"fallen": [6]}, "not comparable backwards (- against 0.050 m/s)."),
    ({"tuned_fallen": [6]}, "not comparable backwards (0.000 against - m/s)."),
    # Every episode forwards falls in one of the two only: both have values, and no pair of episodes has.
    ({"fallen": [0, 1], "tuned_fallen": [2, 3, 4]}, "not comparable forwards (0.000 against 0.050 m/s)."),
]


@pytest.mark.parametrize(("falls", "words"), NO_VALUE)
def test_controllers_without_values_have_no_rank(falls, words):
    judged = verdict(invented(1.0, **falls))
    assert words in dict(judged.findings)["Searched gait"]
    assert "at least as well as the searched gait" not in judged.headline
    assert "nan" not in judged.text().lower().split()


def test_missing_values_are_neither_numbers_nor_zero():
    commands = list(COMMANDS)
    fastest = commands.index((0.5, 0.0))
    findings = dict(verdict(invented(1.0, fallen=[fastest], tuned_fallen=[7, 8, 9, 10])).findings)
    assert "; it falls too early to tell at 0.5 m/s. The largest error is" in findings["Forwards"]
    assert findings["Turning"].endswith("it reaches 100 % of the commanded yaw rate.")
    findings = dict(verdict(invented(1.0, fallen=range(len(COMMANDS)))).findings)
    assert findings["Effort"] == "it falls too early to tell."


def test_falls_come_first_and_by_command_the_most_first():
    comparison = invented(1.0, fallen=[6])
    comparison.values["policy"]["fall_rate"][0, 0] = 1.0
    topic, words = verdict(comparison).findings[0]
    assert topic == "Falls"
    assert words.endswith(": 3 of 3 at -0.2 m/s and 1 of 3 at 0.1 m/s.")


def test_words_are_those_of_each_command_and_the_largest_error_is_named():
    # 0.5 m/s at a share of 0.81: an error of 0.095 m/s, as that of a real policy whose mean error was 0.034.
    findings = dict(verdict(invented(0.97, slow={4: 0.81})).findings)
    assert findings["Forwards"].startswith("it closely follows 0.1, 0.2, 0.3 and 0.4 m/s; it roughly follows 0.5 m/s.")
    assert "largest error is 0.095 m/s [0.095, 0.095], at 0.5 m/s: it reaches 0.41 m/s" in findings["Forwards"]
    # A curve that is too slow is not followed, though it turns at the right rate.
    findings = dict(verdict(invented(1.0, slow={9: 0.5, 10: 0.5})).findings)
    assert "closely follows \N{PLUS-MINUS SIGN}0.5 rad/s; it does not follow 0.3 m/s with" in findings["Turning"]


def test_a_peak_beyond_the_limit_is_called_so():
    comparison = invented(1.0)
    comparison.values["policy"]["peak_joint_speed"][:] = 6.0
    assert "6.0 rad/s (beyond the limit of 5 rad/s)" in dict(verdict(comparison).findings)["Effort"]


def test_a_policy_that_falls_more_often_than_a_gait_is_not_just_more_accurate():
    findings = dict(verdict(invented(1.0, fallen=[3, 4, 6, 7])).findings)
    assert "the policy falls more often (36 % against 0 %), and is" in findings["Searched gait"]


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
    assert "not ranked: a single start of each command gives no interval" in dict(judged.findings)["Searched gait"]
    assert "nan" not in judged.text().lower()


def test_policy_with_a_fall_does_not_stay_on_its_feet():
    comparison = invented(1.0)
    comparison.values["policy"]["fall_rate"][0, 0] = 1.0
    assert verdict(comparison).level == "good"
    assert "Yes, it walks: it falls in 3 % of the episodes, and follows" in verdict(comparison).headline


def test_motions_that_were_not_commanded_are_not_judged():
    topics = [topic for topic, _ in verdict(invented(0.9, commands=[(0.3, 0.0)])).findings]
    assert topics == ["Falls", "Forwards", "Effort", "Searched gait", "Article's gait"]


def test_reached_share_in_the_wrong_direction_is_negative():
    assert reached_share(invented(0.8), "policy", "backwards") == pytest.approx(0.8)
    assert reached_share(invented(-0.5), "policy", "backwards") == pytest.approx(-0.5)
    assert math.isnan(reached_share(invented(0.8, fallen=[6]), "policy", "backwards"))


def test_commands_are_classified_by_motion():
    assert [motion_of(c, MINI_QUADRUPED) for c in ((0.1, 0.0), (0.0, 0.0), (-0.1, 0.0), (0.0, 0.5), (0.3, -0.5))] == [
        "forwards", "standing", "backwards", "turning", "turning",
    ]  # fmt: skip
