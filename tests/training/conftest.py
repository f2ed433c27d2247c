"""A run that the tests of this folder resume, export or damage."""

import pytest
from trainings import SMALL, STEPS, learn

from quadruped_env.training import TrainConfig


@pytest.fixture(scope="session")
def run(tmp_path_factory):
    """A complete run of eight updates, without checkpoints on a machine of any speed."""
    config = TrainConfig(timesteps=8 * STEPS, name="first", checkpoint_seconds=1e6, **SMALL)
    return learn(tmp_path_factory.mktemp("runs"), config)
