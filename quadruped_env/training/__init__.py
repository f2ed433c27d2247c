"""How it learns: Stable-Baselines3's PPO on the native vector environment, and the run that a training leaves."""
