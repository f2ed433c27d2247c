"""Ranks that torchrun, or srun with the same variables, has started."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.scale.ranks.job import Job, cores

_VARIABLES: Final = ("RANK", "WORLD_SIZE", "MASTER_ADDR", "MASTER_PORT")


@dataclass(frozen=True)
class Place:
    """This process among those that torchrun started."""

    rank: int
    ranks: int
    local_ranks: int
    """Number of ranks on this machine"""
    local_rank: int = 0
    """Index of this rank among them"""

    @property
    def on_one_machine(self) -> bool:
        """True if all ranks are on this machine."""
        return self.local_ranks == self.ranks

    @property
    def threads(self) -> int:
        """Threads of this rank."""
        return max(1, cores() // self.local_ranks)


def place(environment: Mapping[str, str] = os.environ) -> Place | None:
    """The place that torchrun's environment variables give this process; None without them.

    Raises:
        QuadrupedError: if only some of them are set, or have values that cannot be; the message names the variable.
    """
    if "WORLD_SIZE" not in environment:
        return None
    ranks = _number(environment, "WORLD_SIZE", 1)
    if ranks == 1:
        return None
    missing = [name for name in _VARIABLES if name not in environment]
    if missing:
        raise QuadrupedError(
            f"{missing[0]}: WORLD_SIZE is {ranks}, and this environment variable is missing; start the ranks with "
            f"torchrun, which sets both, or unset WORLD_SIZE"
        )
    rank, local_ranks, local_rank = _number(environment, "RANK", 0), 1, 0
    if rank >= ranks:
        raise QuadrupedError(f"RANK: expected 0 to {ranks - 1}, since WORLD_SIZE is {ranks}; found {rank}")
    if "LOCAL_WORLD_SIZE" in environment:
        local_ranks = _number(environment, "LOCAL_WORLD_SIZE", 1)
    if "LOCAL_RANK" in environment:
        local_rank = _number(environment, "LOCAL_RANK", 0)
    return Place(rank, ranks, local_ranks, local_rank)


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

    if here.on_one_machine:
        for name, value in ON_LOOPBACK.items():
            os.environ.setdefault(name, value)
    group = TorchGroup(here.rank, here.ranks, here.threads, {"init_method": "env://"}, here.local_rank)
    try:
        result = run_rank(job, group)
    except (RankLostError, DifferentWeightsError):
        if here.rank:
            raise SystemExit(1) from None
        raise
    # Not after an error: NCCL would wait for the other ranks, which wait for this one.
    group.close()
    return result


def _number(environment: Mapping[str, str], name: str, least: int) -> int:
    text = environment[name]
    if not text.isascii() or not text.isdigit() or int(text) < least:
        raise QuadrupedError(
            f"{name}: expected a whole number of {least} or more in this environment variable; found {short(text)}"
        )
    return int(text)
