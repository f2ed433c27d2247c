"""The report of a sweep: its figures' numbers, and the page from results with every state of a trial."""

import numpy as np
import pytest

from quadruped_env.evaluation.results import COMPONENTS
from quadruped_env.report.pages.sweep_report import write_sweep_report
from quadruped_env.report.plots import sweep_plots as plots

RATE = {"low": 1e-4, "high": 1e-2, "log": True}
HIDDEN = {"choices": [[8], [16, 16]]}
PROGRESS = "timesteps,seconds,return,fall_rate,forward_velocity_error,yaw_rate_error\n"


def test_position_on_an_axis_is_the_share_of_the_range():
    assert plots.position(1e-3, RATE) == pytest.approx(0.5)
    assert plots.position(0.25, {"low": -1.0, "high": 0.25, "log": False}) == 1.0
    assert [plots.position(value, HIDDEN) for value in ([8], [16, 16])] == [0.0, 1.0]
    assert plots.ticks(HIDDEN) == [(0.0, "8"), (1.0, "16x16")]


def test_median_curve_is_known_where_most_trials_are():
    x = np.linspace(0.0, 1.0, 11)
    grid, median = plots.median_curve([(x, 2.0 * x), (x, 4.0 * x), (2.0 * x, 6.0 * x)])
    assert grid[-1] == pytest.approx(1.0, abs=0.06)
    # The third curve is 3 x.
    np.testing.assert_allclose(median, 3.0 * grid, atol=1e-12)
    assert [len(part) for part in plots.median_curve([])] == [0, 0]


def estimate(mean, low, high, count):
    return {"mean": mean, "low": low, "high": high, "count": count}


def suite_of(mean, count):
    low, high = (None, None) if count == 1 else (mean - 0.1, mean + 0.1)
    components = dict.fromkeys(COMPONENTS, estimate(mean, low, high, count))
    return {"score": estimate(mean, low, high, count), "components": components, "runs": []}


@pytest.fixture
def results(tmp_path):
    """Results of three settings: with a score, with one seed that has a score, and failed."""
    trials, settings = [], []
    for number, (setting, state, score) in enumerate(
        [(0, "finished", 0.8), (0, "finished", 0.6), (1, "finished", 0.5), (1, "stopped", None), (2, "failed", None)]
    ):
        run = None
        if state == "finished":
            run = f"trials/{number:04d}/run"
            (tmp_path / run).mkdir(parents=True)
            lines = "".join(f"{1000 * i},{i},{10.0 * i},0.5,0.2,0.3\n" for i in range(1, 4))
            (tmp_path / run / "progress.csv").write_text(PROGRESS + lines)
        values = {"learning_rate": 1e-3 * (setting + 1), "hidden": [16, 16]}
        seconds = 12.3 if run else None
        trials.append(
            {
                "trial": number,
                "setting": setting,
                "seed": number % 2,
                "values": values,
                "state": state,
                "score": score,
                "run": run,
                "training_seconds": seconds,
            }
        )
    for setting, mean, count in ((0, 0.7, 2), (1, 0.5, 1)):
        own = [trial for trial in trials if trial["setting"] == setting]
        entry = {"setting": setting, "values": own[0]["values"], "trials": [0, 1], "finished": count}
        settings.append({**entry, "suite": suite_of(mean, count)})
    settings.append({"setting": 2, "values": trials[4]["values"], "trials": [4], "finished": 0, "suite": None})
    definition = {"space": {"learning_rate": RATE, "hidden": HIDDEN}, "settings": 3, "seeds": 2, "score": "quick"}
    return {
        "command": "python train/sweep.py --trials 3",
        "definition": definition,
        "states": {"finished": 3, "stopped": 1, "failed": 1},
        "trials": trials,
        "settings": settings,
        "importance": {"fields": {"learning_rate": 0.75, "hidden": 0.25}, "missing": None},
        "best": {"trial": 0, "score": 0.8, "seed": 0, "run": trials[0]["run"], "values": trials[0]["values"]},
    }


def test_page_shows_scores_states_figures_and_the_best_run(results, tmp_path):
    text = write_sweep_report(tmp_path, results).read_text()
    assert "3 of 5 trials finished, 1 stopped, 1 failed; the best is trial 0 with a score of 0.800." in text
    assert "0.700 [0.600, 0.800]" in text
    assert "<td>0.500</td>" in text, "a single seed has no interval"
    assert text.count("data:image/svg+xml") == 3
    assert "trials/0000/run" in text
    for title in ("Learning curves", "Settings and their scores", "Importance of the fields"):
        assert title in text


def test_page_of_seeds_without_scores_has_the_learning_curves_alone(results, tmp_path):
    results["definition"] = {"space": {}, "settings": 1, "seeds": 5, "score": "none"}
    results |= {"best": None, "importance": {"fields": {}, "missing": "no field varies"}, "states": {"finished": 3}}
    for entry in (*results["settings"], *results["trials"]):
        entry |= {"values": {}, "suite": None, "score": None}
    text = write_sweep_report(tmp_path, results).read_text()
    assert "3 of 5 trials finished." in text
    assert text.count("data:image/svg+xml") == 1
    assert "No importance" not in text
