"""Ranks that torchrun, or srun with the same variables, has started."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.scale.ranks.job import Job, threads_per_rank


@dataclass(frozen=True)
class Place:
    """This process among those that torchrun started."""

    rank: int
    ranks: int
    local_ranks: int
    """Number of ranks on this machine"""
    local_rank: int
    """Index of this rank among them"""


def place(environment: Mapping[str, str] = os.environ) -> Place | None:
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


def train_here(job: Job, here: Place) -> tuple[Path, bool] | None:
    """Train as the rank that this process is.

    Returns:
        See `quadruped_env.scale.ranks.rank.run_rank`.

    Raises:
        QuadrupedError: if a rank fails.
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
