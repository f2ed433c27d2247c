"""Stable-Baselines3's PPO with less work around the same arithmetic.

Acting takes one pass of the actor for each step of the envs; the values of a whole rollout and of the observations that
a time limit cut off are computed in one batch at its end, and the log probabilities follow from the noise. An update
shuffles and gathers tensors that exist once, computes its gradients without autograd, and brings its records back in
one piece.
"""

import math
from typing import Any

import numpy as np
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.buffers import RolloutBuffer
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.utils import explained_variance
from stable_baselines3.common.vec_env import VecEnv

from quadruped_env.training.exploration import ClockNoise
from quadruped_env.training.perceptron import FlatGradient, Perceptron
from quadruped_env.training.train_config import STRAIGHT_LEARNING_RATE

_LOG_ROOT_TAU = 0.5 * math.log(math.tau)


class FastPPO(PPO):
    """PPO of a Gaussian `ActorCritic` on a Box; settings and files are SB3's.

    Not supported: state-dependent exploration, a clip range of the value function, a limit of the KL divergence, and
    advantages that are not normalized.

    Args:
        args, kwargs: of `PPO`.
        clock_noise: largest share of the exploration that swings with the gait clock; see `ClockNoise`.
        straight_steps: number of time steps at the start with commands straight ahead only, and a higher learning rate.
    """

    # Of SB3, which leaves out their types.
    rollout_buffer: RolloutBuffer
    _last_obs: Any
    _last_episode_starts: Any
    clip_range: Any

    def __init__(self, *args: Any, clock_noise: float = 0.0, straight_steps: int = 0, **kwargs: Any) -> None:
        self.clock_noise = clock_noise
        self.straight_steps = straight_steps
        self._waves: ClockNoise | None = None
        self._straight = False
        super().__init__(*args, **kwargs)

    def _excluded_save_params(self) -> list[str]:
        return [*super()._excluded_save_params(), "_waves", "_actor", "_critic", "_gradient"]

    def _setup_model(self) -> None:
        super()._setup_model()
        policy = self.policy
        self._actor = Perceptron([*policy.mlp_extractor.policy_net, policy.action_net])
        self._critic = Perceptron([*policy.mlp_extractor.value_net, policy.value_net])
        self._gradient = FlatGradient(policy.parameters(), policy.tied)

    def _setup_learn(self, *args: Any, **kwargs: Any) -> Any:
        # Before the envs are reset, which draws their first commands.
        self._begin_stage()
        return super()._setup_learn(*args, **kwargs)

    def _begin_stage(self) -> None:
        """Choose the commands and the learning rate by the number of time steps so far."""
        self._straight = self.num_timesteps < self.straight_steps
        if self.straight_steps:
            self._task.straight_only = self._straight

    @property
    def _task(self) -> Any:
        return self.env.task

    def collect_rollouts(
        self, env: VecEnv, callback: BaseCallback, rollout_buffer: RolloutBuffer, n_rollout_steps: int
    ) -> bool:
        """Fill the buffer; False if the callback ended the training. See SB3."""
        assert self._last_obs is not None
        self.policy.set_training_mode(False)
        rollout_buffer.reset()
        callback.on_rollout_start()
        self._begin_stage()
        low, high = self.action_space.low, self.action_space.high
        with torch.inference_mode():
            noise = torch.randn(rollout_buffer.actions.shape)
            deviation = self.policy.log_std.exp()
            means = torch.empty_like(noise)
            cut_off: list[tuple[int, int]] = []
            last_observations = []
            for step in range(n_rollout_steps):
                observations = rollout_buffer.observations[step]
                observations[:] = self._last_obs
                actions = rollout_buffer.actions[step]
                means[step] = self.mean_action(torch.from_numpy(observations))
                if self._waves is not None:
                    self._waves.mix_into(noise[step], *self._clock())
                actions[:] = (means[step] + noise[step] * deviation).numpy()
                new_obs, rewards, dones, infos = env.step(np.clip(actions, low, high))
                self.num_timesteps += env.num_envs
                callback.update_locals(locals())
                if not callback.on_step():
                    return False
                self._update_info_buffer(infos, dones)
                for env_id in np.flatnonzero(dones):
                    if infos[env_id].get("TimeLimit.truncated", False):
                        cut_off.append((step, int(env_id)))
                        last_observations.append(infos[env_id]["terminal_observation"])
                rollout_buffer.rewards[step] = rewards
                rollout_buffer.episode_starts[step] = self._last_episode_starts
                self._last_obs, self._last_episode_starts = new_obs, dones
            rollout_buffer.pos, rollout_buffer.full = n_rollout_steps, True
            rollout_buffer.log_probs[:] = self._log_prob(noise).numpy()
            rollout_buffer.values[:] = self._values(rollout_buffer.observations)
            if cut_off:
                # A time limit ends an episode, not its return.
                where = tuple(np.transpose(cut_off))
                rollout_buffer.rewards[where] += self.gamma * self._values(np.stack(last_observations))
            last_values = torch.from_numpy(self._values(new_obs))
            if self.clock_noise:
                self._waves = self._waves or ClockNoise(self.clock_noise, *noise.shape[1:])
                self._waves.set_share(means, deviation)
        rollout_buffer.compute_returns_and_advantage(last_values=last_values, dones=dones)
        callback.update_locals(locals())
        callback.on_rollout_end()
        return True

    def _clock(self) -> tuple[torch.Tensor, torch.Tensor]:
        """Phases of the gait clocks (N,) in rad, and 1 where a motion is commanded, else 0, (N,)."""
        control = self._task.control
        return torch.from_numpy(control.phase).float(), torch.from_numpy(control.moving).float()

    def mean_action(self, observations: torch.Tensor) -> torch.Tensor:
        """Mean action (N, J) of observations (N, width)."""
        return self._actor(self.policy.mlp_extractor.seen_by_actor(observations))

    def _values(self, observations: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        """Values (...) of observations (..., width)."""
        seen = torch.from_numpy(observations.astype(np.float32, copy=False))
        return self._critic(seen.flatten(0, -2)).view(seen.shape[:-1]).numpy()

    def _log_prob(self, noise: torch.Tensor) -> torch.Tensor:
        """Log probability density (...) of actions whose noise (..., J) has this many standard deviations."""
        return -0.5 * (noise * noise).sum(-1) - (self.policy.log_std + _LOG_ROOT_TAU).sum()

    def train(self) -> None:
        """Update the policy from the buffer. See SB3."""
        self.policy.set_training_mode(True)
        self._update_learning_rate(self.policy.optimizer)
        if self._straight:
            for group in self.policy.optimizer.param_groups:
                group["lr"] *= STRAIGHT_LEARNING_RATE
        clip_range = self.clip_range(self._current_progress_remaining)
        buffer = self.rollout_buffer
        size = buffer.buffer_size * buffer.n_envs
        observations, actions = (
            torch.from_numpy(part).view(size, -1) for part in (buffer.observations, buffer.actions)
        )
        log_probs, advantages, returns = (
            torch.from_numpy(part).view(size) for part in (buffer.log_probs, buffer.advantages, buffer.returns)
        )
        self._gradient.attach()
        records = []
        with torch.no_grad():
            for _ in range(self.n_epochs):
                batches = torch.randperm(size).split(self.batch_size)
                normalized = self._normalized([advantages[batch] for batch in batches])
                for batch, advantage in zip(batches, normalized, strict=True):
                    samples = (observations.index_select(0, batch), actions.index_select(0, batch), log_probs[batch])
                    records.append(self._gradient_step(*samples, advantage, returns[batch], clip_range))
        self._n_updates += self.n_epochs
        names = ("policy_gradient_loss", "value_loss", "entropy_loss", "loss", "approx_kl", "clip_fraction")
        for name, value in zip(names, torch.stack(records).mean(0).tolist(), strict=True):
            self.logger.record(f"train/{name}", value)
        variance = explained_variance(buffer.values.flatten(), buffer.returns.flatten())
        self.logger.record("train/explained_variance", variance)
        self.logger.record("train/std", self.policy.log_std.exp().mean().item())
        self.logger.record("train/n_updates", self._n_updates, exclude="tensorboard")
        self.logger.record("train/clip_range", clip_range)

    def _normalized(self, batches: list[torch.Tensor]) -> list[torch.Tensor]:
        """Advantages of each batch of an epoch with mean 0 and standard deviation 1."""
        return [(batch - batch.mean()) / (batch.std() + 1e-8) for batch in batches]

    def _gradient_step(
        self,
        observations: torch.Tensor,
        actions: torch.Tensor,
        old_log_prob: torch.Tensor,
        advantages: torch.Tensor,
        returns: torch.Tensor,
        clip_range: float,
    ) -> torch.Tensor:
        """One step of the optimizer; the records of `train` (6,)."""
        policy, size = self.policy, len(observations)
        log_std, inverse = policy.log_std, (-policy.log_std).exp()
        noise = (actions - self.mean_action(observations)) * inverse
        log_ratio = self._log_prob(noise) - old_log_prob
        ratio = log_ratio.exp()
        gain, clipped = advantages * ratio, advantages * ratio.clamp(1.0 - clip_range, 1.0 + clip_range)
        policy_loss = -torch.min(gain, clipped).mean()
        # Of the loss by the log probability: none where the clipped gain is the smaller one.
        by_log_prob = (gain * (gain <= clipped)).div_(-size)
        self._actor.backward(by_log_prob[:, None] * noise * inverse)
        log_std.grad.copy_(by_log_prob @ (noise * noise - 1.0)).sub_(self.ent_coef)
        error = self._critic(observations).squeeze(-1) - returns
        value_loss = (error * error).mean()
        self._critic.backward(error[:, None] * (2.0 * self.vf_coef / size))
        entropy_loss = -(log_std + 0.5 + _LOG_ROOT_TAU).sum()
        self._gradient.project()
        self._limit_gradients()
        policy.optimizer.step()
        loss = policy_loss + self.ent_coef * entropy_loss + self.vf_coef * value_loss
        kl = (ratio - 1.0 - log_ratio).mean()
        clip_fraction = ((ratio - 1.0).abs() > clip_range).float().mean()
        return torch.stack([policy_loss, value_loss, entropy_loss, loss, kl, clip_fraction])

    def _limit_gradients(self) -> None:
        """Scale the gradients so that their norm is `max_grad_norm` or less."""
        self._gradient.limit(self.max_grad_norm)
