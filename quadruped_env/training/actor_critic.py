"""Actor and critic: left/right symmetric by construction, with a critic that may see privileged readings.

Every layer of a symmetric network commutes with the mirror: hidden units come in pairs, each the mirror image of the
other, and the weights of mirror images are the same. One pass gives a mean action that mirrors with the observation,
and a value that does not change. Learning from scratch takes a fraction of the samples that a free network takes
(`tools/learning_speed.py`), and no side is preferred. Symmetry in learned locomotion: Mittal et al. 2024,
https://arxiv.org/abs/2403.04359; equivariant perceptrons: Su et al. 2024, https://arxiv.org/abs/2403.17320. A critic
that sees what only the simulation knows: Pinto et al. 2018, https://arxiv.org/abs/1710.06542.
"""

from dataclasses import dataclass
from typing import Any, NamedTuple, Self

import numpy as np
import torch
from numpy.typing import NDArray
from stable_baselines3.common.policies import ActorCriticPolicy
from stable_baselines3.common.torch_layers import MlpExtractor

from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.envs.sb3 import MiniQuadrupedSB3VecEnv


@dataclass(frozen=True, eq=False)
class Mirrored:
    """Mirror of a layer's inputs or outputs: a permutation with signs, its own inverse."""

    order: NDArray[np.intp]
    sign: NDArray[np.float32]

    @classmethod
    def pairs(cls, width: int) -> Self:
        """Return the mirror of an even number of hidden units, of which the second half mirrors the first."""
        return cls(np.roll(np.arange(width), width // 2), np.ones(width, dtype=np.float32))

    @classmethod
    def same(cls, width: int) -> Self:
        """Return the mirror of values that do not change."""
        return cls(np.arange(width), np.ones(width, dtype=np.float32))


class Projection(NamedTuple):
    """Projection on values whose entries are, up to their sign, equal in pairs: half the sum with the mirror image."""

    order: torch.Tensor
    """Index of each entry's mirror image in the flat values, of the values' shape"""
    half: torch.Tensor
    """Half of the sign of the mirror image, of the values' shape"""

    def __call__(self, values: torch.Tensor) -> torch.Tensor:
        """Return projected values, of the same shape."""
        return torch.take(values, self.order).mul_(self.half).add_(values, alpha=0.5)


Tied = tuple[torch.nn.Parameter, Projection]
"""A parameter whose mirror images are the same, and the projection that keeps them so"""


def _projection(outputs: Mirrored, inputs: Mirrored | None = None) -> Projection:
    """Return the projection of a layer's weights (out, in) or biases (out,) on those that commute with the mirror.

    Projected gradients keep weights projected, because the two entries of a pair take the same steps, up to their sign.
    """
    order, sign = torch.as_tensor(outputs.order), torch.as_tensor(outputs.sign)
    # One gather over the flat array: entry (o, i) has its mirror image at the mirrored output and input.
    if inputs is not None:
        order = order[:, None] * len(inputs.order) + torch.as_tensor(inputs.order)
        sign = sign[:, None] * torch.as_tensor(inputs.sign)
    return Projection(order, 0.5 * sign)


def _tied(layer: torch.nn.Linear, inputs: Mirrored, outputs: Mirrored) -> list[Tied]:
    """Return parameters of a layer whose output is the mirror image when its input is."""
    return [(layer.weight, _projection(outputs, inputs)), (layer.bias, _projection(outputs))]


def _tied_perceptron(modules: list[torch.nn.Module], inputs: Mirrored, outputs: Mirrored) -> list[Tied]:
    tied = []
    layers = [module for module in modules if isinstance(module, torch.nn.Linear)]
    for layer in layers[:-1]:
        hidden = Mirrored.pairs(layer.out_features)
        tied += _tied(layer, inputs, hidden)
        inputs = hidden
    return tied + _tied(layers[-1], inputs, outputs)


class _Extractor(MlpExtractor):
    """SB3's hidden layers, for an actor that sees only the first columns of those that the critic sees."""

    def __init__(self, actor_width: int, feature_dim: int, **kwargs: Any) -> None:
        super().__init__(actor_width, **kwargs)
        if feature_dim != actor_width:
            critic = MlpExtractor(feature_dim, **kwargs)
            self.value_net, self.latent_dim_vf = critic.value_net, critic.latent_dim_vf
        self.actor_width = actor_width

    def forward_actor(self, features: torch.Tensor) -> torch.Tensor:
        """(N, hidden), of the observation alone."""
        return self.policy_net(features[..., : self.actor_width])


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
        self.tied: list[Tied] = []
        """Parameters that symmetry ties"""
        super().__init__(*args, **kwargs)

    def _get_constructor_parameters(self) -> dict[str, Any]:
        own = {"actor_width": self.actor_width, "mirror": self.mirror, "critic_mirror": self.critic_mirror}
        return {**super()._get_constructor_parameters(), **own}

    def _build_mlp_extractor(self) -> None:
        self.mlp_extractor = _Extractor(
            self.actor_width,
            self.features_dim,
            net_arch=self.net_arch,
            activation_fn=self.activation_fn,
            device=self.device,
        )

    def _build(self, lr_schedule: Any) -> None:
        super()._build(lr_schedule)
        if self.mirror is None or self.critic_mirror is None:
            return
        actions = Mirrored(self.mirror.action_order, self.mirror.action_sign)
        actor, critic = self.mlp_extractor.policy_net, self.mlp_extractor.value_net
        self.tied = [
            *_tied_perceptron([*actor, self.action_net], _observations(self.mirror), actions),
            *_tied_perceptron([*critic, self.value_net], _observations(self.critic_mirror), Mirrored.same(1)),
        ]
        self.project()
        for parameter, projection in self.tied:
            # The mean of a random weight and its mirror image is smaller than either.
            parameter.data *= np.sqrt(2.0)
            parameter.register_hook(projection)

    def project(self) -> None:
        """Make a symmetric network symmetric again, after anything but a gradient step has changed its parameters."""
        for parameter, projection in self.tied:
            parameter.data.copy_(projection(parameter.data))


def _observations(mirror: MirrorMap) -> Mirrored:
    return Mirrored(mirror.observation_order, mirror.observation_sign)


def mirrors(env: MiniQuadrupedSB3VecEnv) -> tuple[MirrorMap, MirrorMap]:
    """Return the mirror of an env's observations and actions, and the same with its privileged readings."""
    own = MirrorMap.of(env.task.control.layout)
    if env.privileged is None:
        return own, own
    more = MirrorMap.of(env.privileged.layout)
    order = np.concatenate([own.observation_order, len(own.observation_order) + more.observation_order])
    sign = np.concatenate([own.observation_sign, more.observation_sign])
    return own, MirrorMap(order, sign, own.action_order, own.action_sign)
