"""The ranks of a training, and the sum over them, from which all else that they exchange is made."""

import hashlib
from collections.abc import Iterable
from typing import Any, Final

import torch

from quadruped_env.errors import QuadrupedError


class RankLostError(QuadrupedError):
    """Another rank ended, or did not answer in time: the training cannot go on."""


class DifferentWeightsError(QuadrupedError):
    """The ranks' weights differ after an update."""


class Group:
    """One of the ranks of a training. This class is that of a training on one rank: sums are over itself.

    Args:
        rank: index of this rank.
        ranks: number of ranks.
        threads: threads of this rank for the physics, with Warp also for updates; 0: all cores.
        local_rank: index of this rank among those of its machine, and of its GPU if it uses one.
    """

    ppo: type[Any] | None = None
    """Class of PPO on one of several ranks; None: Stable-Baselines3's own."""

    def __init__(self, rank: int = 0, ranks: int = 1, threads: int = 0, local_rank: int = 0) -> None:
        self.rank, self.ranks, self.threads, self.local_rank = rank, ranks, threads, local_rank

    def sum(self, values: torch.Tensor) -> None:
        """Replace values by their sum over all ranks, which has the same bits on each.

        Raises:
            RankLostError: if another rank ended or does not answer.
        """

    def close(self) -> None:
        """End the connections to the other ranks."""

    def broadcast(self, tensors: Iterable[torch.Tensor]) -> None:
        """Replace tensors by those of rank 0."""
        listed = list(tensors)
        values = flat(listed)
        if self.rank:
            values.zero_()
        self.sum(values)
        unflatten(values, listed)

    def average(self, tensors: Iterable[torch.Tensor]) -> None:
        """Replace tensors by their mean over all ranks, in one sum."""
        if self.ranks == 1:
            return
        listed = list(tensors)
        values = flat(listed)
        self.sum(values)
        unflatten(values / self.ranks, listed)

    def check_same(self, tensors: Iterable[torch.Tensor], moment: str) -> None:
        """Check that tensors have the same bits on all ranks.

        Args:
            tensors: the same ones on each rank, such as a network's weights.
            moment: the time of the check, for the message.

        Raises:
            DifferentWeightsError: on every rank, naming those that differ from rank 0.
        """
        sums = torch.zeros(self.ranks, dtype=torch.int64)
        sums[self.rank] = checksum(tensors)
        self.sum(sums)
        different = [rank for rank, value in enumerate(sums.tolist()) if value != sums[0]]
        if different:
            ranks = ", ".join(map(str, different[:8])) + ", ..." * (len(different) > 8)
            raise DifferentWeightsError(
                f"ranks: the weights of {ranks} differ from those of rank 0 {moment}; ranks need the same package "
                f"versions and the same types of CPU and GPU (ATEN_CPU_CAPABILITY=default makes torch round as on any "
                f"other CPU)"
            )


ALONE: Final = Group()
"""A training on one rank."""


def flat(tensors: Iterable[torch.Tensor]) -> torch.Tensor:
    """The values of tensors in a row, as a copy."""
    return torch.cat([tensor.detach().reshape(-1) for tensor in tensors])


def unflatten(values: torch.Tensor, tensors: Iterable[torch.Tensor]) -> None:
    """Write values that `flat` made, into the tensors."""
    start = 0
    for tensor in tensors:
        tensor.detach().copy_(values[start : start + tensor.numel()].view_as(tensor))
        start += tensor.numel()


def checksum(tensors: Iterable[torch.Tensor]) -> int:
    """Checksum of the bits of tensors, a signed whole number of 64 bits."""
    digest = hashlib.blake2b(digest_size=8)
    for tensor in tensors:
        digest.update(tensor.detach().cpu().contiguous().numpy().tobytes())
    return int.from_bytes(digest.digest(), "little", signed=True)
