import browser
import pytest

from quadruped_env.robot import load_model


@pytest.fixture(scope="session")
def model():
    return load_model()


@pytest.fixture
def tmp_cwd(tmp_path, monkeypatch):
    """A working directory of the test's own: MuJoCo writes its warnings to a file there."""
    monkeypatch.chdir(tmp_path)


# Not for the whole session: while it lives, Playwright's event loop is the thread's, and no test could run its own.
@pytest.fixture(scope="module")
def chromium():
    """A running Chromium; the test skips where there is none."""
    with browser.launched() as running:
        yield running


@pytest.fixture
def page(chromium):
    """A new page of it, which keeps errors and requests in `page.watched`."""
    with browser.opened(chromium) as page:
        yield page
