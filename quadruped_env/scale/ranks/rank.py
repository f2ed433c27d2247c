"""One rank of a training, and the process that runs it for `processes`."""

import sys
import warnings
from pathlib import Path
from types import ModuleType

# First, because it sets a variable that torch reads when it is loaded.
from quadruped_env.training import train

# isort: split
import torch

from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning
from quadruped_env.scale.ranks.job import Job, Report, read_process, write_plain
from quadruped_env.scale.ranks.torch_group import on_this_machine
from quadruped_env.training.group import DifferentWeightsError, Group, RankLostError
from quadruped_env.utils.program import end_with_parent


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
    trainer = _trainer(job.config.device)
    if group.rank == 0:
        print(job.description(group.threads), flush=True)
        result: tuple[Path, bool] = trainer.train(job.config, job.runs, job.command, job.resume, job.task_file, group)
        return result
    trainer.follow(job.config, job.resume, job.task_file, group)
    return None


def _trainer(device: str) -> ModuleType:
    """The module that trains on a device."""
    if device == "cpu":
        return train
    from quadruped_env.scale.gpu import warp_training

    return warp_training


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
