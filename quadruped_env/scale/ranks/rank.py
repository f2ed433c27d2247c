"""One rank of a training, and the process that runs it for `processes`."""

import json
import pickle
import sys
import time
import warnings
from pathlib import Path
from typing import Final

# First, because it sets a variable that torch reads when it is loaded.
from quadruped_env.training import train

# isort: split
import torch

from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning
from quadruped_env.scale.ranks.job import Job
from quadruped_env.scale.ranks.torch_group import on_this_machine
from quadruped_env.training.group import ALONE, DifferentWeightsError, Group, RankLostError
from quadruped_env.utils.files import write_whole
from quadruped_env.utils.program import end_with_parent, outputs

_GRACE: Final = 5.0
"""Time that a rank that lost another one leaves that one to report the cause first, s."""


def run_rank(job: Job, group: Group) -> tuple[Path, bool] | None:
    """Train as one of several ranks.

    Args:
        job: the training.
        group: this rank; its connections are closed, but not after an error, when NCCL would wait for the other ranks,
            which wait for this one.

    Returns:
        On rank 0, which alone writes the run directory, the result of `train`; None on the others.

    Raises:
        QuadrupedError: as `train`.
        RankLostError: if another rank ended or does not answer.
        DifferentWeightsError: if the weights of the ranks differ after an update.
    """
    # Of updates of a training with Warp; on the CPU, `make_model` sets one.
    torch.set_num_threads(group.threads)
    result: tuple[Path, bool] | None = None
    if group.rank == 0:
        print(job.description(group.threads), flush=True)
        result = train_job(job, group)
    else:
        train.follow(job.config, job.resume, job.task_file, group, trainer_of(job.config.device))
    group.close()
    return result


def train_job(job: Job, group: Group = ALONE) -> tuple[Path, bool]:
    """The result of `train`, as rank 0 if the training has several."""
    return train.train(
        job.config,
        job.runs,
        job.command,
        job.resume,
        job.task_file,
        group,
        trainer=trainer_of(job.config.device),
    )


def trainer_of(device: str) -> train.Trainer:
    """The trainer for a device."""
    if device == "cpu":
        return train.ON_CPU
    from quadruped_env.scale.gpu.warp_training import ON_WARP

    return ON_WARP


def main() -> int:
    """Run the rank that `processes` has started; the exit status.

    Its standard input has the job, the rank, its threads and the file by which the ranks find each other. The result of
    `run_rank` as JSON, or the text of an error, goes into the file that the first argument names.
    """
    job, rank, threads, store = pickle.load(sys.stdin.buffer)  # noqa: S301
    report = Path(sys.argv[1])
    end_with_parent()
    if rank:
        # Those of all ranks are the same.
        warnings.simplefilter("ignore", QuadrupedWarning)
    try:
        with outputs():
            result = run_rank(job, on_this_machine(store, rank, job.config.ranks, threads))
    except (QuadrupedError, MissingExtraError) as error:
        if isinstance(error, RankLostError):
            time.sleep(_GRACE)
        of_all = rank == 0 or isinstance(error, DifferentWeightsError)
        write_whole({report: f"{'' if of_all else f'rank {rank}: '}{error}".encode()})
        return 1
    if result is not None:
        write_whole({report: json.dumps([str(result[0]), result[1]]).encode()})
    return 0


if __name__ == "__main__":
    sys.exit(main())
