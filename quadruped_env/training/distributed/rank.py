"""One rank of a training, and the process that runs it for `processes`."""

import sys
import warnings
from pathlib import Path
from types import ModuleType
from typing import Any

# First, because it sets a variable that torch reads when it is loaded.
from quadruped_env.training import ppo

# isort: split
import torch

from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning
from quadruped_env.program import end_with_parent
from quadruped_env.training.distributed.group import DifferentWeightsError, Group, RankLostError, on_this_machine
from quadruped_env.training.distributed.job import Job, Report, read_process, write_plain
from quadruped_env.training.distributed.model import DistributedPPO


def run_rank(job: Job, group: Group) -> tuple[Path, bool] | None:
    """Train as one of several ranks.

    Args:
        job: the training.
        group: this rank.

    Returns:
        On rank 0, which alone writes the run directory, the result of `train`; None on the others.

    Raises:
        QuadrupedError: as `train`.
        RankLostError: if another rank ended or does not answer.
        DifferentWeightsError: if the weights of the ranks differ after an update.
    """
    # Of updates of a training with Warp; on the CPU, `make_model` sets one.
    torch.set_num_threads(group.threads)
    trainer: ModuleType = ppo
    own: dict[str, Any] = {"group": group}
    if job.config.device == "cpu":
        own["kind"] = DistributedPPO.on(group)
    else:
        from quadruped_env.training import warp as trainer
    if group.rank == 0:
        print(job.description(group.threads), flush=True)
        result: tuple[Path, bool] = trainer.train(job.config, job.runs, job.command, job.resume, job.task_file, **own)
        return result
    trainer.follow(job.config, job.resume, job.task_file, **own)
    return None


def main() -> int:
    """Run the rank of the file that the first argument names, as `processes` starts it; the exit status."""
    end_with_parent()
    process = read_process(Path(sys.argv[1]))
    if process.rank:
        # Those of all ranks are the same.
        warnings.simplefilter("ignore", QuadrupedWarning)
    try:
        group = on_this_machine(process.store, process.rank, process.job.config.ranks, process.threads)
        result = run_rank(process.job, group)
        # Not after an error: NCCL would wait for the other ranks, which wait for this one.
        group.close()
    except (QuadrupedError, MissingExtraError) as error:
        fault = "lost" if isinstance(error, RankLostError) else "own"
        if isinstance(error, DifferentWeightsError):
            fault = "weights"
        write_plain(process.report, Report(fault, str(error)).to_dict())
        return 1
    if result is not None:
        directory, finished = result
        write_plain(process.report, Report("", str(directory), finished).to_dict())
    return 0


if __name__ == "__main__":
    sys.exit(main())
