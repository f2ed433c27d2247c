"""A run that the tests of this folder resume, export or damage, and the settings that the program would train with."""

import argparse

import pytest
from trainings import run  # noqa: F401  a fixture

from quadruped_env import QuadrupedError
from quadruped_env.cli import train


@pytest.fixture
def asked(monkeypatch, tmp_path):
    """Function that returns the settings of the training that the program would run."""
    from quadruped_env.training import train as training

    trainings = []

    def stop(config, *arguments, **others):
        trainings.append(config)
        raise QuadrupedError("stopped")

    def started(*arguments):
        parser = argparse.ArgumentParser()
        train.add_arguments(parser)
        with pytest.raises(QuadrupedError, match="stopped"):
            train.run(parser.parse_args(["-o", str(tmp_path), *arguments]), argparse.Namespace(line="train"))
        return trainings[-1]

    monkeypatch.setattr(training, "train", stop)
    return started
