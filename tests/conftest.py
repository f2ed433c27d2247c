import pytest

from quadruped_env.robot import load_model


@pytest.fixture(scope="session")
def model():
    return load_model()


@pytest.fixture
def tmp_cwd(tmp_path, monkeypatch):
    """A working directory of the test's own: MuJoCo writes its warnings to a file there."""
    monkeypatch.chdir(tmp_path)
