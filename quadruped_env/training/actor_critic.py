"""Actor and critic: left/right symmetric by construction, with a critic that may see privileged readings.

With one network f, the mean action is (f(x) + mirror(f(mirror(x)))) / 2, and so is the value. Learning from scratch
takes a fraction of the samples that a free network takes (`evaluate/learning_speed.py`), and no side is preferred.
Symmetry in learned locomotion: Mittal et al. 2024, https://arxiv.org/abs/2403.04359. A critic that sees what only the
simulation knows: Pinto et al. 2018, https://arxiv.org/abs/1710.06542.
"""

from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from stable_baselines3.common.policies import ActorCriticPolicy
from stable_baselines3.common.torch_layers import MlpExtractor

from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.envs.sb3 import MiniQuadrupedSB3VecEnv

Layer = tuple[NDArray[np.float32], NDArray[np.float32]]
"""Weights (in, out) and biases (out,)"""


class _Extractor(MlpExtractor):
    """SB3's hidden layers, for an actor that sees only the first columns, and run on mirror images, too.

    Args:
        actor_width: number of columns that the actor sees, of all those that the critic sees.
        mirror: how the observation changes when the robot is mirrored; None: nothing is mirrored.
        critic_mirror: the same for all columns.
        feature_dim, net_arch, activation_fn, device: of `MlpExtractor`.
    """

    def __init__(
        self,
        actor_width: int,
        mirror: MirrorMap | None,
        critic_mirror: MirrorMap | None,
        feature_dim: int,
        **kwargs: Any,
    ) -> None:
        super().__init__(actor_width, **kwargs)
        if feature_dim != actor_width:
            critic = MlpExtractor(feature_dim, **kwargs)
            self.value_net, self.latent_dim_vf = critic.value_net, critic.latent_dim_vf
        self.actor_width = actor_width
        self.mirrored = mirror is not None
        for name, columns in (("actor", mirror), ("critic", critic_mirror)):
            if columns is not None:
                self.register_buffer(f"{name}_order", torch.as_tensor(columns.observation_order), persistent=False)
                self.register_buffer(f"{name}_sign", torch.as_tensor(columns.observation_sign), persistent=False)

    def forward_actor(self, features: torch.Tensor) -> torch.Tensor:
        """(N, hidden), or for a symmetric policy (2, N, hidden): of the observation and of its mirror image."""
        seen = features[..., : self.actor_width]
        if self.mirrored:
            seen = torch.stack([seen, seen.index_select(-1, self.actor_order) * self.actor_sign])
        return self.policy_net(seen)

    def forward_critic(self, features: torch.Tensor) -> torch.Tensor:
        """(N, hidden); of a symmetric policy the mean over both, which the linear layer turns into the mean value."""
        if not self.mirrored:
            return self.value_net(features)
        both = torch.stack([features, features.index_select(-1, self.critic_order) * self.critic_sign])
        return self.value_net(both).mean(0)


class ActorCritic(ActorCriticPolicy):
    """SB3's actor and critic, left/right symmetric if asked for; the critic may see more columns than the actor.

    Args:
        actor_width: number of columns that the actor sees: the observation, without privileged readings.
        mirror: how observations and actions change when the robot is mirrored; None: the policy is not symmetric.
        critic_mirror: the same with the privileged readings.
        args, kwargs: of `ActorCriticPolicy`.
    """

    def __init__(
        self,
        *args: Any,
        actor_width: int,
        mirror: MirrorMap | None = None,
        critic_mirror: MirrorMap | None = None,
        **kwargs: Any,
    ) -> None:
        self.actor_width, self.mirror, self.critic_mirror = actor_width, mirror, critic_mirror
        super().__init__(*args, **kwargs)

    def _get_constructor_parameters(self) -> dict[str, Any]:
        own = {"actor_width": self.actor_width, "mirror": self.mirror, "critic_mirror": self.critic_mirror}
        return {**super()._get_constructor_parameters(), **own}

    def _build_mlp_extractor(self) -> None:
        self.mlp_extractor = _Extractor(
            self.actor_width,
            self.mirror,
            self.critic_mirror,
            self.features_dim,
            net_arch=self.net_arch,
            activation_fn=self.activation_fn,
            device=self.device,
        )
        if self.mirror is not None:
            self.register_buffer("action_order", torch.as_tensor(self.mirror.action_order), persistent=False)

    def _get_action_dist_from_latent(self, latent_pi: torch.Tensor) -> Any:
        if self.mirror is None:
            return super()._get_action_dist_from_latent(latent_pi)
        one, other = self.action_net(latent_pi)
        return self.action_dist.proba_distribution(
            0.5 * (one + other.index_select(-1, self.action_order)), self.log_std
        )


def mirrors(env: MiniQuadrupedSB3VecEnv) -> tuple[MirrorMap, MirrorMap]:
    """Mirror of an env's observations and actions, and the same with its privileged readings."""
    own = MirrorMap.of(env.task.control.layout)
    if env.privileged is None:
        return own, own
    more = MirrorMap.of(env.privileged.layout)
    order = np.concatenate([own.observation_order, len(own.observation_order) + more.observation_order])
    return own, MirrorMap(order, np.concatenate([own.observation_sign, more.observation_sign]), own.action_order)


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
