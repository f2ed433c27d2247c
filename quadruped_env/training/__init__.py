"""How it learns: Stable-Baselines3's PPO on the native vector environment, and the run that a training leaves."""

from quadruped_env.training.config import TrainConfig

__all__ = ["TrainConfig"]
