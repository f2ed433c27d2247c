"""Metrics that a training sends to a service: the names, the steps and the end, with stubs of the services."""

import sys
from types import SimpleNamespace

import pytest
from trainings import SMALL, learn

from quadruped_env import QuadrupedError
from quadruped_env.training import TrainConfig
from quadruped_env.training.train import train

CONFIG = TrainConfig(**SMALL, timesteps=96)


@pytest.mark.parametrize("service", ["wandb", "mlflow", "trackio"])
def test_service_receives_the_settings_the_metrics_and_the_end(tmp_path, monkeypatch, service):
    calls = []

    def call(name):
        return lambda *arguments, **named: calls.append((name, arguments, named))

    names = ("start_run", "log_params", "log_metrics", "end_run", "init", "log", "finish")
    monkeypatch.setitem(sys.modules, service, SimpleNamespace(**{name: call(name) for name in names}))
    directory, whole = train(CONFIG, tmp_path, "train", service=service)
    assert whole
    begin, log, end = ("start_run", "log_metrics", "end_run") if service == "mlflow" else ("init", "log", "finish")
    assert (calls[0][0], calls[-1][0]) == (begin, end)
    assert directory.name in calls[0][2].values()
    settings = calls[1][1][0] if service == "mlflow" else calls[0][2]["config"]
    assert settings["timesteps"] == 96
    _, (metrics,), named = next(entry for entry in reversed(calls) if entry[0] == log)
    assert metrics["progress/fall_rate"] >= 0.0
    assert named == {"step": 96}
    assert (directory / "policy.safetensors").read_bytes() == (
        learn(tmp_path, CONFIG) / "policy.safetensors"
    ).read_bytes()


def test_service_that_is_not_installed_is_an_error_with_the_command(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "trackio", None)
    with pytest.raises(QuadrupedError, match="--track: trackio is not installed: pip install trackio"):
        train(CONFIG, tmp_path, "train", service="trackio")
