"""Fixtures of the tests of the viewer's server and of its page."""

import browser
import pytest
from browser import field
from viewer_page import tab, until, visit
from viewing import showing


@pytest.fixture(scope="module")
def show(tmp_path_factory):
    with showing(tmp_path_factory.mktemp("access"), "gait trot") as show:
        yield show


@pytest.fixture
def refusals(show, caplog):
    """Lines of the log about refused clients."""
    caplog.set_level("WARNING", logger="quadruped_env.viewer")
    return lambda: [record.getMessage() for record in caplog.records if record.name == "quadruped_env.viewer"]


@pytest.fixture(scope="module")
def stage(tmp_path_factory, chromium):
    """A show and a page on it, for the tests that leave both as they were."""
    directory = tmp_path_factory.mktemp("viewer")
    with showing(directory) as show, browser.opened(chromium) as page:
        visit(page, show)
        yield show, page
        assert page.watched.errors == []
        assert page.watched.outside() == []


@pytest.fixture
def paused(stage):
    """The show at its start, standing still."""
    show, page = stage
    controller = show.controller
    controller.paused = True
    controller.reset()
    controller.set_command(0.0, 0.0)
    tab(page, "Drive")
    tab(page, "Walk")
    for label in ("Forward, m/s", "Turn left, rad/s"):
        until(lambda label=label: field(page, label).input_value() == "0")
    yield controller, page
    controller.set_source(0, "policy flat")
    controller.paused = False
