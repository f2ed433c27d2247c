"""The share of a training's budget that is left, and what follows it: learning rate and exploration."""

import time
from typing import Final

from stable_baselines3.common.callbacks import BaseCallback

from quadruped_env.training.actor_critic import ActorCritic
from quadruped_env.training.train_config import TrainConfig

_FINAL_LEARNING_RATE: Final = 0.1
"""Share of the first learning rate that is left at the end."""
_BAND: Final = 2.0
"""Factor on the desired divergence, and its inverse, beyond which the learning rate changes."""
_ADAPTATION: Final = 1.5
"""Factor by which it changes in an update."""
_KL: Final = "train/approx_kl"
"""Name under which Stable-Baselines3 logs the divergence."""


class Schedule:
    """Share of a training's budget that is left, and the learning rate, which falls with it linearly to a tenth.

    With a desired divergence of the policies before and after an update the learning rate also falls where updates
    change the policy more, and rises again, as in Schulman et al. 2017 for the penalty, and in legged_gym.

    Stable-Baselines3 calls it with a share of its own, which knows neither a budget in seconds nor a resumed run.

    Args:
        config: settings of the training.
    """

    def __init__(self, config: TrainConfig) -> None:
        self._seconds, self._timesteps = config.seconds, config.timesteps
        self._learning_rate = config.learning_rate
        self._desired_kl, self._slowed = config.desired_kl, 1.0
        self._bounds = config.log_std_init, min(config.log_std_init, config.final_log_std)
        self.go_on(0, 1.0)

    def go_on(self, timesteps: int, left: float) -> None:
        """Take the place of a training that has used some time steps, with the share of its budget that is left."""
        self.left = self._left_at_start = left
        self.begin(timesteps)

    def begin(self, timesteps: int) -> None:
        """Begin to use the budget."""
        self._first, self._began = timesteps, time.perf_counter()

    def left_after(self, timesteps: int) -> float:
        """Share of the budget that is left now, after a number of time steps."""
        if self._seconds is not None:
            used = (time.perf_counter() - self._began) / self._seconds
        else:
            used = (timesteps - self._first) / self._timesteps
        return self._left_at_start * max(0.0, 1.0 - used)

    @property
    def log_std_bound(self) -> float:
        """Upper bound of the logarithm of the exploration's standard deviation."""
        first, final = self._bounds
        return final + (first - final) * self.left

    def __call__(self, progress_remaining: float = 0.0) -> float:
        """Return the learning rate."""
        return self._slowed * self._learning_rate * (_FINAL_LEARNING_RATE + (1.0 - _FINAL_LEARNING_RATE) * self.left)

    def adapt(self, kl: float) -> None:
        """Adapt the learning rate to the divergence by the latest update."""
        if self._desired_kl is not None and kl > _BAND * self._desired_kl:
            self._slowed /= _ADAPTATION
        elif self._desired_kl is not None and kl < self._desired_kl / _BAND:
            self._slowed = min(1.0, self._slowed * _ADAPTATION)


class Scheduled(BaseCallback):
    """Callback of every training of `make_model`: moves its schedule on, and applies it to the policy."""

    @property
    def schedule(self) -> Schedule:
        """The model's schedule."""
        return self.model.learning_rate

    def _on_training_start(self) -> None:
        self.schedule.begin(self.model.num_timesteps)

    def _on_rollout_start(self) -> None:
        policy = self.model.policy
        if _KL in self.logger.name_to_value:
            self.schedule.adapt(float(self.logger.name_to_value[_KL]))
        if hasattr(policy, "log_std"):
            policy.log_std.data.clamp_(max=self.schedule.log_std_bound)
        self._symmetrize()

    def _on_step(self) -> bool:
        return True

    def _on_rollout_end(self) -> None:
        self.schedule.left = self.schedule.left_after(self.model.num_timesteps)

    def _on_training_end(self) -> None:
        self._symmetrize()

    def _symmetrize(self) -> None:
        if isinstance(self.model.policy, ActorCritic):
            # Where the steps are not elementwise, rounding would add up to a difference between the sides.
            self.model.policy.project()
