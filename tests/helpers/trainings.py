"""Tiny trainings run by the program, and the files that they write."""

import contextlib
import csv
import subprocess
import sys

import numpy as np
import pytest
from paths import ROOT
from waiting import DEADLINE, wait_until

from quadruped_env.policies import load_policy
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE
from quadruped_env.training import TrainConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_FILE, RESUME_FILE

SCRIPT = ROOT / "train" / "ppo.py"
TINY = ("--timesteps", "2048", "--num-envs", "16", "--n-steps", "16", "--batch-size", "64")
ENDLESS = ("--timesteps", "1000000000", *TINY[2:])
SMALL = {"num_envs": 4, "n_steps": 8, "batch_size": 16, "hidden": (8,), "learning_rate": 1e-3, "log_std_init": -1.5}
STEPS = 32
"""Environment steps of an update of a training with the settings `SMALL`."""
RUN_FILES = {CONFIG_FILE, PROGRESS_FILE, CARD_FILE, TENSORS_FILE, RESUME_FILE, "tensorboard"}


def command(runs, *arguments):
    return [sys.executable, str(SCRIPT), "-o", str(runs), *map(str, arguments)]


def learn(runs, config, parent=None):
    """Train in this process; the run directory."""
    from quadruped_env.training.train import train

    return train(config, runs, "train", parent)[0]


def completed(command, status=0):
    """Run a command to its end; what it printed."""
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=DEADLINE)
    assert done.returncode == status, done.stderr
    return done


def train(runs, *arguments):
    """Run the program to its end; returns the run directory."""
    completed(command(runs, *arguments))
    return (runs / "latest").resolve()


def progress(directory):
    with (directory / PROGRESS_FILE).open() as file:
        return list(csv.DictReader(file))


def tensorboard(directory):
    """Name of each scalar that TensorBoard shows -> its steps and values."""
    from tensorboard.backend.event_processing.event_accumulator import EventAccumulator

    events = EventAccumulator(str(directory / "tensorboard"))
    events.Reload()
    return {
        tag: ([event.step for event in events.Scalars(tag)], [event.value for event in events.Scalars(tag)])
        for tag in events.Tags()["scalars"]
    }


def assert_complete(directory, files=RUN_FILES):
    assert {path.name for path in directory.iterdir()} >= files
    policy = load_policy(directory)
    assert Parent.load(directory).timesteps == policy.card["timesteps"]
    assert progress(directory)
    assert policy.predict(np.zeros(policy.weights[0].shape[0])).shape == (8,)
    return policy


@contextlib.contextmanager
def running(runs, *arguments, command=command):
    """The program while it trains, from its second row of progress on."""
    process = subprocess.Popen(command(runs, *arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        file = runs / "latest" / PROGRESS_FILE
        wait_until(lambda: file.exists() and len(progress(runs / "latest")) >= 2, "progress", alive=process)
        yield process
    finally:
        process.kill()
        process.communicate()


@pytest.fixture(scope="session")
def run(tmp_path_factory):
    """A complete run of eight updates, without checkpoints on a machine of any speed."""
    config = TrainConfig(timesteps=8 * STEPS, name="first", checkpoint_seconds=1e6, **SMALL)
    return learn(tmp_path_factory.mktemp("runs"), config)
