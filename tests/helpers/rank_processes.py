"""Ranks as processes of a program that trains: those that run, die, or are asked to stop."""

import contextlib
import sys

import numpy as np
import psutil
import pytest
from trainings import ENDLESS, RUN_FILES, assert_complete, command, running
from waiting import output_of, wait_until

from quadruped_env.policies import load_policy
from quadruped_env.policies.files import CHECKPOINTS
from quadruped_env.training.resume import Parent


def torchrun(runs, *arguments):
    """Command of the program on two ranks that torchrun starts."""
    return [
        sys.executable,
        "-m",
        "torch.distributed.run",
        "--standalone",
        "--nproc-per-node",
        "2",
        *command(runs, *arguments)[1:],
    ]


def ranks_of(process):
    """The processes of the ranks, in their order."""
    found = []
    for child in psutil.Process(process.pid).children(recursive=True):
        with contextlib.suppress(psutil.Error):
            if "quadruped_env.scale.ranks.rank" in child.cmdline():
                found.append(child)
    return sorted(found, key=lambda child: child.cmdline()[-1])


def with_checkpoint(runs):
    return len(checkpoints_of(runs / "latest")) >= 2


def checkpoints_of(directory):
    """Checkpoints that are complete; the one that a killed rank was writing has a hidden name."""
    checkpoints = directory / CHECKPOINTS
    return [path for path in checkpoints.iterdir() if path.suffix != ".part"] if checkpoints.is_dir() else []


def assert_gone(processes):
    wait_until(lambda: not any(process.is_running() and process.status() != "zombie" for process in processes), "exit")


def check_death_of_a_rank(rank, runs, *options):
    """Kill a rank of two: the run ends with one error that names it and a command, and its checkpoints are whole."""
    with running(runs, *ENDLESS, "--ranks", "2", *options, "--checkpoint-seconds", "0.5") as process:
        wait_until(lambda: with_checkpoint(runs), "two checkpoints", alive=process)
        ranks = ranks_of(process)
        ranks[rank].kill()
        _, errors = output_of(process)
    assert process.returncode == 2
    assert_gone(ranks)
    lines = [line for line in errors.splitlines() if " error: " in line]
    assert len(lines) == 1, errors
    assert f"rank {rank} was killed by SIGKILL" in lines[0]
    assert "Traceback" not in errors
    directory = (runs / "latest").resolve()
    assert f"--resume {directory}" in lines[0]
    for checkpoint in checkpoints_of(directory):
        policy = load_policy(checkpoint)
        assert Parent.load(checkpoint).timesteps == policy.card["timesteps"]
        assert np.isfinite(policy.weights[0]).all()
    with pytest.warns(UserWarning, match="checkpoint"):
        assert Parent.load(directory).timesteps > 0


def check_signal(number, runs, *options, files=RUN_FILES):
    """Send a signal to a training on two ranks: all stop after a rollout, and what was learned is saved."""
    with running(runs, *ENDLESS, "--ranks", "2", *options) as process:
        ranks = ranks_of(process)
        process.send_signal(number)
        output, errors = output_of(process)
    assert process.returncode == 128 + number, errors
    assert f"stopped by {number.name}, and saved what was learned" in output
    assert_gone(ranks)
    card = assert_complete((runs / "latest").resolve(), files).card
    assert card["timesteps"] > 0
    assert card["interrupted"] == number.name
