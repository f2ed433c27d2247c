"""A training on the device that its settings name."""

from pathlib import Path

from quadruped_env.training.config import TrainConfig


def train(
    config: TrainConfig, runs: Path, command: str, resume: Path | None = None, task_file: Path | None = None
) -> tuple[Path, bool]:
    """Train a policy and leave a run directory; see `quadruped_env.training.ppo.train`.

    Raises:
        MissingExtraError: if the extra of the device is not installed.
        QuadrupedError: as `quadruped_env.training.ppo.train`, or if the device is not usable.
    """
    if config.device == "cpu":
        from quadruped_env.training.ppo import train as train_there
    else:
        from quadruped_env.training.warp import train as train_there
    return train_there(config, runs, command, resume, task_file)
