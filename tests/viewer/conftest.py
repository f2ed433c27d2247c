"""Fixtures of the tests of the viewer's server."""

import pytest
from viewing import showing


@pytest.fixture(scope="module")
def show(tmp_path_factory):
    with showing(tmp_path_factory.mktemp("access"), "gait trot") as show:
        yield show


@pytest.fixture
def refusals(show, caplog, monkeypatch):
    """Lines of the log about refused clients."""
    monkeypatch.setattr("quadruped_env.viewer.access.LOG_PERIOD", 0.0)
    caplog.set_level("WARNING", logger="quadruped_env.viewer")
    return lambda: [record.getMessage() for record in caplog.records if record.name == "quadruped_env.viewer"]
