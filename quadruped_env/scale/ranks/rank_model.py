"""PPO on several ranks: the updates of one rank, with gradients and advantages of all ranks.

Each rank computes the gradient of its share of a batch, and the mean over ranks is that of the whole batch: Li et al.
2020, "PyTorch Distributed", https://arxiv.org/abs/2006.15704. Advantages are normalized over the whole batch, too.
"""

from collections.abc import Iterator
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


class SharedBuffer(RolloutBuffer):
    """A rank's rollout; the advantages of each batch are normalized over the shares of all ranks.

    Args:
        args, kwargs: of `RolloutBuffer`.
        group: this rank.
    """

    def __init__(self, *args: Any, group: Group, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._group = group

    def get(self, batch_size: int | None = None) -> Iterator[RolloutBufferSamples]:
        """See `RolloutBuffer`; of one epoch, whose sums the ranks exchange at once."""
        batches = list(super().get(batch_size))
        sums = torch.stack([moments(batch.advantages) for batch in batches])
        self._group.sum(sums)
        for batch, total in zip(batches, sums, strict=True):
            yield batch._replace(advantages=normalized(batch.advantages, total))


class DistributedPPO(PPO):
    """PPO on one of several ranks.

    Before the optimizer's step, gradients become the mean over all ranks, so each rank takes the same step.

    Args:
        args, kwargs: of SB3's PPO; `batch_size` is the rank's share of a batch.
        group: this rank, and the connection to the others.
    """

    def __init__(self, *args: Any, group: Group, **kwargs: Any) -> None:
        self.group = group
        if group.ranks > 1:
            kwargs |= {"normalize_advantage": False, "rollout_buffer_class": SharedBuffer}
            kwargs["rollout_buffer_kwargs"] = {"group": group}
        super().__init__(*args, **kwargs)

    def _setup_model(self) -> None:
        super()._setup_model()
        # Ranks begin with the same network, and explore with random numbers of their own.
        self.group.broadcast(self.policy.parameters())
        if self.group.rank:
            set_random_seed((self.seed + self.group.rank * self.n_envs) % 2**32)
        if self.group.ranks > 1:
            self._average_gradients(list(self.policy.parameters()))

    def _average_gradients(self, parameters: list[torch.nn.Parameter]) -> None:
        """Make each backward pass end with gradients that are the mean over the ranks."""
        done: list[torch.nn.Parameter] = []

        def note(parameter: torch.nn.Parameter) -> None:
            done.append(parameter)
            if len(done) == len(parameters):
                done.clear()
                self.group.average(parameter.grad for parameter in parameters if parameter.grad is not None)

        for parameter in parameters:
            parameter.register_post_accumulate_grad_hook(note)

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

    def _excluded_save_params(self) -> list[str]:
        return [*super()._excluded_save_params(), "group", "rollout_buffer_kwargs"]
