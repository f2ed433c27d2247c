"""Ranks on a Ray cluster: rank 0 is this process, and the others are Ray's tasks.

Ray (https://docs.ray.io) only places the ranks and reports those that die; they exchange gradients by
`torch.distributed`. On one machine Ray is not needed, and would listen on all its networks: `processes` does the same.
"""

import logging
import os
import socket
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.scale.ranks.job import Job
from quadruped_env.scale.ranks.ray_address import check_answers, refused
from quadruped_env.training.run_directory import check_latest

_PLACE_SECONDS: Final = 60.0
"""Time that Ray has to find free CPUs for the ranks, s."""
_GRACE: Final = 10.0
"""Time that Ray has to report a rank that died, after rank 0 lost it, s."""


def train_on_ray(job: Job, address: str | None = None) -> tuple[Path, bool]:
    """Train with the ranks on a Ray cluster; its nodes need this package, and the files of `--task` and `--resume`.

    Args:
        job: the training.
        address: `host:port` of a running cluster, of which this machine is a node. None: RAY_ADDRESS.

    Returns:
        See `quadruped_env.training.train.train`.

    Raises:
        MissingExtraError: if Ray is not installed.
        QuadrupedError: if there is no address, it does not answer, the cluster is too small, or a rank fails.
    """
    check_latest(job.runs)
    address = address or os.environ.get("RAY_ADDRESS")
    if not address:
        raise QuadrupedError(
            "--launcher: found ray without a cluster; give its --address (or RAY_ADDRESS), which `ray start --head` "
            "prints, or leave --launcher out: on one machine the ranks need no Ray"
        )
    with _connected(address) as ray, TemporaryDirectory() as folder:
        nodes = [node for node in ray.nodes() if node["Alive"]]
        here = ray.util.get_node_ip_address()
        threads = threads_on([node["Resources"].get("CPU", 0.0) for node in nodes], job.config.ranks)
        if {node["NodeManagerAddress"] for node in nodes} == {here}:
            # A file, and connections on loopback alone.
            meeting = {"store": f"{folder}/store"}
        else:
            meeting = {"host": here, "port": str(_free_port(here))}
        group = _placed(ray, threads, job.config.ranks)
        try:
            remote = ray.remote(num_cpus=threads, max_retries=0)(_run_as_task)
            strategy = ray.util.scheduling_strategies.PlacementGroupSchedulingStrategy
            tasks = [
                remote.options(
                    scheduling_strategy=strategy(group, placement_group_bundle_index=rank), name=f"rank {rank}"
                ).remote(job.to_dict(), rank, threads, meeting)
                for rank in range(1, job.config.ranks)
            ]
            try:
                return _run_first(ray, tasks, job, threads, meeting)
            finally:
                for task in tasks:
                    ray.cancel(task, force=True)
        finally:
            ray.util.remove_placement_group(group)


def threads_on(cpus: Sequence[float], ranks: int) -> int:
    """Largest number of threads of which each rank can have as many on nodes with these numbers of CPUs.

    Raises:
        QuadrupedError: if there are fewer CPUs than ranks.
    """
    whole = [int(count) for count in cpus]
    for threads in range(max(whole, default=0), 0, -1):
        if sum(count // threads for count in whole) >= ranks:
            return threads
    raise QuadrupedError(
        f"--ranks: found {ranks}; the Ray cluster has {sum(whole)} CPUs on {len(whole)} nodes, and each rank needs "
        f"one: lower --ranks, or add nodes with `ray start --address`"
    )


def _run_as_task(values: dict[str, Any], rank: int, threads: int, meeting: dict[str, str]) -> None:
    """A rank other than 0, in a process of Ray."""
    _run(Job.from_dict(values), rank, threads, meeting)


def _run(job: Job, rank: int, threads: int, meeting: dict[str, str]) -> tuple[Path, bool] | None:
    from quadruped_env.scale.ranks.rank import run_rank

    # isort: split
    from quadruped_env.scale.ranks import torch_group

    ranks = job.config.ranks
    if "store" in meeting:
        group = torch_group.on_this_machine(meeting["store"], rank, ranks, threads)
    else:
        group = torch_group.over_network(meeting["host"], int(meeting["port"]), rank, ranks, threads)
    try:
        return run_rank(job, group)
    finally:
        group.close()


def _run_first(ray: Any, tasks: Sequence[Any], job: Job, threads: int, meeting: dict[str, str]) -> tuple[Path, bool]:
    """Rank 0, in this process. An error of another rank comes instead of the loss of that rank."""
    try:
        result = _run(job, 0, threads, meeting)
    except QuadrupedError as error:
        from quadruped_env.training.group import RankLostError

        if not isinstance(error, RankLostError):
            raise
        cause = _cause(ray, tasks)
        raise QuadrupedError(f"{cause}; {error}" if cause else str(error)) from error
    assert result is not None
    return result


def _cause(ray: Any, tasks: Sequence[Any]) -> str | None:
    """The error with which a task failed, if Ray reports one in time."""
    deadline = time.monotonic() + _GRACE
    waiting = dict(zip(tasks, range(1, len(tasks) + 1), strict=True))
    while waiting and time.monotonic() < deadline:
        ready, _ = ray.wait(list(waiting), num_returns=1, timeout=max(0.0, deadline - time.monotonic()))
        for task in ready:
            rank = waiting.pop(task)
            try:
                ray.get(task)
            except ray.exceptions.RayTaskError as error:
                own = error.cause
                if type(own).__name__ != "RankLostError":
                    return f"rank {rank}: {own}"
            except ray.exceptions.RayError as error:
                return f"ranks: rank {rank} died ({str(error).strip().splitlines()[0]})"
    return None


@contextmanager
def _connected(address: str) -> Iterator[Any]:
    """Ray's module, connected to a cluster."""
    try:
        import ray
        import ray.util.scheduling_strategies
    except ImportError as error:
        raise MissingExtraError("--launcher ray", "sweep") from error
    check_answers(address)
    try:
        ray.init(address=address, logging_level=logging.ERROR)
    except (ConnectionError, RuntimeError, ValueError) as error:
        raise refused(address, str(error).strip().splitlines()[0]) from error
    try:
        yield ray
    finally:
        ray.shutdown()


def _placed(ray: Any, threads: int, ranks: int) -> Any:
    """CPUs for all ranks, those of rank 0 on this node."""
    here = {"ray.io/node-id": ray.get_runtime_context().get_node_id()}
    group = ray.util.placement_group(
        [{"CPU": threads}] * ranks, strategy="PACK", bundle_label_selector=[here, *[{}] * (ranks - 1)]
    )
    if not group.wait(_PLACE_SECONDS):
        ray.util.remove_placement_group(group)
        raise QuadrupedError(
            f"--ranks: found {ranks}; Ray found no {threads} free CPUs for each within {_PLACE_SECONDS:g} s, the first "
            f"on this node: see `ray status`, wait for other jobs, or lower --ranks"
        )
    return group


def _free_port(host: str) -> int:
    with socket.socket() as listener:
        listener.bind((host, 0))
        return int(listener.getsockname()[1])
