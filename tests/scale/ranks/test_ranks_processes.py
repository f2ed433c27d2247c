"""A training on several ranks as processes: its files, what listens where, and ranks that die."""

import signal

import psutil
import pytest
from rank_processes import assert_gone, check_death_of_a_rank, check_signal, ranks_of, torchrun
from trainings import ENDLESS, TINY, assert_complete, command, completed, progress, running, scalars, train
from waiting import output_of

from quadruped_env.policies import load_policy
from quadruped_env.training.resume import Parent

pytestmark = pytest.mark.slow

RANKS = ("--ranks", "2")
STEPS = int(TINY[1])
"""Environment steps of a tiny training"""


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """A finished tiny training on two ranks."""
    return train(tmp_path_factory.mktemp("runs"), *TINY, *RANKS, "--recipe", "rough")


def test_run_of_two_ranks_is_complete_and_counts_the_steps_of_all(run):
    policy = assert_complete(run)
    assert policy.card["timesteps"] == STEPS
    parent = Parent.load(run)
    assert parent.config.ranks == 2
    assert len(list(run.parent.iterdir())) == 2, "one directory, and the link to it"
    assert int(progress(run)[-1]["timesteps"]) == STEPS
    assert "terrain/mean_level" in scalars(run)


def test_training_on_two_ranks_can_be_repeated_bit_for_bit(run, tmp_path):
    again = train(tmp_path, *TINY, *RANKS, "--recipe", "rough")
    assert (again / "policy.safetensors").read_bytes() == (run / "policy.safetensors").read_bytes()
    rows = [[{**row, "seconds": ""} for row in progress(directory)] for directory in (run, again)]
    assert rows[0][-1]["timesteps"] == rows[1][-1]["timesteps"]


def test_run_of_two_ranks_resumes_on_one_and_that_on_two(run, tmp_path):
    one = train(tmp_path / "one", "--resume", run, "--ranks", "1", "--timesteps", STEPS)
    assert load_policy(one).card["timesteps"] == 2 * STEPS
    two = train(tmp_path / "two", "--resume", one, "--ranks", "2", "--timesteps", STEPS)
    assert load_policy(two).card["timesteps"] == 3 * STEPS


def test_ranks_of_one_machine_listen_on_loopback_alone(tmp_path):
    with running(tmp_path, *ENDLESS, *RANKS) as process:
        processes = [psutil.Process(process.pid), *ranks_of(process)]
        assert len(processes) == 3
        connections = [connection for each in processes for connection in each.net_connections("inet")]
        assert connections, "the ranks are connected"
        assert {connection.laddr.ip for connection in connections} <= {"127.0.0.1", "::1"}


@pytest.mark.parametrize("rank", [0, 1])
def test_rank_that_dies_ends_the_run_with_one_error_and_a_whole_checkpoint(rank, tmp_path):
    check_death_of_a_rank(rank, tmp_path)


def test_ranks_end_with_the_process_that_watches_them(tmp_path):
    with running(tmp_path, *ENDLESS, *RANKS) as process:
        ranks = ranks_of(process)
        assert len(ranks) == 2
        process.kill()
        assert_gone(ranks)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signal_stops_all_ranks_after_a_rollout_and_saves(number, tmp_path):
    check_signal(number, tmp_path)


TASK = """
import sys
from quadruped_env import QuadrupedError
from quadruped_env.task import reward

@reward(weight=1.0, unit="1")
def broken(context):
    if sys.argv[-1].endswith("rank-1"):
        raise QuadrupedError("broken: cannot be computed")
    return 0.0 * context.velocity[:, 0]
"""
"""A reward that the second rank alone cannot compute"""


def test_error_of_a_rank_is_the_error_of_the_program(tmp_path):
    task = tmp_path / "task.py"
    task.write_text(TASK)
    done = completed(command(tmp_path / "runs", *TINY, *RANKS, "--task", task), status=2)
    lines = [line for line in done.stderr.splitlines() if " error: " in line]
    assert len(lines) == 1, done.stderr
    assert "rank 1: reward broken: QuadrupedError: broken: cannot be computed" in lines[0]


def test_budget_in_seconds_ends_all_ranks(tmp_path):
    directory = train(tmp_path, "--seconds", "2", *TINY[2:], *RANKS)
    assert assert_complete(directory).card["seconds"] >= 2


# --- torchrun ---


def test_rank_of_torchrun_that_dies_ends_the_run_with_one_error(tmp_path):
    with running(tmp_path, *ENDLESS, command=torchrun) as process:
        ranks = psutil.Process(process.pid).children()
        assert len(ranks) == 2
        next(rank for rank in ranks if rank.environ()["RANK"] == "1").kill()
        _, errors = output_of(process)
    assert process.returncode != 0
    assert_gone(ranks)
    lines = [line for line in errors.splitlines() if line.startswith("mini-quadruped train: error: ")]
    assert len(lines) == 1, errors
    assert "another of the 2 ranks was lost" in lines[0]


def test_torchrun_trains_like_ranks(run, tmp_path):
    done = completed(torchrun(tmp_path, *TINY, "--recipe", "rough"))
    assert done.stdout.count("trained ->") == 1
    directory = (tmp_path / "latest").resolve()
    assert_complete(directory)
    assert Parent.load(directory).config.ranks == 2
    assert (directory / "policy.safetensors").read_bytes() == (run / "policy.safetensors").read_bytes()
