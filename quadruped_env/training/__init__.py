"""Training: Stable-Baselines3's PPO on the native vector environment, and the run directory that it writes."""

from quadruped_env.training.train_config import TrainConfig

__all__ = ["TrainConfig"]
