"""Metrics that a training sends to a service: the names, the steps and the end, with stubs of the services."""

import sys
from types import SimpleNamespace

import pytest
from trainings import SMALL, learn

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.training import TrainConfig
from quadruped_env.training.train import train

CONFIG = TrainConfig(**SMALL, timesteps=96)


def stub(monkeypatch, service, calls, failing=()):
    """Install a service whose functions note their calls, and fail if they are `failing`."""

    def call(name):
        def function(*arguments, **named):
            calls.append((name, arguments, named))
            if name in failing:
                raise ConnectionError("no route\nto host")

        return function

    names = ("start_run", "log_params", "log_metrics", "end_run", "init", "log", "finish")
    monkeypatch.setitem(sys.modules, service, SimpleNamespace(**{name: call(name) for name in names}))


@pytest.mark.parametrize("service", ["wandb", "mlflow", "trackio"])
def test_service_receives_the_settings_the_metrics_and_the_end(tmp_path, monkeypatch, service):
    calls = []
    stub(monkeypatch, service, calls)
    directory, whole = train(CONFIG, tmp_path, "train", service=service)
    assert whole
    begin, log, end = ("start_run", "log_metrics", "end_run") if service == "mlflow" else ("init", "log", "finish")
    assert (calls[0][0], calls[-1][0]) == (begin, end)
    assert directory.name in calls[0][2].values()
    settings = calls[1][1][0] if service == "mlflow" else calls[0][2]["config"]
    assert settings["timesteps"] == 96
    assert next(entry for entry in reversed(calls) if entry[0] == log)[2] == {"step": 96}
    # How many times it logs depends on the machine's speed.
    logged = set().union(*(entry[1][0] for entry in calls if entry[0] == log))
    assert "progress/fall_rate" in logged
    assert "time/total_timesteps" in logged, "a whole number is a metric, too"
    assert (directory / "policy.safetensors").read_bytes() == (
        learn(tmp_path, CONFIG) / "policy.safetensors"
    ).read_bytes()


def test_service_that_is_not_installed_is_an_error_with_the_command(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "trackio", None)
    with pytest.raises(QuadrupedError, match="--track: trackio is not installed: pip install trackio"):
        train(CONFIG, tmp_path, "train", service="trackio")
    assert list(tmp_path.iterdir()) == []


def test_service_that_cannot_begin_a_run_is_an_error_in_a_line(tmp_path, monkeypatch):
    stub(monkeypatch, "mlflow", [], failing=["start_run"])
    with pytest.raises(QuadrupedError, match=r"mlflow cannot begin a run \(ConnectionError: no route to host\)"):
        train(CONFIG, tmp_path, "train", service="mlflow")


@pytest.mark.parametrize("failing", ["log", "finish"])
def test_service_that_fails_in_a_training_does_not_end_it(tmp_path, monkeypatch, failing):
    calls = []
    stub(monkeypatch, "wandb", calls, failing=[failing])
    with pytest.warns(QuadrupedWarning, match=r"wandb failed \(ConnectionError: no route to host\)"):
        _, whole = train(CONFIG, tmp_path, "train", service="wandb")
    assert whole
    assert [name for name, _, _ in calls].count(failing) == 1
