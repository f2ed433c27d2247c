"""PPO of rsl-rl with this project's networks and the details of Stable-Baselines3's PPO."""

import functools
import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import torch
from rsl_rl.algorithms import PPO
from rsl_rl.models import MLPModel
from rsl_rl.storage import RolloutStorage
from tensordict import TensorDict

from quadruped_env.control.symmetry import MirrorMap
from quadruped_env.scale.gpu.warp_env import FINAL, OBSERVATION, PRIVILEGED, TIME_OUTS, WarpVecEnv
from quadruped_env.scale.ranks.rank_model import average_before_steps, normalized_over_ranks
from quadruped_env.training.group import ALONE, Group
from quadruped_env.training.train_config import TrainConfig, equal_batches

_OUTPUT_GAIN = {"actor": 0.01, "critic": 1.0}
"""Gain of the last layer's initial weights, that of Stable-Baselines3: the first actions are close to zero."""
_VALUE_LOSS = 0.5
"""Weight of the value function's loss, that of Stable-Baselines3."""
_ADAM_EPS = 1e-5
_ACTIVATIONS = {"leaky_relu": "lrelu", "silu": "swish"}
"""Names of activation functions in rsl-rl, where they differ."""


class Network(MLPModel):
    """rsl-rl's perceptron, symmetric if asked for: the mean of its outputs for an observation and its mirror image.

    Args:
        args, kwargs: of `MLPModel`.
        order: source column of each column of the mirrored input; None: the network is not symmetric.
        sign: sign of each of these columns.
        output_order: source of each mirrored output; None: a mirrored output is the same.
        output_sign: sign of each of these outputs.
    """

    def __init__(
        self,
        *args: Any,
        order: np.ndarray | None = None,
        sign: np.ndarray | None = None,
        output_order: np.ndarray | None = None,
        output_sign: np.ndarray | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(*args, **kwargs)
        buffers = {"order": order, "sign": sign, "output_order": output_order, "output_sign": output_sign}
        for name, values in buffers.items():
            self.register_buffer(name, None if values is None else torch.as_tensor(values), persistent=False)
        role = "critic" if self.distribution is None else "actor"
        self.mlp.init_weights([math.sqrt(2.0)] * (len(self.mlp) - 1) + [_OUTPUT_GAIN[role]])

    def forward(
        self, obs: TensorDict, masks: Any = None, hidden_state: Any = None, stochastic_output: bool = False
    ) -> torch.Tensor:
        """Actions (N, J) or values (N, 1); see `MLPModel.forward`."""
        seen = self.get_latent(obs, masks, hidden_state)
        output = self.mlp(seen)
        if self.order is not None:
            mirrored = self.mlp(seen.index_select(-1, self.order) * self.sign)
            if self.output_order is not None:
                mirrored = mirrored.index_select(-1, self.output_order) * self.output_sign
            output = 0.5 * (output + mirrored)
        if self.distribution is None:
            return output
        if not stochastic_output:
            return self.distribution.deterministic_output(output)
        self.distribution.update(output)
        return self.distribution.sample()


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
        # Not rsl-rl's advantages, which are normalized over the rank's own rollout.
        shared = normalized_over_ranks([batch.returns - batch.values for batch in batches], self._group)
        for batch, advantages in zip(batches, shared, strict=True):
            batch.advantages = advantages
        for _ in range(num_epochs):
            yield from batches


class NativePPO(PPO):
    """rsl-rl's PPO with three details of Stable-Baselines3's, for which the settings of a training were chosen.

    - Where the time limit ends an episode, the value of its last observation is added to the reward. rsl-rl adds that
      of the observation before.
    - The gradients of policy and value function are clipped together, of several ranks their mean. While the value
      function learns the scale of the returns, its large gradient keeps the policy's steps small.
    - Adam's `eps` is 1e-5.

    Args:
        args, kwargs: of `PPO`.
        max_grad_norm: maximum norm of the gradient.
        group: this rank.
    """

    def __init__(self, *args: Any, max_grad_norm: float, group: Group, **kwargs: Any) -> None:
        super().__init__(*args, max_grad_norm=math.inf, **kwargs)
        for entry in self.optimizer.param_groups:
            entry["eps"] = _ADAM_EPS
        average_before_steps(self.optimizer, self.parameters(), group, max_grad_norm)

    def parameters(self) -> list[torch.nn.Parameter]:
        """Parameters of both networks."""
        return [*self.actor.parameters(), *self.critic.parameters()]

    def process_env_step(
        self, obs: TensorDict, rewards: torch.Tensor, dones: torch.Tensor, extras: dict[str, Any]
    ) -> None:
        """Record a step; see `PPO`."""
        time_outs = extras[TIME_OUTS]
        if time_outs.any():
            final = self.critic(extras[FINAL]).detach().squeeze(-1)
            rewards = rewards + self.gamma * final * time_outs
        super().process_env_step(obs, rewards, dones, {})


def make_ppo(config: TrainConfig, env: WarpVecEnv, group: Group = ALONE) -> NativePPO:
    """PPO for a rank of a training, with fresh networks on the env's device, the same ones on all ranks.

    Args:
        config: settings of the training.
        env: the envs, of several ranks this one's share.
        group: this rank.
    """
    torch.manual_seed(config.seed)
    observations = env.get_observations()
    groups = {"actor": [OBSERVATION], "critic": [OBSERVATION, *([PRIVILEGED] if config.asymmetric_critic else [])]}
    gaussian = {
        "class_name": "GaussianDistribution",
        "init_std": math.exp(config.log_std_init),
        "std_type": "log",
    }
    activation = _ACTIVATIONS.get(config.activation, config.activation)
    common: dict[str, Any] = {"hidden_dims": config.hidden, "activation": activation}
    own: dict[str, Any] = {"distribution_cfg": gaussian, **common, **_mirror(config, env, False)}
    actor = Network(observations, groups, "actor", env.num_actions, **own)
    critic = Network(observations, groups, "critic", 1, **common, **_mirror(config, env, True))
    storage = RolloutStorage if group.ranks == 1 else functools.partial(SharedStorage, group)
    ppo = NativePPO(
        actor,
        critic,
        storage("rl", env.num_envs, config.n_steps, observations, [env.num_actions], env.device),
        num_learning_epochs=config.n_epochs,
        num_mini_batches=equal_batches(config),
        clip_param=config.clip_range,
        gamma=config.gamma,
        lam=config.gae_lambda,
        value_loss_coef=_VALUE_LOSS,
        entropy_coef=config.ent_coef,
        learning_rate=config.learning_rate,
        max_grad_norm=config.max_grad_norm,
        use_clipped_value_loss=False,
        schedule="fixed",
        normalize_advantage_per_mini_batch=group.ranks == 1,
        device=env.device,
        group=group,
    )
    if group.ranks > 1:
        group.broadcast(ppo.parameters())
    if group.rank:
        # Ranks explore with random numbers of their own.
        torch.manual_seed(config.seed + group.rank * env.num_envs)
    return ppo


def _mirror(config: TrainConfig, env: WarpVecEnv, critic: bool) -> dict[str, Any]:
    if not config.symmetric:
        return {}
    own = MirrorMap.of(env.task.control.layout)
    if not critic:
        outputs = {"output_order": own.action_order, "output_sign": own.action_sign}
        return {"order": own.observation_order, "sign": own.observation_sign, **outputs}
    maps = [own]
    if env.privileged_layout is not None:
        maps.append(MirrorMap.of(env.privileged_layout))
    starts = np.cumsum([0, *(len(part.observation_order) for part in maps[:-1])])
    return {
        "order": np.concatenate([start + part.observation_order for start, part in zip(starts, maps, strict=True)]),
        "sign": np.concatenate([part.observation_sign for part in maps]),
    }
