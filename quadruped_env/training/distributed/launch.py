"""The ways to run a training: in this process, on several ranks of this machine, or as a rank of torchrun."""

from pathlib import Path

from quadruped_env.training.distributed import torchrun
from quadruped_env.training.distributed.job import Job


def launch(job: Job, here: torchrun.Place | None = None) -> tuple[Path, bool] | None:
    """Run a training.

    Args:
        job: the training.
        here: the place of this process among those of torchrun, if that started it.

    Returns:
        The run directory, and whether the whole budget was used; None on ranks of torchrun that write no directory.

    Raises:
        QuadrupedError: as `quadruped_env.training.ppo.train`, or if a rank fails.
        MissingExtraError: if the extra `train` is not installed.
    """
    if here is not None:
        return torchrun.train_here(job, here)
    if job.config.ranks > 1:
        from quadruped_env.training.distributed.processes import train_in_processes

        return train_in_processes(job)
    # Torch takes seconds to import.
    from quadruped_env.training import ppo

    return ppo.train(job.config, job.runs, job.command, job.resume, job.task_file)
