"""A training for several ranks as plain values, which travel to other processes and machines."""

import json
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from quadruped_env.training.train_config import STRAIGHT_LEARNING_RATE, TrainConfig, equal_batches, on_gpu
from quadruped_env.utils.files import write_whole


@dataclass(frozen=True)
class Job:
    """Arguments of `quadruped_env.training.train.train`."""

    config: TrainConfig
    runs: Path
    command: str
    resume: Path | None = None
    task_file: Path | None = None

    def to_dict(self) -> dict[str, Any]:
        """The job as JSON has it."""
        paths = {
            name: None if path is None else str(path.resolve())
            for name, path in (("resume", self.resume), ("task_file", self.task_file))
        }
        return {"config": asdict(self.config), "runs": str(self.runs), "command": self.command, **paths}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> "Job":
        """The job of `to_dict`."""
        config = TrainConfig(**{**values["config"], "hidden": tuple(values["config"]["hidden"])})
        resume, task_file = (None if values[name] is None else Path(values[name]) for name in ("resume", "task_file"))
        return cls(config, Path(values["runs"]), values["command"], resume, task_file)

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
        straight = f", {STRAIGHT_LEARNING_RATE:g} times as high for the first {config.straight_steps:,} steps"
        return (
            f"{config.ranks} ranks of {config.num_envs // config.ranks} envs and {own} each; effective batch: {batch} "
            f"samples, {batch // config.ranks} per rank; {batches * config.n_epochs} gradient steps after every "
            f"{samples:,} steps; learning rate {config.learning_rate:g}, falling linearly to a tenth within {budget}"
            f"{straight if config.straight_steps else ''}"
        )


@dataclass(frozen=True)
class Process:
    """A rank on this machine, as its process finds it in a file."""

    job: Job
    rank: int
    threads: int
    store: str
    """File by which the ranks find each other"""
    report: Path
    """File for the result"""

    def to_dict(self) -> dict[str, Any]:
        """The rank as JSON has it."""
        own = {"rank": self.rank, "threads": self.threads, "store": self.store, "report": str(self.report)}
        return {"job": self.job.to_dict(), **own}


def read_process(path: Path) -> Process:
    """The rank of a file that has `Process.to_dict`."""
    values = json.loads(path.read_text())
    job, report = Job.from_dict(values.pop("job")), Path(values.pop("report"))
    return Process(job, report=report, **values)


@dataclass(frozen=True)
class Report:
    """Result of a rank."""

    fault: str
    """Empty after a training; `own`, `lost` (another rank) or `weights` after an error"""
    text: str
    """The run directory, or the error"""
    finished: bool = False
    """True if the whole budget was used"""

    def to_dict(self) -> dict[str, Any]:
        """The report as JSON has it."""
        return asdict(self)


def write_plain(path: Path, values: Mapping[str, Any]) -> None:
    """Write a file for `read_process`, completely or not at all."""
    # Not as a document of this package: a setting may be infinite.
    write_whole({path: json.dumps(values).encode()})


def cores() -> int:
    """Number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def threads_per_rank(ranks: int) -> int:
    """Threads for physics and updates of each of the ranks of one machine."""
    return max(1, cores() // ranks)
