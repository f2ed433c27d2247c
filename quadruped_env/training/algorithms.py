"""Algorithms of Stable-Baselines3 and sb3-contrib: where they are, and which settings of a training they use."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Final

_ON_POLICY: Final = frozenset(
    {"n_steps", "learning_rate", "gamma", "gae_lambda", "log_std_init", "final_log_std", "symmetric"}
)
_OFF_POLICY: Final = frozenset(
    {"n_steps", "learning_rate", "gamma", "batch_size", "buffer_size", "learning_starts", "gradient_steps", "symmetric"}
)
_SHORT: Final = {"timesteps": 3_000_000, "n_steps": 16, "log_std_init": -2.0, "final_log_std": -4.0}
"""Defaults of the other algorithms that learn from the last steps alone."""
_REPLAY: Final = {
    "timesteps": 3_000_000,
    "num_envs": 64,
    "n_steps": 1,
    "batch_size": 512,
    "learning_rate": 1e-3,
    "hidden": (128, 128),
}
"""Defaults of the algorithms with a replay buffer: an update after each step of all envs."""


@dataclass(frozen=True)
class Algorithm:
    """An algorithm by its class, with the fields of `TrainConfig` that only some algorithms use."""

    module: str
    """Module of its class, in `stable_baselines3` or `sb3_contrib`."""
    class_name: str
    settings: frozenset[str]
    """Fields of `TrainConfig` that it uses, of those in `SETTINGS`."""
    defaults: Mapping[str, Any] = field(default_factory=dict)
    """Its defaults for fields of `TrainConfig`, where they differ from PPO's."""
    policies: str = ""
    """Module of its policy and actor; empty for an on-policy algorithm, whose policy is `ActorCritic`."""
    policy: str = ""
    """Class of its policy."""

    @property
    def on_policy(self) -> bool:
        """True if it learns from the steps since the last update alone, with a Gaussian policy."""
        return not self.policies


def _off_policy(module: str, class_name: str, policies: str, policy: str, *settings: str) -> Algorithm:
    return Algorithm(module, class_name, _OFF_POLICY | set(settings), _REPLAY, policies, policy)


ALGORITHMS: Final[Mapping[str, Algorithm]] = MappingProxyType(
    {
        "ppo": Algorithm(
            "stable_baselines3.ppo",
            "PPO",
            _ON_POLICY | {"batch_size", "n_epochs", "desired_kl", "clip_range", "ent_coef", "max_grad_norm"},
        ),
        "a2c": Algorithm(
            "stable_baselines3.a2c",
            "A2C",
            _ON_POLICY | {"ent_coef", "max_grad_norm"},
            {**_SHORT, "learning_rate": 7e-4},
        ),
        "trpo": Algorithm(
            "sb3_contrib.trpo",
            "TRPO",
            _ON_POLICY | {"batch_size"},
            {**_SHORT, "batch_size": 1024, "learning_rate": 1e-3},
        ),
        "sac": _off_policy("stable_baselines3.sac", "SAC", "stable_baselines3.sac.policies", "SACPolicy", "tau"),
        "td3": _off_policy(
            "stable_baselines3.td3", "TD3", "stable_baselines3.td3.policies", "TD3Policy", "tau", "action_noise"
        ),
        "ddpg": _off_policy(
            "stable_baselines3.ddpg", "DDPG", "stable_baselines3.td3.policies", "TD3Policy", "tau", "action_noise"
        ),
        "tqc": _off_policy("sb3_contrib.tqc", "TQC", "sb3_contrib.tqc.policies", "TQCPolicy", "tau"),
        "crossq": _off_policy("sb3_contrib.crossq", "CrossQ", "sb3_contrib.crossq.policies", "CrossQPolicy"),
    }
)
"""The algorithms by name."""

SETTINGS: Final[frozenset[str]] = frozenset(name for entry in ALGORITHMS.values() for name in entry.settings)
"""Fields of `TrainConfig` that not every algorithm uses, and those that each uses in its own way."""
