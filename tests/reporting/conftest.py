"""Fixtures of the tests of reports."""

import pytest
from comparisons import random_policy


@pytest.fixture(scope="module")
def run_directory(tmp_path_factory):
    directory = tmp_path_factory.mktemp("runs") / "20260101-000000-ppo"
    random_policy("residual").save(directory)
    curve = "timesteps,seconds,return,fall_rate,forward_velocity_error\n1000,1,nan,1.0,0.3\n2000,2,5.5,0.5,0.2\n3000,3"
    (directory / "progress.csv").write_text(curve)
    return directory
