"""Policies of off-policy algorithms: actors squashed by tanh, which see the observation alone and may be symmetric."""

import functools
from types import ModuleType
from typing import Any

import gymnasium
import torch
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor

from quadruped_env.control.symmetry import MirrorMap

_LOG_STD = (-20.0, 2.0)
"""Bounds of the logarithm of the standard deviation, as in SB3's actors."""


class ObservationColumns(BaseFeaturesExtractor):
    """The observation without the privileged readings that follow it."""

    def __init__(self, space: gymnasium.Space[Any], width: int) -> None:
        super().__init__(space, width)
        self.width = width

    def forward(self, observations: torch.Tensor) -> torch.Tensor:
        """(N, width)."""
        return observations[..., : self.width]


@functools.cache
def squashed_policy(module: ModuleType, name: str) -> type[Any]:
    """Return a subclass of an off-policy algorithm's policy, with the arguments `actor_width` and `mirror`.

    Args:
        module: module of the policy and its class `Actor`.
        name: name of the policy.
    """
    base: Any = getattr(module, name)
    symmetric = _symmetric(module.Actor)

    class SquashedPolicy(base):
        """SB3's actor and critics; the critics may see more columns than the actor.

        Args:
            actor_width: number of columns that the actor sees: the observation, without privileged readings.
            mirror: how observations and actions change when the robot is mirrored; None: the policy is not symmetric.
            args, kwargs: of SB3's policy.
        """

        def __init__(self, *args: Any, actor_width: int, mirror: MirrorMap | None = None, **kwargs: Any) -> None:
            self.actor_width, self.mirror = actor_width, mirror
            super().__init__(*args, **kwargs)

        def _get_constructor_parameters(self) -> dict[str, Any]:
            own = {"actor_width": self.actor_width, "mirror": self.mirror}
            return {**super()._get_constructor_parameters(), **own}

        def make_actor(self, features_extractor: BaseFeaturesExtractor | None = None) -> Any:
            """Return the actor, with its own columns."""
            columns = ObservationColumns(self.observation_space, self.actor_width)
            if self.mirror is None:
                return super().make_actor(columns)
            arguments = self._update_features_extractor(self.actor_kwargs, columns)
            return symmetric(mirror=self.mirror, **arguments).to(self.device)

    return SquashedPolicy


@functools.cache
def _symmetric(base: Any) -> type[Any]:
    """Return a symmetric subclass of an actor: before tanh, f(x) and mirror(f(mirror(x))), averaged."""

    class SymmetricActor(base):
        """SB3's actor, left/right symmetric."""

        def __init__(self, *args: Any, mirror: MirrorMap, **kwargs: Any) -> None:
            super().__init__(*args, **kwargs)
            for name, values in (
                ("order", mirror.observation_order),
                ("sign", mirror.observation_sign),
                ("action_order", mirror.action_order),
                ("action_sign", mirror.action_sign),
            ):
                self.register_buffer(name, torch.as_tensor(values), persistent=False)

        def _both(self, observation: torch.Tensor) -> torch.Tensor:
            """Return features of the observations and of their mirror images, (2 N, width)."""
            features = self.extract_features(observation, self.features_extractor)
            return torch.cat([features, features.index_select(-1, self.order) * self.sign])

        def _mean(self, both: torch.Tensor) -> torch.Tensor:
            """Return the mean (N, J) of the actions of both sides (2 N, J)."""
            one, other = both.chunk(2)
            return 0.5 * (one + other.index_select(-1, self.action_order) * self.action_sign)

        def get_action_dist_params(self, obs: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor, dict[str, Any]]:
            """See SB3; of the actors with a Gaussian."""
            latent = self.latent_pi(self._both(obs))
            one, other = self.log_std(latent).chunk(2)
            log_std = 0.5 * (one + other.index_select(-1, self.action_order))
            return self._mean(self.mu(latent)), log_std.clamp(*_LOG_STD), {}

        def forward(self, obs: torch.Tensor, *args: Any, **kwargs: Any) -> torch.Tensor:
            """See SB3."""
            if hasattr(self, "latent_pi"):
                return super().forward(obs, *args, **kwargs)
            return torch.tanh(self._mean(self.mu[:-1](self._both(obs))))

    return SymmetricActor
