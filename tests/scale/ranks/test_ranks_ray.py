"""Ranks on a Ray cluster of two nodes, both on this machine."""

import psutil
import pytest
from sweeps import ONE_MACHINE, name_of
from trainings import ENDLESS, TINY, assert_complete, running, train
from waiting import output_of

from quadruped_env import QuadrupedError
from quadruped_env.scale.ranks import ray_cluster
from quadruped_env.scale.ranks.job import Job
from quadruped_env.scale.ranks.torch_group import LOOPBACK, _interface_to
from quadruped_env.scale.ranks.training_launch import launch
from quadruped_env.training import TrainConfig
from quadruped_env.training.resume import Parent

RANKS = ("--ranks", "2", "--launcher", "ray")
TWO = TrainConfig(ranks=2)


@pytest.mark.parametrize(
    ("cpus", "ranks", "threads"), [([2], 2, 1), ([1, 1], 2, 1), ([8, 8], 2, 8), ([3, 1], 2, 1), ([16, 4.5], 5, 4)]
)
def test_each_rank_has_as_many_threads_as_all_can_have(cpus, ranks, threads):
    assert ray_cluster.threads_on(cpus, ranks) == threads


def test_cluster_with_fewer_cpus_than_ranks_is_an_error():
    with pytest.raises(QuadrupedError, match=r"--ranks: found 4; the Ray cluster has 3 CPUs on 2 nodes"):
        ray_cluster.threads_on([2, 1.5], 4)


def test_ray_without_a_cluster_is_an_error(tmp_path, monkeypatch):
    monkeypatch.delenv("RAY_ADDRESS", raising=False)
    with pytest.raises(QuadrupedError, match=r"--launcher: found ray without a cluster; give its --address"):
        launch(Job(TWO, tmp_path, "test"), launcher="ray")


@pytest.mark.parametrize(
    ("ranks", "options", "message"),
    [
        (1, {"launcher": "ray"}, r"--launcher: found ray with one rank.*--ranks 2"),
        (2, {"address": "a:1"}, r"--address: found a:1, which only Ray uses; add --launcher ray"),
    ],
)
def test_options_of_ray_without_their_use_are_errors(ranks, options, message, tmp_path):
    with pytest.raises(QuadrupedError, match=message):
        launch(Job(TrainConfig(ranks=ranks), tmp_path, "test"), **options)


def test_interface_on_the_way_to_this_machine_is_loopback():
    assert _interface_to("127.0.0.1", 1) == LOOPBACK


@pytest.fixture
def cluster(nodes, monkeypatch):
    """The address of a cluster of two nodes with one CPU each."""
    for name, value in ONE_MACHINE.items():
        monkeypatch.setenv(name, value)
    return nodes[0]


@pytest.mark.slow
def test_ranks_on_two_nodes_train_a_policy(cluster, tmp_path):
    directory = train(tmp_path, *TINY, *RANKS, "--address", cluster)
    assert assert_complete(directory).card["timesteps"] == int(TINY[1])
    assert Parent.load(directory).config.ranks == 2


@pytest.mark.slow
def test_rank_of_ray_that_dies_ends_the_run_with_one_error(cluster, tmp_path):
    with running(tmp_path, *ENDLESS, *RANKS, "--address", cluster) as process:
        (worker,) = (each for each in psutil.process_iter() if "ray::rank 1" in name_of(each))
        worker.kill()
        _, errors = output_of(process)
    assert process.returncode == 2
    (line,) = (line for line in errors.splitlines() if line.startswith("mini-quadruped train: error: "))
    assert "rank 1 died" in line
    assert str((tmp_path / "latest").resolve()) in line
