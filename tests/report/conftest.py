"""Fixtures of the tests of reports."""

from types import SimpleNamespace

import matplotlib.figure
import pytest
from comparisons import random_policy, write_evaluation

from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.learning_gain import learning_gain
from quadruped_env.report.pages import report


def make_run(parent):
    directory = parent / "20260101-000000-ppo"
    random_policy("residual").save(directory)
    curve = "timesteps,seconds,return,fall_rate,forward_velocity_error\n1000,1,nan,1.0,0.3\n2000,2,5.5,0.5,0.2\n3000,3"
    (directory / "progress.csv").write_text(curve)
    return directory


@pytest.fixture(scope="module")
def run_directory(tmp_path_factory):
    return make_run(tmp_path_factory.mktemp("runs"))


@pytest.fixture(scope="session")
def written(tmp_path_factory, comparison):
    """A report: the texts of its `page` and `numbers`, its `figures`, the `directory` of its run, and its `gain`."""
    directory, figures, patch = make_run(tmp_path_factory.mktemp("written")), [], pytest.MonkeyPatch()
    save = matplotlib.figure.Figure.savefig

    def keep(self, file, **options):
        figures.append(self)
        save(self, file, **options)

    patch.setattr(matplotlib.figure.Figure, "savefig", keep)
    line = "python evaluate/policy.py runs/<name>"
    evaluated = find_policy(str(directory))
    gain = learning_gain(evaluated.policy, 3, 2.0)
    page, numbers, missing = write_evaluation(evaluated, comparison, line, gain=gain)
    patch.undo()
    assert not missing
    return SimpleNamespace(
        page=page.read_text(), numbers=numbers.read_text(), figures=figures, directory=directory, gain=gain
    )


@pytest.fixture
def without_figures(monkeypatch):
    """Figures take most of a report's time."""
    monkeypatch.setattr(report, "_figures", lambda *_: [])
