"""The verdict on a comparison, on invented numbers."""

import math

import numpy as np
import pytest

from quadruped_env.evaluation.comparison import COMMANDS, Comparison, motion_of
from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.evaluation.learning_gain import LearningGain, Performance
from quadruped_env.evaluation.metrics import METRICS
from quadruped_env.evaluation.verdict import reached_share, verdict
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig


def invented(velocity, fallen=(), yaw_rate=None, commands=COMMANDS, tuned_error=0.05, tuned_fallen=()):
    """A comparison whose policy reaches a share of every velocity and falls under the commands with these indices."""
    seeds = 3
    command = np.array(commands)
    empty = {name: np.full((len(commands), seeds), np.nan) for name in METRICS}

    def controller(share, turn, falls=(), error=None):
        reached = command * [share, turn]
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

    values = {
        "policy": controller(velocity, velocity if yaw_rate is None else yaw_rate, fallen),
        "tuned": controller(0.9, 0.9, tuned_fallen, tuned_error),
        "article": controller(0.0, 0.0),
        "zero": controller(0.0, 0.0),
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
        ({"velocity": 0.4, "fallen": [1, 3]}, "poor", "Hardly: it reaches 40 % of the commanded forward velocity and "),
        # It always falls in turns, so that there is no yaw rate.
        ({"velocity": 1.0, "fallen": [7, 8, 9, 10]}, "fair", "falls too early in turns to measure its yaw rate."),
        ({"velocity": 0.6}, "fair", "forward velocity error of 0.12 m/s"),
        ({"velocity": 0.4}, "poor", "Hardly: it reaches 40 %"),
        ({"velocity": 0.0}, "poor", "does not walk."),
        ({"velocity": -1.0, "fallen": [0, 6]}, "poor", "does not walk, and it falls."),
        ({"velocity": 1.0, "fallen": range(len(COMMANDS))}, "poor", "No: it always falls before"),
        ({"velocity": 1.0, "commands": [(0.0, 0.0)]}, "fair", "walking was not tested"),
    ],
)
def test_headline(numbers, level, headline):
    judged = verdict(invented(**numbers))
    assert judged.level == level
    assert headline in judged.headline
    assert "nan" not in judged.text().lower().split()


def test_policy_that_learned_nothing_beyond_doubt_is_not_good():
    def judged(low):
        one = Performance(*[Estimate(1.0, 1.0, 1.0, 8)] * 4, own_action=0.1)
        gain = LearningGain(8, 20.0, (0.05, 0.1), one, one, Estimate(0.5, low, 1.0, 8), 2.5)
        return verdict(invented(1.0), gain=gain)

    assert (judged(0.2).level, verdict(invented(1.0)).level) == ("good", "good")
    assert judged(0.2).findings[0] == (
        "Learning",
        "in its own task, it is better than doing nothing by 0.50 return/s (2.5 standard errors).",
    )
    assert judged(-0.1).level == "fair"
    assert judged(-0.1).headline == "Yes, it walks, but it is not better than doing nothing beyond doubt."
    assert judged(-0.1).findings[0][1].endswith("beyond doubt: +0.50 return/s (95 % interval -0.10 to +1.00).")


def test_findings_say_how_far_it_gets_and_where_it_falls():
    findings = dict(verdict(invented(0.9, fallen=[1])).findings)
    assert "travels 9.0 m in 20 s" in findings["Forwards"]
    assert findings["Falls"].startswith("3 in 33 episodes of 20 s, 9.1 % (95 % interval ")
    assert findings["Falls"].endswith("3 forwards.")
    assert "-0.18 m/s of the commanded -0.20 m/s" in findings["Backwards"]
    assert "reaches 90 % of the commanded yaw rate, the searched gait 90 %" in findings["Turning"]
    assert "6.0 of 10 N m" in findings["Effort"]
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
    assert findings["Forwards"].endswith("At a command of 0.5 m/s it falls too early to tell.")
    assert findings["Turning"].endswith("it reaches 100 % of the commanded yaw rate.")
    findings = dict(verdict(invented(1.0, fallen=range(len(COMMANDS)))).findings)
    assert findings["Effort"] == "it falls too early to tell."


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
