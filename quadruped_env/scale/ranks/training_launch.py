"""The ways to run a training: in this process, on ranks of this machine or of Ray, or as a rank of torchrun.

torchrun starts the ranks itself, and srun can with the same variables.
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, short
from quadruped_env.scale.ranks.job import Job, threads_per_rank
from quadruped_env.training.train_config import on_gpu

LAUNCHERS: Final = ("processes", "ray")
"""Values of `--launcher`."""


@dataclass(frozen=True)
class Place:
    """This process among those that torchrun started."""

    rank: int
    ranks: int
    local_ranks: int
    """Number of ranks on this machine"""
    local_rank: int
    """Index of this rank among them"""


def torchrun_place(environment: Mapping[str, str] = os.environ) -> Place | None:
    """The place that torchrun's environment variables give this process; None without other ranks.

    Raises:
        QuadrupedError: if one of them is missing or has a value that cannot be; the message names the variable.
    """
    ranks = _number(environment, "WORLD_SIZE", 1, "1")
    if ranks == 1:
        return None
    for name in ("MASTER_ADDR", "MASTER_PORT"):
        if name not in environment:
            raise _missing(name, ranks)
    rank, local_ranks = _number(environment, "RANK", 0), _number(environment, "LOCAL_WORLD_SIZE", 1, "1")
    if rank >= ranks:
        raise QuadrupedError(f"RANK: expected 0 to {ranks - 1}, since WORLD_SIZE is {ranks}; found {rank}")
    return Place(rank, ranks, local_ranks, _number(environment, "LOCAL_RANK", 0, "0"))


def check_ranks(asked: int, here: Place) -> None:
    """Check `--ranks` against the number of processes that torchrun started.

    Raises:
        QuadrupedError: if they differ.
    """
    if asked != here.ranks:
        raise QuadrupedError(
            f"--ranks: found {asked}, and torchrun started {here.ranks} processes (WORLD_SIZE); leave --ranks out, or "
            f"start as many"
        )


def launch(
    job: Job, here: Place | None = None, launcher: str = LAUNCHERS[0], address: str | None = None
) -> tuple[Path, bool] | None:
    """Run a training.

    Args:
        job: the training.
        here: the place of this process among those of torchrun, if that started it.
        launcher: what starts several ranks, one of `LAUNCHERS`.
        address: running cluster for Ray.

    Returns:
        The run directory, and whether the whole budget was used; None on ranks of torchrun that write no directory.

    Raises:
        QuadrupedError: as `quadruped_env.training.train.train`, or if a rank fails.
        MissingExtraError: if the extra `train` is not installed, or for Ray the extra `sweep`.
    """
    if address is not None and launcher != "ray":
        raise QuadrupedError(f"--address: found {address}, which only Ray uses; add --launcher ray, or leave it out")
    if launcher == "ray":
        if here is not None:
            raise QuadrupedError(
                "--launcher: found ray in a process that torchrun started (WORLD_SIZE); use one of the two"
            )
        if job.config.ranks == 1:
            raise QuadrupedError("--launcher: found ray with one rank, which needs no launcher; give --ranks 2 or more")
        if on_gpu(job.config.device):
            raise QuadrupedError(
                f"--launcher: found ray with --device {job.config.device}; Ray's ranks share CPUs here: leave "
                f"--launcher out for the GPUs of this machine, or start the ranks with torchrun"
            )
        from quadruped_env.scale.ranks.ray_cluster import train_on_ray

        return train_on_ray(job, address)
    if job.config.ranks > 1 and on_gpu(job.config.device):
        _check_gpus(job.config.ranks if here is None else here.local_ranks)
    if here is not None:
        return _train_here(job, here)
    if job.config.ranks > 1:
        from quadruped_env.scale.ranks.processes import train_in_processes

        return train_in_processes(job)
    # Torch takes seconds to import.
    from quadruped_env.scale.ranks.rank import train_job

    return train_job(job)


def _check_gpus(ranks: int) -> None:
    """Check that each of the ranks on this machine has a GPU of its own."""
    try:
        import torch
    except ImportError as error:
        raise MissingExtraError("--device cuda", "gpu") from error
    found = torch.cuda.device_count()
    if found >= ranks:
        return
    fix = f"choose --ranks {found}" if found else "check that nvidia-smi shows them and that torch is the CUDA build"
    raise QuadrupedError(
        f"--ranks: found {ranks} ranks on this machine with --device cuda, each of which needs a GPU of its own, and "
        f"torch finds {found} GPU{'' if found == 1 else 's'}; {fix}, or try it with --device warp-cpu"
    )


def _train_here(job: Job, here: Place) -> tuple[Path, bool] | None:
    """Train as the rank of torchrun that this process is; see `run_rank`.

    Raises:
        SystemExit: on other ranks than 0, after an error that rank 0 reports.
    """
    from quadruped_env.scale.ranks.rank import run_rank

    # isort: split
    from quadruped_env.scale.ranks.torch_group import ON_LOOPBACK, TorchGroup
    from quadruped_env.training.group import DifferentWeightsError, RankLostError

    if here.local_ranks == here.ranks:
        for name, value in ON_LOOPBACK.items():
            os.environ.setdefault(name, value)
    threads = threads_per_rank(here.local_ranks)
    group = TorchGroup(here.rank, here.ranks, threads, {"init_method": "env://"}, here.local_rank)
    try:
        return run_rank(job, group)
    except (RankLostError, DifferentWeightsError):
        if here.rank:
            raise SystemExit(1) from None
        raise


def _number(environment: Mapping[str, str], name: str, least: int, default: str | None = None) -> int:
    text = environment.get(name, default)
    if text is None:
        raise _missing(name, environment["WORLD_SIZE"])
    if not text.isascii() or not text.isdigit() or int(text) < least:
        raise QuadrupedError(
            f"{name}: expected a whole number of {least} or more in this environment variable; found {short(text)}"
        )
    return int(text)


def _missing(name: str, ranks: object) -> QuadrupedError:
    return QuadrupedError(
        f"{name}: WORLD_SIZE is {ranks}, and this environment variable is missing; start the ranks with torchrun, "
        f"which sets both, or unset WORLD_SIZE"
    )
