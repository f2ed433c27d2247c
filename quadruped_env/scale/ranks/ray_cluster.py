"""Ranks on a Ray cluster: rank 0 is this process, and the others are Ray's tasks.

Ray (https://docs.ray.io) only places the ranks and reports those that die; they exchange gradients by
`torch.distributed`. On one machine Ray is not needed: `processes` does the same.
"""

import os
import socket
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.scale.ranks.job import Job
from quadruped_env.scale.ray_connection import check_answers, check_installed, connected
from quadruped_env.training.run_directory import check_latest
from quadruped_env.training.user_classes import absolute_name

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
    check_installed("--launcher ray")
    check_answers(address)
    ranks = job.config.ranks
    # The other machines' processes have another working directory.
    config = replace(job.config, algo=absolute_name(job.config.algo), policy=absolute_name(job.config.policy))
    resume, task_file = (None if path is None else path.resolve() for path in (job.resume, job.task_file))
    there = replace(job, config=config, resume=resume, task_file=task_file)
    with connected(address) as ray:
        from ray.util.scheduling_strategies import PlacementGroupSchedulingStrategy

        threads = threads_on([node["Resources"].get("CPU", 0.0) for node in ray.nodes() if node["Alive"]], ranks)
        host = ray.util.get_node_ip_address()
        meeting = host, _free_port(host)
        group = _placed(ray, threads, ranks)
        run = ray.remote(num_cpus=threads, max_retries=0)(_run)
        tasks = []
        for rank in range(1, ranks):
            place = PlacementGroupSchedulingStrategy(group, placement_group_bundle_index=rank)
            own = run.options(scheduling_strategy=place, name=f"rank {rank}")
            tasks.append(own.remote(there, rank, threads, meeting))
        try:
            return _run_first(ray, tasks, job, threads, meeting)
        finally:
            for task in tasks:
                ray.cancel(task, force=True)
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


def _run(job: Job, rank: int, threads: int, meeting: tuple[str, int]) -> tuple[Path, bool] | None:
    from quadruped_env.scale.ranks.rank import run_rank

    # isort: split
    from quadruped_env.scale.ranks.torch_group import over_network

    group = over_network(*meeting, rank, job.config.ranks, threads)
    try:
        return run_rank(job, group)
    except BaseException:
        # Ray's process lives on, and the other ranks would wait for this one.
        group.close()
        raise


def _run_first(ray: Any, tasks: Sequence[Any], job: Job, threads: int, meeting: tuple[str, int]) -> tuple[Path, bool]:
    """Rank 0, in this process. An error of another rank comes instead of the loss of that rank."""
    try:
        result = _run(job, 0, threads, meeting)
    except QuadrupedError as error:
        from quadruped_env.training.group import RankLostError

        cause = _cause(ray, tasks) if isinstance(error, RankLostError) else None
        if cause is None:
            raise
        raise QuadrupedError(f"{cause}; {error}") from error
    assert result is not None
    return result


def _cause(ray: Any, tasks: Sequence[Any]) -> str | None:
    """The error with which a task failed, if Ray reports one in time."""
    ended, _ = ray.wait(tasks, num_returns=len(tasks), timeout=_GRACE)
    for task in ended:
        rank = tasks.index(task) + 1
        try:
            ray.get(task)
        except ray.exceptions.RayTaskError as error:
            if type(error.cause).__name__ != "RankLostError":
                return f"rank {rank}: {error.cause}"
        except ray.exceptions.RayError as error:
            return f"ranks: rank {rank} died ({str(error).strip().splitlines()[0]})"
    return None


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
