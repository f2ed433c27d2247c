"""A training for several ranks as a value that travels to other processes and machines."""

import os
from dataclasses import dataclass
from pathlib import Path

from quadruped_env.training.train_config import TrainConfig, equal_batches, on_gpu


@dataclass(frozen=True)
class Job:
    """Arguments of `quadruped_env.training.train.train`."""

    config: TrainConfig
    runs: Path
    command: str
    resume: Path | None = None
    task_file: Path | None = None

    def description(self, threads: int) -> str:
        """Shares of the ranks in envs and batches, and the schedule of the learning rate."""
        config = self.config
        samples = config.num_envs * config.n_steps
        batch, batches = config.batch_size, -(-samples // config.batch_size)
        if config.device != "cpu":
            batches = equal_batches(config)
            batch = samples // config.ranks // batches * config.ranks
        own = "one GPU" if on_gpu(config.device) else f"{threads} threads"
        budget = f"{config.timesteps:,} steps" if config.seconds is None else f"{config.seconds:g} s"
        return (
            f"{config.ranks} ranks of {config.num_envs // config.ranks} envs and {own} each; effective batch: {batch} "
            f"samples, {batch // config.ranks} per rank; {batches * config.n_epochs} gradient steps after every "
            f"{samples:,} steps; learning rate {config.learning_rate:g}, falling linearly to a tenth within {budget}"
        )


def cores() -> int:
    """Number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def threads_per_rank(ranks: int) -> int:
    """Threads for physics and updates of each of the ranks of one machine."""
    return max(1, cores() // ranks)
