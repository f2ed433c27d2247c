"""The ranks of a training, and the sum over them, from which all else that they exchange is made."""

import datetime
import hashlib
import os
import socket
import struct
import sys
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any, Final

import torch

from quadruped_env.errors import QuadrupedError

TIMEOUT: Final = datetime.timedelta(minutes=5)
"""Longest wait for another rank: for its start, or for the slower one of two updates."""
LOOPBACK: Final = "lo0" if sys.platform == "darwin" else "lo"
"""Network interface of ranks on one machine."""
ON_LOOPBACK: Final[Mapping[str, str]] = MappingProxyType(
    {"GLOO_SOCKET_IFNAME": LOOPBACK, "NCCL_SOCKET_IFNAME": f"={LOOPBACK}"}
)
"""Environment of ranks on one machine. Gloo would listen on the host name's interface, and NCCL on any other one."""
_SIOCGIFADDR: Final = 0x8915
"""Linux's request for the address of a network interface, of <linux/sockios.h>."""


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


class TorchGroup(Group):
    """A rank that is connected to the others by `torch.distributed`: gloo for tensors on the CPU, NCCL on a GPU.

    Args:
        rank, ranks, threads, local_rank: see `Group`.
        rendezvous: how the ranks find each other: `init_method` or `store` of `init_process_group`.

    Raises:
        RankLostError: if the others do not come within `TIMEOUT`.
    """

    def __init__(self, rank: int, ranks: int, threads: int, rendezvous: dict[str, Any], local_rank: int = 0) -> None:
        super().__init__(rank, ranks, threads, local_rank)
        backend = "cpu:gloo,cuda:nccl" if torch.cuda.is_available() else "gloo"
        try:
            torch.distributed.init_process_group(backend, rank=rank, world_size=ranks, timeout=TIMEOUT, **rendezvous)
        except (RuntimeError, ValueError) as error:
            raise self._lost("did not connect", error) from error

    def sum(self, values: torch.Tensor) -> None:
        """See `Group`."""
        try:
            torch.distributed.all_reduce(values)
        except RuntimeError as error:
            raise self._lost("was lost", error) from error

    def close(self) -> None:
        """See `Group`."""
        torch.distributed.destroy_process_group()

    def _lost(self, event: str, error: Exception) -> RankLostError:
        reason = str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__
        return RankLostError(f"ranks: another of the {self.ranks} ranks {event} (rank {self.rank}: {reason})")


def on_this_machine(store: str, rank: int, ranks: int, threads: int) -> TorchGroup:
    """A rank whose others are all on this machine: a file instead of a server, and connections on loopback alone.

    Args:
        store: file that the ranks share, which must not exist before.
        rank: index of this rank.
        ranks: number of ranks.
        threads: threads of this rank.
    """
    os.environ.update(ON_LOOPBACK)
    return TorchGroup(rank, ranks, threads, {"store": torch.distributed.FileStore(store, ranks)}, local_rank=rank)


def over_network(host: str, port: int, rank: int, ranks: int, threads: int) -> TorchGroup:
    """A rank of several machines. Gloo uses the interface that leads to rank 0, unless GLOO_SOCKET_IFNAME names one.

    Args:
        host: address of rank 0, which listens there.
        port: free port of that machine.
        rank: index of this rank.
        ranks: number of ranks.
        threads: threads of this rank.
    """
    if (interface := _interface_to(host, port)) is not None:
        # By itself, gloo takes the address of the host's name, which on many machines is a loopback one.
        os.environ.setdefault("GLOO_SOCKET_IFNAME", interface)
    return TorchGroup(rank, ranks, threads, {"init_method": f"tcp://{host}:{port}"})


def _interface_to(host: str, port: int) -> str | None:
    """Name of the network interface on the way to a host; None where that is not known."""
    import fcntl  # which Windows does not have

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.connect((host, port))  # sends nothing
        own = probe.getsockname()[0]
        for _, name in socket.if_nameindex():
            try:
                answer = fcntl.ioctl(probe, _SIOCGIFADDR, struct.pack("256s", name.encode()))
            except OSError:
                continue  # has no address
            if socket.inet_ntoa(answer[20:24]) == own:
                return name
    return None


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
