import pytest

from quadruped_env.robot import load_model


@pytest.fixture(scope="session")
def model():
    return load_model()
