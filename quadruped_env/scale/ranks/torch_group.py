"""Ranks that `torch.distributed` connects: on this machine over loopback alone, or over a network."""

import contextlib
import datetime
import os
import socket
import struct
import sys
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, Final

import torch

from quadruped_env.training.group import Group, RankLostError

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


class RankGroup(Group):
    """One of the ranks of a training, whose updates take part in those of all ranks."""

    @property
    def ppo(self) -> type[Any]:  # type: ignore[override]
        """See `Group`."""
        from quadruped_env.scale.ranks.rank_model import DistributedPPO

        return DistributedPPO


class TorchGroup(RankGroup):
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
    """A rank whose others are all on this machine: they meet in a new file, and connect on loopback alone."""
    os.environ.update(ON_LOOPBACK)
    return TorchGroup(rank, ranks, threads, {"store": torch.distributed.FileStore(store, ranks)}, local_rank=rank)


def over_network(host: str, port: int, rank: int, ranks: int, threads: int) -> TorchGroup:
    """A rank of several machines, of which rank 0 listens at an address and a free port.

    Gloo uses the interface that leads to rank 0, unless GLOO_SOCKET_IFNAME names one.
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
        own = socket.inet_aton(probe.getsockname()[0])
        for _, name in socket.if_nameindex():
            with contextlib.suppress(OSError):  # one without an address
                if fcntl.ioctl(probe, _SIOCGIFADDR, struct.pack("256s", name.encode()))[20:24] == own:
                    return name
    return None
