"""PPO on several ranks: the updates of one rank, with gradients and advantages of all ranks.

Each rank computes the gradient of its share of a batch, and the mean over ranks is that of the whole batch: Li et al.
2020, "PyTorch Distributed", https://arxiv.org/abs/2006.15704. Advantages are normalized over the whole batch, too.
"""

from typing import Any

import torch
from stable_baselines3.common.utils import set_random_seed

from quadruped_env.training.group import Group
from quadruped_env.training.sb3_models import native
from quadruped_env.training.step_statistics import StepStatistics

_EPSILON = 1e-8
"""Added to the standard deviation of advantages, as in SB3."""


def moments(values: torch.Tensor) -> torch.Tensor:
    """Number, sum and sum of squares of values; those of several ranks add up."""
    double = values.double()
    return torch.stack([double.new_tensor(double.numel()), double.sum(), (double * double).sum()])


def normalized(values: torch.Tensor, total: torch.Tensor) -> torch.Tensor:
    """Values less the mean, over the standard deviation, of all values with these `moments`."""
    count, first, second = total
    mean = first / count
    variance = ((second - count * mean * mean) / (count - 1)).clamp(min=0.0)
    return ((values.double() - mean) / (variance.sqrt() + _EPSILON)).to(values.dtype)


class DistributedPPO(native("ppo")):  # type: ignore[misc]
    """PPO on one of several ranks.

    Before the optimizer's step, gradients become the mean over all ranks, so each rank takes the same step.

    Args:
        args, kwargs: of SB3's PPO; `batch_size` is the rank's share of a batch.
        group: this rank, and the connection to the others.
    """

    def __init__(self, *args: Any, group: Group, **kwargs: Any) -> None:
        self.group = group
        super().__init__(*args, **kwargs)

    def _setup_model(self) -> None:
        super()._setup_model()
        # Ranks begin with the same network, and explore with random numbers of their own.
        self.group.broadcast(self.policy.parameters())
        if self.group.rank:
            set_random_seed((self.seed + self.group.rank * self.n_envs) % 2**32)

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
        super().train()
        self.group.check_same(self.policy.parameters(), f"after {self.num_timesteps:,} steps")

    def _normalized(self, batches: list[torch.Tensor]) -> list[torch.Tensor]:
        """Advantages of each batch, of which this rank has a share, normalized over the shares of all ranks."""
        if self.group.ranks == 1:
            return super()._normalized(batches)
        sums = torch.stack([moments(batch) for batch in batches])
        self.group.sum(sums)
        return [normalized(batch, total) for batch, total in zip(batches, sums, strict=True)]

    def _limit_gradients(self) -> None:
        """Gradients become the mean over ranks, with a limited norm."""
        self.group.average([self._gradient.values])
        super()._limit_gradients()

    def _excluded_save_params(self) -> list[str]:
        return [*super()._excluded_save_params(), "group"]
