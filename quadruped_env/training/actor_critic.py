"""A policy that is left/right symmetric by construction.

With one network f, the mean action is (f(x) + mirror(f(mirror(x)))) / 2, and so is the value. Learning from scratch
takes a fraction of the samples that a free network takes (`evaluate/learning_speed.py`), and no side is preferred.
Symmetry in learned locomotion: Mittal et al. 2024, https://arxiv.org/abs/2403.04359.
"""

from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from stable_baselines3.common.policies import ActorCriticPolicy
from stable_baselines3.common.torch_layers import MlpExtractor

from quadruped_env.control.symmetry import MirrorMap

Layer = tuple[NDArray[np.float32], NDArray[np.float32]]
"""Weights (in, out) and biases (out,)"""


class _MirroredExtractor(MlpExtractor):
    """SB3's hidden layers, run on an observation and on its mirror image."""

    def __init__(self, mirror: MirrorMap, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.register_buffer("order", torch.as_tensor(mirror.observation_order), persistent=False)
        self.register_buffer("sign", torch.as_tensor(mirror.observation_sign), persistent=False)

    def _both(self, observation: torch.Tensor) -> torch.Tensor:
        return torch.stack([observation, observation.index_select(-1, self.order) * self.sign])

    def forward_actor(self, features: torch.Tensor) -> torch.Tensor:
        """(2, N, hidden): of the observation and of its mirror image."""
        return self.policy_net(self._both(features))

    def forward_critic(self, features: torch.Tensor) -> torch.Tensor:
        """(N, hidden): the mean over both, which the linear layer that follows turns into the mean value."""
        return self.value_net(self._both(features)).mean(0)


class SymmetricPolicy(ActorCriticPolicy):
    """SB3's actor and critic, left/right symmetric.

    Args:
        mirror: how observations and actions change when the robot is mirrored.
        args, kwargs: of `ActorCriticPolicy`.
    """

    def __init__(self, *args: Any, mirror: MirrorMap, **kwargs: Any) -> None:
        self.mirror = mirror
        super().__init__(*args, **kwargs)

    def _get_constructor_parameters(self) -> dict[str, Any]:
        return {**super()._get_constructor_parameters(), "mirror": self.mirror}

    def _build_mlp_extractor(self) -> None:
        self.mlp_extractor = _MirroredExtractor(
            self.mirror,
            self.features_dim,
            net_arch=self.net_arch,
            activation_fn=self.activation_fn,
            device=self.device,
        )
        self.register_buffer("action_order", torch.as_tensor(self.mirror.action_order), persistent=False)

    def _get_action_dist_from_latent(self, latent_pi: torch.Tensor) -> Any:
        one, other = self.action_net(latent_pi)
        return self.action_dist.proba_distribution(
            0.5 * (one + other.index_select(-1, self.action_order)), self.log_std
        )


def symmetrized(layers: list[Layer], mirror: MirrorMap) -> list[Layer]:
    """The symmetric policy over a plain network as one plain network of twice the width: f and its mirror, averaged."""
    (first, first_bias), *inner, (last, last_bias) = layers
    half = np.float32(0.5)
    mirrored = (first * mirror.observation_sign[:, None])[np.argsort(mirror.observation_order)]
    return [
        (np.concatenate([first, mirrored], axis=1), np.tile(first_bias, 2)),
        *((np.kron(np.eye(2, dtype=np.float32), weight), np.tile(bias, 2)) for weight, bias in inner),
        (half * np.concatenate([last, mirror.action(last)]), half * (last_bias + mirror.action(last_bias))),
    ]
