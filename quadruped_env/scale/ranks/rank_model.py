"""PPO on several ranks: the updates of one rank, with gradients and advantages of all ranks.

Each rank computes the gradient of its share of a batch, and the mean over ranks is that of the whole batch: Li et al.
2020, "PyTorch Distributed", https://arxiv.org/abs/2006.15704. Advantages are normalized over the whole batch, too.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Any

import torch
from stable_baselines3 import PPO
from stable_baselines3.common.buffers import RolloutBuffer
from stable_baselines3.common.type_aliases import RolloutBufferSamples
from stable_baselines3.common.utils import set_random_seed

from quadruped_env.training.group import Group
from quadruped_env.training.step_statistics import StepStatistics

_EPSILON = 1e-8
"""Added to the standard deviation of advantages, as in SB3."""


def normalized_over_ranks(batches: Sequence[torch.Tensor], group: Group) -> list[torch.Tensor]:
    """Advantages of some batches, each over the shares of all ranks: less their mean, over their standard deviation."""
    double = [batch.double() for batch in batches]
    sums = torch.stack([torch.stack([torch.ones_like(x).sum(), x.sum(), (x * x).sum()]) for x in double])
    group.sum(sums)
    count, first, second = sums.T
    mean = first / count
    deviation = ((second - count * mean * mean) / (count - 1.0)).clamp(min=0.0).sqrt()
    shared = zip(double, mean, deviation, batches, strict=True)
    return [((x - center) / (width + _EPSILON)).to(batch.dtype) for x, center, width, batch in shared]


def average_before_steps(
    optimizer: torch.optim.Optimizer, parameters: Sequence[torch.nn.Parameter], group: Group, max_norm: float
) -> None:
    """Let gradients become the mean over all ranks, with a limited norm, before each step of an optimizer."""

    def share(*_: Any) -> None:
        group.average(parameter.grad for parameter in parameters if parameter.grad is not None)
        torch.nn.utils.clip_grad_norm_(parameters, max_norm)

    optimizer.register_step_pre_hook(share)


class SharedBuffer(RolloutBuffer):
    """A rank's rollout; the advantages of each batch are normalized over the shares of all ranks."""

    group: Group

    def get(self, batch_size: int | None = None) -> Iterator[RolloutBufferSamples]:
        """See `RolloutBuffer`; of one epoch, whose sums the ranks exchange at once."""
        batches = list(super().get(batch_size))
        shared = normalized_over_ranks([batch.advantages for batch in batches], self.group)
        for batch, advantages in zip(batches, shared, strict=True):
            yield batch._replace(advantages=advantages)


class DistributedPPO(PPO):
    """Stable-Baselines3's PPO on one of several ranks, all of which take the same steps with the same weights.

    Args:
        args, kwargs: of `PPO`; `batch_size` is the rank's share of a batch.
        group: this rank, and the connection to the others.
    """

    max_grad_norm: float

    def __init__(self, *args: Any, group: Group, **kwargs: Any) -> None:
        self.group = group
        if group.ranks > 1:
            kwargs |= {"normalize_advantage": False, "rollout_buffer_class": SharedBuffer}
        super().__init__(*args, **kwargs)

    def _setup_model(self) -> None:
        super()._setup_model()
        # Ranks begin with the same network, and explore with random numbers of their own.
        parameters = list(self.policy.parameters())
        self.group.broadcast(parameters)
        if self.group.rank:
            set_random_seed((self.seed + self.group.rank * self.n_envs) % 2**32)
        if self.group.ranks > 1:
            self.rollout_buffer.group = self.group
        average_before_steps(self.policy.optimizer, parameters, self.group, self.max_grad_norm)

    def set_random_seed(self, seed: int | None = None) -> None:
        """Seed the network as on all ranks, and the envs by their indices among those of all ranks."""
        super().set_random_seed(seed)
        if seed is not None and self.group.rank:
            self.env.seed(seed + self.group.rank * self.n_envs)

    def collect_rollouts(self, env: Any, callback: Any, *args: Any, **kwargs: Any) -> bool:
        """See SB3; False after a rollout in which one of the ranks was asked to stop."""
        collected = super().collect_rollouts(env, callback, *args, **kwargs)
        return collected and not (isinstance(callback, StepStatistics) and callback.ended)

    def train(self) -> None:
        """Update the policy, and check that all ranks have the same one.

        Raises:
            DifferentWeightsError: if they have not.
        """
        # The gradient is clipped after the mean, not before.
        limit, self.max_grad_norm = self.max_grad_norm, math.inf
        super().train()
        self.max_grad_norm = limit
        self.group.check_same(self.policy.parameters(), f"after {self.num_timesteps:,} steps")

    def _excluded_save_params(self) -> list[str]:
        return [*super()._excluded_save_params(), "group"]
