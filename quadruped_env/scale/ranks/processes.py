"""Ranks as processes of this machine: started, watched, and ended together.

This process only watches. The ranks are sessions of their own, so that Ctrl-C reaches this process alone; they end
when it does, in whatever way. Nothing of this listens on a network: ranks meet in a file, and connect on loopback.
"""

import json
import os
import pickle
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

import quadruped_env
from quadruped_env.errors import QuadrupedError
from quadruped_env.policies.files import CHECKPOINTS
from quadruped_env.scale.ranks.job import Job, threads_per_rank
from quadruped_env.training.run_directory import check_latest
from quadruped_env.utils.files import LATEST
from quadruped_env.utils.interpreter import program_command
from quadruped_env.utils.program import Stopped, on_stop

_Ranks = Sequence[subprocess.Popen[bytes]]

_POLL: Final = 0.05
"""Interval between looks at the ranks, s."""


def train_in_processes(job: Job) -> tuple[Path, bool]:
    """Train with all ranks on this machine.

    Returns:
        See `quadruped_env.training.train.train`.

    Raises:
        QuadrupedError: if a rank fails; then all have ended, and what was saved before is kept.
    """
    check_latest(job.runs)
    link = job.runs / LATEST
    before = link.resolve()
    with TemporaryDirectory(prefix="mini-quadruped-ranks-") as folder:
        reports = [Path(folder) / f"rank-{rank}" for rank in range(job.config.ranks)]
        ranks: list[subprocess.Popen[bytes]] = []
        try:
            for rank, report in enumerate(reports):
                ranks.append(_start(job, rank, report))
            received: list[int] = []

            def forward(number: int) -> None:
                """The first signal asks rank 0 to stop and save, and the second one ends this process."""
                received.append(number)
                if len(received) > 1:
                    raise Stopped(number)
                ranks[0].send_signal(number)

            with on_stop(forward):
                failed = _wait(ranks)
        finally:
            for process in ranks:
                process.kill()
            for process in ranks:
                process.communicate()
        if failed is None:
            directory, finished = json.loads(reports[0].read_text(encoding="utf-8"))
            return Path(directory), finished
        if received:
            raise Stopped(received[0])
        error = (
            reports[failed].read_text(encoding="utf-8")
            if reports[failed].is_file()
            else _death(failed, ranks[failed].returncode)
        )
        raise QuadrupedError(f"{error}; {_advice(link, before)}")


def _start(job: Job, rank: int, report: Path) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "quadruped_env.scale.ranks.rank", str(report)]
    # A script of a checkout that is not installed finds the package by itself, and its ranks by this.
    paths = [os.environ.get("PYTHONPATH"), str(Path(quadruped_env.__file__).parents[1])]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    process = subprocess.Popen(command, stdin=subprocess.PIPE, start_new_session=True, env=environment)  # noqa: S603
    assert process.stdin is not None
    # The pipe stays open: its end tells a rank that this process has ended.
    process.stdin.write(pickle.dumps((job, rank, threads_per_rank(job.config.ranks), str(report.with_name("store")))))
    process.stdin.flush()
    return process


def _wait(ranks: _Ranks) -> int | None:
    """Wait until one of the ranks has failed, and return it, or until all have ended well."""
    while any(process.poll() is None for process in ranks):
        time.sleep(_POLL)
        if any(process.poll() for process in ranks):
            break
    return next((rank for rank, process in enumerate(ranks) if process.returncode), None)


def _death(rank: int, status: int) -> str:
    if status >= 0:
        return f"ranks: rank {rank} ended with status {status}; see its error above"
    name = signal.Signals(-status).name
    return f"ranks: rank {rank} was killed by {name}{' (by the system if memory ran out)' * (name == 'SIGKILL')}"


def _advice(link: Path, before: Path) -> str:
    """Where the run is, and how it goes on."""
    directory = link.resolve()
    if directory == before or not directory.is_dir():
        return "no run directory was written"
    checkpoints = directory / CHECKPOINTS
    if checkpoints.is_dir() and any(checkpoints.iterdir()):
        return f"continue from its last checkpoint: {program_command('train', '--resume', directory)}"
    return f"{directory} has no checkpoint yet; start again"
