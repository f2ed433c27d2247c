"""rsl-rl's PPO on several ranks, each with a GPU: the updates of one rank, as in `model`."""

import functools
from collections.abc import Iterator
from typing import Any

import torch
from rsl_rl.storage import RolloutStorage
from tensordict import TensorDict

from quadruped_env.scale.gpu.warp_env import WarpVecEnv
from quadruped_env.scale.gpu.warp_ppo import NativePPO, make_ppo
from quadruped_env.scale.ranks.rank_model import moments, normalized
from quadruped_env.training.group import Group
from quadruped_env.training.train_config import TrainConfig


class SharedStorage(RolloutStorage):
    """A rank's rollout; the advantages of a batch are normalized over the shares of all ranks.

    Args:
        group: this rank.
        args: of `RolloutStorage`.
    """

    def __init__(self, group: Group, *args: Any) -> None:
        super().__init__(*args)
        self._group = group

    def mini_batch_generator(self, num_mini_batches: int, num_epochs: int = 8) -> Iterator[RolloutStorage.Batch]:
        """This rank's shares of the batches; each epoch has the same ones, as in `RolloutStorage`."""
        batches = list(super().mini_batch_generator(num_mini_batches, 1))
        sums = torch.stack([moments(batch.advantages) for batch in batches])
        self._group.sum(sums)
        for batch, total in zip(batches, sums, strict=True):
            batch.advantages = normalized(batch.advantages, total)
        for _ in range(num_epochs):
            yield from batches


class DistributedWarpPPO(NativePPO):
    """PPO on one of several ranks: before its norm is limited, a gradient becomes the mean over all ranks.

    rsl-rl can do this itself; `Group` adds errors that say which rank is lost.

    Args:
        args, kwargs: of `NativePPO`; the storage is a `SharedStorage`.
        group: this rank.
    """

    def __init__(self, *args: Any, group: Group, **kwargs: Any) -> None:
        place = {"global_rank": group.rank, "local_rank": group.local_rank, "world_size": group.ranks}
        super().__init__(*args, multi_gpu_cfg=place, **kwargs)
        self.normalize_advantage_per_mini_batch = False
        self._group = group
        group.broadcast(self.parameters())

    def parameters(self) -> list[torch.nn.Parameter]:
        """Parameters of both networks."""
        return [*self.actor.parameters(), *self.critic.parameters()]

    def reduce_parameters(self) -> None:
        """Replace the gradients by their mean over all ranks; rsl-rl calls this after each backward pass.

        Raises:
            RankLostError: if another rank ended or does not answer.
        """
        self._group.average(parameter.grad for parameter in self.parameters() if parameter.grad is not None)

    def compute_returns(self, obs: TensorDict) -> None:
        """Compute returns and advantages; see `PPO`."""
        super().compute_returns(obs)
        # Without rsl-rl's normalization over this rank's rollout: the storage normalizes each batch.
        self.storage.advantages = self.storage.returns - self.storage.values


def make_rank_ppo(config: TrainConfig, env: WarpVecEnv, group: Group) -> NativePPO:
    """PPO for a rank of a training: all begin with the same networks, and explore with random numbers of their own.

    Args:
        config: settings of the training.
        env: this rank's share of the envs.
        group: this rank; a training on one rank gets the plain PPO.
    """
    if group.ranks == 1:
        return make_ppo(config, env)
    kind = functools.partial(DistributedWarpPPO, group=group)
    ppo = make_ppo(config, env, kind, functools.partial(SharedStorage, group))
    if group.rank:
        torch.manual_seed(config.seed + group.rank * env.num_envs)
    return ppo
