"""Fixtures of the tests of policies."""

import pytest
from policies import make_policy


@pytest.fixture
def run_directory(tmp_path):
    """The directory of a saved policy."""
    make_policy().save(tmp_path / "run")
    return tmp_path / "run"
