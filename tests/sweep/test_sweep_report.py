"""Results of a sweep: the score of each setting over all its seeds, and the page."""

import json
import os

import numpy as np
import pytest
from scipy import stats
from sweeps import finish, make_sweep

from quadruped_env.evaluation.confidence import student_mean
from quadruped_env.sweep.report import collect, headline, table, write_report

PROGRESS = "timesteps,seconds,return,fall_rate,forward_velocity_error,yaw_rate_error\n1,1,1,0,0,0\n2,2,2,0,0,0\n"


@pytest.mark.parametrize("count", [2, 3, 8, 31, 40])
def test_interval_is_students(count):
    values = np.random.default_rng(count).normal(0.5, 0.1, count)
    found = student_mean(values.tolist())
    half = stats.sem(values) * stats.t.ppf(0.975, min(count - 1, 30))
    assert (found.mean, found.count) == (pytest.approx(values.mean()), count)
    assert [found.low, found.high] == pytest.approx([values.mean() - half, values.mean() + half], abs=1e-4)


def sweep_of(tmp_path, *scores):
    """A sweep with a setting for each tuple of its seeds' scores; None is a failed training."""
    values = [{"gamma": 0.9 + 0.01 * setting} for setting in range(len(scores))]
    sweep = make_sweep(tmp_path, "gamma=0.9..1", settings=len(scores), seeds=len(scores[0]))
    for setting, own in enumerate(scores):
        for seed, total in enumerate(own):
            number = setting * len(own) + seed
            if total != "open":
                finish(sweep, number, total, values[setting])
            run = sweep.trial(number) / "r"
            run.mkdir(parents=True)
            (run / "progress.csv").write_text(PROGRESS)
    return sweep


def test_score_of_a_setting_is_the_mean_over_its_seeds(tmp_path):
    found = collect(sweep_of(tmp_path, (0.884, 0.890)))
    assert table(found, 2).rows[0][2].startswith("0.887 [")
    assert found["settings"][0]["mean"]["score"]["mean"] == pytest.approx(0.887)


def test_failed_seed_counts_as_the_zero_action_and_beats_no_setting_whose_seeds_are_good(tmp_path):
    found = collect(sweep_of(tmp_path, (0.9, None, None), (0.88, 0.87, 0.86)))
    first, second = table(found, 3).rows
    assert first[:3] == ["gamma=0.91", "3 of 3 seeds", "0.870 [0.845, 0.895]"]
    assert second[:3] == ["gamma=0.9", "1 of 3 seeds, 2 failed", "0.367 [-0.781, 1.514]"]
    assert headline(found) == "4 of 6 trials finished, 2 failed; the best is trial 0 with a score of 0.900."


def test_page_in_between_shows_what_there_is_and_the_last_one_all(tmp_path):
    sweep = sweep_of(tmp_path, (0.8, 0.6), (None, "open"))
    page = write_report(sweep)
    text = page.read_text()
    assert "2 of 4 trials finished, 1 failed, 1 open; the best is trial 0" in text
    assert "2 of 2 seeds" in text
    assert "0.700 [" in text
    assert "0 of 2 seeds, 1 failed" in text
    assert "<td>diverged</td>" in text
    assert text.count("data:image/svg+xml") == 1
    assert json.loads((sweep.path / "results.json").read_text())["states"] == {"finished": 2, "failed": 1, "open": 1}
    before = page.stat().st_mtime_ns
    assert write_report(sweep).stat().st_mtime_ns == before, "nothing is new"
    finish(sweep, 3, 0.4, {"gamma": 0.91})
    os.utime(sweep.trial(3) / "result.json", (0, 0))  # from a machine whose clock is behind
    assert "3 of 4 trials finished, 1 failed; " in write_report(sweep).read_text()


def test_page_of_seeds_that_all_failed_has_no_figures(tmp_path):
    sweep = make_sweep(tmp_path, seeds=2)
    for number in range(2):
        finish(sweep, number, None)
    text = write_report(sweep).read_text()
    assert "0 of 2 trials finished, 2 failed." in text
    assert "data:image/svg+xml" not in text


def test_policy_that_the_suite_cannot_run_leaves_a_setting_without_a_score(tmp_path):
    sweep = make_sweep(tmp_path, seeds=2)
    finish(sweep, 0, 0.5, run="trials/0000/r")
    finish(sweep, 1, 0.5, score=None, error="observes the mass")
    found = collect(sweep)
    assert table(found, 2).rows[0][1:3] == ["2 of 2 seeds", "-"]
    assert found["best"]["trial"] == 0
