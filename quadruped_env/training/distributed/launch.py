"""The ways to run a training: in this process, on ranks of this machine or of Ray, or as a rank of torchrun."""

from pathlib import Path
from typing import Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.training.distributed import torchrun
from quadruped_env.training.distributed.job import Job

LAUNCHERS: Final = ("processes", "ray")
"""Values of `--launcher`."""


def launch(
    job: Job, here: torchrun.Place | None = None, launcher: str = LAUNCHERS[0], address: str | None = None
) -> tuple[Path, bool] | None:
    """Run a training.

    Args:
        job: the training.
        here: the place of this process among those of torchrun, if that started it.
        launcher: what starts several ranks, one of `LAUNCHERS`.
        address: running cluster for Ray.

    Returns:
        The run directory, and whether the whole budget was used; None on ranks of torchrun that write no directory.

    Raises:
        QuadrupedError: as `quadruped_env.training.ppo.train`, or if a rank fails.
        MissingExtraError: if the extra `train` is not installed, or for Ray the extra `sweep`.
    """
    if address is not None and launcher != "ray":
        raise QuadrupedError(f"--address: found {address}, which only Ray uses; add --launcher ray, or leave it out")
    if launcher == "ray":
        if here is not None:
            raise QuadrupedError(
                "--launcher: found ray in a process that torchrun started (WORLD_SIZE); use one of the two"
            )
        if job.config.ranks == 1:
            raise QuadrupedError("--launcher: found ray with one rank, which needs no launcher; give --ranks 2 or more")
        from quadruped_env.training.distributed.ray_cluster import train_on_ray

        return train_on_ray(job, address)
    if here is not None:
        return torchrun.train_here(job, here)
    if job.config.ranks > 1:
        from quadruped_env.training.distributed.processes import train_in_processes

        return train_in_processes(job)
    # Torch takes seconds to import.
    if job.config.device != "cpu":
        from quadruped_env.training.warp import train as train_on_gpu

        return train_on_gpu(job.config, job.runs, job.command, job.resume, job.task_file)
    from quadruped_env.training.ppo import train

    return train(job.config, job.runs, job.command, job.resume, job.task_file)
