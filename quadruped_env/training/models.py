"""PPO by Stable-Baselines3, on the native vector environment: its network, its schedules, and its policy as data.

Schulman et al. 2017, https://arxiv.org/abs/1707.06347; the massively parallel setting follows Rudin et al. 2021,
https://arxiv.org/abs/2109.11978.
"""

import os
import time
from typing import Any

# Torch's idle threads would spin on the cores that the physics needs. Read once, when torch is loaded.
os.environ.setdefault("OMP_WAIT_POLICY", "PASSIVE")

from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.policies import Policy
from quadruped_env.task import TaskConfig
from quadruped_env.training.config import TrainConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run import RESUME_FILE

try:
    import torch
    from stable_baselines3 import PPO

    from quadruped_env.training.symmetric import SymmetricPolicy, symmetrized
except ImportError as error:  # pragma: no cover
    raise MissingExtraError("training", "train") from error

_ACTIVATIONS = {"elu": torch.nn.ELU, "relu": torch.nn.ReLU, "tanh": torch.nn.Tanh}
_FINAL_LEARNING_RATE = 0.1
"""Share of the first learning rate that is left at the end."""


class NativePPO(PPO):
    """SB3's PPO with threads where they help, and schedules that can follow the wall clock and go on from a run's.

    A policy step for a few hundred envs is faster on one thread; an update is faster on all of them.
    """

    budget_seconds: float | None = None
    budget_left_at_start: float = 1.0
    """Share of the schedules that is left at the start; they reach their ends with the budget's"""
    log_std_bounds: tuple[float, float] | None = None
    """Upper bounds of the exploration's log standard deviation, at the start and at the end of the budget"""
    _started: float = 0.0

    def collect_rollouts(self, *args: Any, **kwargs: Any) -> bool:
        """See SB3."""
        torch.set_num_threads(1)
        if self.log_std_bounds is not None:
            first, final = self.log_std_bounds
            bound = final + (first - final) * self._current_progress_remaining
            self.policy.log_std.data.clamp_(max=bound)
        return super().collect_rollouts(*args, **kwargs)

    def train(self) -> None:
        """See SB3."""
        torch.set_num_threads(os.cpu_count() or 1)
        super().train()

    def _setup_learn(self, *args: Any, **kwargs: Any) -> Any:
        self._started = time.perf_counter()
        return super()._setup_learn(*args, **kwargs)

    def _update_current_progress_remaining(self, num_timesteps: int, total_timesteps: int) -> None:
        self._current_progress_remaining = self.budget_left()

    def budget_left(self) -> float:
        """Share of the schedules that is left, from 1 at the start of a first training to 0."""
        start = self._num_timesteps_at_start
        if self.budget_seconds is not None:
            used = (time.perf_counter() - self._started) / self.budget_seconds
        else:
            used = (self.num_timesteps - start) / max(1, self._total_timesteps - start)
        return self.budget_left_at_start * max(0.0, 1.0 - used)

    def go_on_from(self, parent: Parent) -> None:
        """Take over a run's network, optimizer, step count and place in the schedules.

        Raises:
            QuadrupedError: if its file cannot be read.
        """
        path = parent.directory / RESUME_FILE
        try:
            self.set_parameters(str(path), device="cpu")
        except Exception as error:
            # The zip reader, torch and SB3 each fail in their own way on a damaged file.
            raise QuadrupedError(f"{path}: cannot be read ({error}); start a new training") from error
        self.num_timesteps = parent.timesteps
        self.budget_left_at_start = self._current_progress_remaining = parent.budget_left


class LinearSchedule:
    """A learning rate that falls linearly with the share of the budget that is left."""

    def __init__(self, start: float) -> None:
        self.start = start

    def __call__(self, progress_remaining: float) -> float:
        """The rate when this share of the budget is left."""
        return self.start * (_FINAL_LEARNING_RATE + (1.0 - _FINAL_LEARNING_RATE) * progress_remaining)


def make_model(config: TrainConfig, env: Any) -> NativePPO:
    """A fresh PPO for a training."""
    torch.distributions.Distribution.set_default_validate_args(False)
    model = NativePPO(
        SymmetricPolicy if config.symmetric else "MlpPolicy",
        env,
        seed=config.seed,
        device="cpu",
        verbose=0,
        n_steps=config.n_steps,
        batch_size=config.batch_size,
        n_epochs=config.n_epochs,
        learning_rate=LinearSchedule(config.learning_rate),
        gamma=config.gamma,
        gae_lambda=config.gae_lambda,
        clip_range=config.clip_range,
        ent_coef=config.ent_coef,
        max_grad_norm=config.max_grad_norm,
        policy_kwargs=({"mirror": MirrorMap.of(env.task.control.layout)} if config.symmetric else {})
        | {
            "net_arch": {"pi": list(config.hidden), "vf": list(config.hidden)},
            "activation_fn": _ACTIVATIONS[config.activation],
            "log_std_init": config.first_log_std,
        },
    )
    model.log_std_bounds = (config.first_log_std, min(config.first_log_std, config.final_log_std))
    return model


def export_policy(model: PPO, task: TaskConfig, activation: str, card: dict[str, Any]) -> Policy:
    """The deterministic part of SB3's policy as plain arrays."""
    network = model.policy.mlp_extractor.policy_net
    linear = [layer for layer in network if isinstance(layer, torch.nn.Linear)] + [model.policy.action_net]
    layers = [(layer.weight.detach().numpy().T.copy(), layer.bias.detach().numpy().copy()) for layer in linear]
    if isinstance(model.policy, SymmetricPolicy):
        layers = symmetrized(layers, model.policy.mirror)
    return Policy(
        weights=tuple(weight for weight, _ in layers),
        biases=tuple(bias for _, bias in layers),
        activation=activation,
        config=task,
        card=card,
    )
