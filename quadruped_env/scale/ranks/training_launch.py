"""The ways to run a training: in this process, on ranks of this machine or of Ray, or as a rank of torchrun."""

from pathlib import Path
from typing import Final

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.scale.ranks import torchrun
from quadruped_env.scale.ranks.job import Job
from quadruped_env.training.train_config import on_gpu

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
        QuadrupedError: as `quadruped_env.training.train.train`, or if a rank fails.
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
        if on_gpu(job.config.device):
            raise QuadrupedError(
                f"--launcher: found ray with --device {job.config.device}; Ray's ranks share CPUs here: leave "
                f"--launcher out for the GPUs of this machine, or start the ranks with torchrun"
            )
        from quadruped_env.scale.ranks.ray_cluster import train_on_ray

        return train_on_ray(job, address)
    if job.config.ranks > 1 and on_gpu(job.config.device):
        _check_gpus(job.config.ranks if here is None else here.local_ranks)
    if here is not None:
        return torchrun.train_here(job, here)
    if job.config.ranks > 1:
        from quadruped_env.scale.ranks.processes import train_in_processes

        return train_in_processes(job)
    # Torch takes seconds to import.
    from quadruped_env.scale.ranks.rank import trainer

    result: tuple[Path, bool] = trainer(job.config.device).train(
        job.config, job.runs, job.command, job.resume, job.task_file
    )
    return result


def _check_gpus(ranks: int) -> None:
    """Check that each of the ranks on this machine has a GPU of its own."""
    try:
        import torch
    except ImportError as error:
        raise MissingExtraError("--device cuda", "gpu") from error
    found = torch.cuda.device_count()
    if found >= ranks:
        return
    fix = f"choose --ranks {found}" if found else "check that nvidia-smi shows them and that torch is the CUDA build"
    raise QuadrupedError(
        f"--ranks: found {ranks} ranks on this machine with --device cuda, each of which needs a GPU of its own, and "
        f"torch finds {found} GPU{'' if found == 1 else 's'}; {fix}, or try it with --device warp-cpu"
    )
