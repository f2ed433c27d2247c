"""The gain of a training: on the pages of reports, in the learning curve and in the film."""

import dataclasses
import json
import shutil

import numpy as np
import pytest
from comparisons import random_policy, write_comparison
from report_page import Page

from quadruped_env.evaluation.confidence import Estimate
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.learning_gain import gain_rows, learning_gain, reward_in_words
from quadruped_env.evaluation.term_gain import TermGain
from quadruped_env.policies.files import CHECKPOINTS
from quadruped_env.report.pages.clips import half_way, learning_clips
from quadruped_env.report.pages.report import zero_return
from quadruped_env.report.plots import learning_curve


@pytest.fixture(scope="module")
def gain():
    return learning_gain(random_policy("residual"), 3, 2.0)


@pytest.fixture
def run(tmp_path):
    """A run of 1000 steps, with checkpoints of other policies."""
    directory = tmp_path / "20260101-000000-ppo"
    policy = random_policy("residual")
    policy.with_card({"timesteps": 1000}).save(directory)
    for steps in (100, 400, 700, 1000):
        weights = tuple(weight * np.float32(steps / 1000) for weight in policy.weights)
        checkpoint = type(policy).for_task(weights, policy.biases, "tanh", policy.config, {"timesteps": steps})
        checkpoint.save(directory / CHECKPOINTS / f"{steps:05d}s")
    return directory


def text_of(page):
    return " ".join(" ".join(Page(page).text).replace("\N{NO-BREAK SPACE}", " ").split())


def test_report_holds_the_table_above_the_numbers(written):
    gain, text = written.gain, text_of(written.page)
    assert json.loads(written.numbers)["learning"] == json.loads(json.dumps(gain.to_dict()))
    place = text.index("What learning added")
    assert place < text.index("In numbers")
    for row in gain_rows(gain.to_dict()):
        assert " ".join(" ".join(row).split()) in text[place:]
    assert "The dashed line is the return of the zero action" in text


def test_comparison_holds_the_gain_of_each_policy(run_directory, comparison, gain, tmp_path, without_figures):
    policies = {"policy": find_policy(str(run_directory), tmp_path)}
    estimates = {"policy": Estimate(0.3, 0.2, 0.4, 3), "zero": Estimate(0.4, 0.4, 0.4, 3)}
    term = TermGain("hip_usage", "rad^2", -0.5, 0.9, **estimates, difference=Estimate(-0.1, -0.2, 0.0, 3))
    gain = dataclasses.replace(gain, terms=(term,))
    page, numbers = write_comparison(policies, comparison, tmp_path, gains={"policy": gain})
    assert json.loads(numbers.read_text())["policies"]["policy"]["learning"]["verdict"] == gain.verdict()
    text = text_of(page.read_text())
    assert f"In its own task, it {gain.verdict()}." in text
    assert " ".join(gain_rows(gain.to_dict())[0]) in text
    assert reward_in_words(gain.to_dict()) in text
    assert "hip_usage (rad^2) -0.5 0.9 0.3 0.4 -0.15 not learned" in text
    assert "hip_usage (rad^2)    -0.5    0.9   0.3          0.4" in gain.table()


def test_line_of_the_curve_is_the_zero_actions_return_of_a_whole_episode(gain):
    value = zero_return(gain, random_policy("residual").config)
    assert value == pytest.approx(20.0 * gain.zero.return_per_second.mean)
    curves = {"run": {"timesteps": np.array([1e3, 2e3]), "return": np.array([1.0, 2.0])}}
    assert "zero action" in learning_curve(curves, {"run": 1.5})
    assert "zero action" not in learning_curve(curves)


def test_film_shows_before_half_way_and_after(run, comparison):
    evaluated = find_policy(str(run))
    clips = learning_clips(evaluated, comparison)
    titles = ["before (zero action)", "half way (400 steps)", "after (1,000 steps)"]
    assert [clip.title.partition(":")[0] for clip in clips] == titles
    joints = [clip.trace.joint_position[:50] for clip in clips]
    assert not any(np.array_equal(joints[i], joints[j]) for i, j in ((0, 1), (1, 2), (0, 2)))
    assert half_way(run / CHECKPOINTS / "00700s", 700)[1] == 400
    assert half_way(run, 4100) is None, "after 1000 of 4100 steps, less than a quarter"
    shutil.rmtree(run / CHECKPOINTS)
    assert half_way(run, 1000) is None
    assert len(learning_clips(evaluated, comparison)) == 2
