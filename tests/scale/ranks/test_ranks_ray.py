"""Ranks on a Ray cluster of two nodes, both on this machine."""

import os
import re
import socket
import subprocess

import psutil
import pytest
from paths import importing
from trainings import ENDLESS, TINY, assert_complete, command, running
from waiting import DEADLINE, output_of

from quadruped_env import QuadrupedError
from quadruped_env.errors import MissingExtraError
from quadruped_env.scale.ranks import ray_cluster
from quadruped_env.scale.ranks.job import Job
from quadruped_env.scale.ranks.torch_group import LOOPBACK, _interface_to
from quadruped_env.scale.ranks.training_launch import launch
from quadruped_env.scale.ray_connection import check_answers
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


def test_address_that_does_not_answer_is_an_error_that_says_what_to_check():
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"127.0.0.1:{free.getsockname()[1]}"
    with pytest.raises(QuadrupedError, match=rf"--address: {address} does not answer .*`ray start --head` runs there"):
        check_answers(address)


@pytest.mark.parametrize("address", ["node-0", "ray://node-0:10001", ":6379", "node-0:port"])
def test_address_that_is_none_is_an_error(address):
    with pytest.raises(QuadrupedError, match=r"--address: expected host:port"):
        check_answers(address)


def test_ray_without_a_cluster_is_an_error(tmp_path, monkeypatch):
    monkeypatch.delenv("RAY_ADDRESS", raising=False)
    with pytest.raises(QuadrupedError, match=r"--launcher: found ray without a cluster; give its --address"):
        launch(Job(TWO, tmp_path, "test"), launcher="ray")


def test_ray_for_one_rank_is_an_error(tmp_path):
    with pytest.raises(QuadrupedError, match=r"--launcher: found ray with one rank.*--ranks 2"):
        launch(Job(TrainConfig(), tmp_path, "test"), launcher="ray")


def test_address_without_ray_is_an_error(tmp_path):
    with pytest.raises(QuadrupedError, match=r"--address: found a:1, which only Ray uses; add --launcher ray"):
        launch(Job(TWO, tmp_path, "test"), address="a:1")


def test_missing_ray_names_its_extra(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "ray", None)
    with pytest.raises(MissingExtraError, match=r"--launcher ray needs the 'sweep' extra"):
        launch(Job(TWO, tmp_path, "test"), launcher="ray", address="127.0.0.1:1")


def test_interface_on_the_way_to_this_machine_is_loopback():
    assert _interface_to("127.0.0.1", 1) == LOOPBACK


@pytest.fixture(scope="module")
def cluster():
    """The address of a cluster of two nodes with one CPU each."""
    pytest.importorskip("ray")
    from ray.cluster_utils import Cluster

    # Ray's processes import this package where the ranks run.
    before = os.environ.get("PYTHONPATH")
    os.environ["PYTHONPATH"] = importing()["PYTHONPATH"]
    cluster = Cluster()
    try:
        for _ in range(2):
            cluster.add_node(num_cpus=1, include_dashboard=False, object_store_memory=80 * 2**20)
        yield cluster.address
    finally:
        cluster.shutdown()
        os.environ.pop("PYTHONPATH")
        if before is not None:
            os.environ["PYTHONPATH"] = before


@pytest.mark.slow
def test_ranks_on_two_nodes_train_a_policy(cluster, tmp_path):
    done = subprocess.run(
        command(tmp_path, *TINY, *RANKS, "--address", cluster),
        capture_output=True,
        text=True,
        check=False,
        timeout=DEADLINE,
    )
    assert done.returncode == 0, done.stderr
    directory = (tmp_path / "latest").resolve()
    assert assert_complete(directory).card["timesteps"] == int(TINY[1])
    assert Parent.load(directory).config.ranks == 2


@pytest.mark.slow
def test_rank_of_ray_that_dies_ends_the_run_with_one_error(cluster, tmp_path):
    with running(tmp_path, *ENDLESS, *RANKS, "--address", cluster) as process:
        workers = [
            each for each in psutil.process_iter(["cmdline"]) if "ray::rank 1" in " ".join(each.info["cmdline"] or [])
        ]
        assert len(workers) == 1
        workers[0].kill()
        _, errors = output_of(process)
    assert process.returncode == 2
    lines = [line for line in errors.splitlines() if re.match(r"mini-quadruped train: error: ", line)]
    assert len(lines) == 1, errors
    assert "rank 1 died" in lines[0]
    assert str((tmp_path / "latest").resolve()) in lines[0]
