"""Ranks as processes of this machine: started, watched, and ended together.

This process only watches. The ranks are sessions of their own, so that Ctrl-C reaches this process alone; they end
when it does, in whatever way. Nothing of this listens on a network: ranks meet in a file, and connect on loopback.
"""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from types import FrameType
from typing import Any, Final

import quadruped_env
from quadruped_env.control.policy_files import CHECKPOINTS
from quadruped_env.errors import QuadrupedError
from quadruped_env.scale.ranks.job import Job, Process, Report, threads_per_rank, write_plain
from quadruped_env.training.run_directory import LATEST, check_latest
from quadruped_env.utils.interpreter import program_command

_POLL: Final = 0.05
"""Interval between looks at the ranks, s."""
_GRACE: Final = 5.0
"""Time that the other ranks have to report a cause, after one says that it lost another, s."""


@dataclass
class _Rank:
    """A rank's process, and where it reports."""

    index: int
    process: subprocess.Popen[bytes]
    report_file: Path

    def report(self) -> Report | None:
        """The report, if it wrote one."""
        return Report(**json.loads(self.report_file.read_text())) if self.report_file.is_file() else None

    def failed(self) -> bool:
        """True if it ended, and not with a trained policy."""
        return self.process.poll() not in (None, 0)

    def cause(self) -> str | None:
        """Error that this rank is the cause of; None if it only lost another one, or runs."""
        if not self.failed():
            return None
        report, status = self.report(), self.process.returncode
        if report is None:
            return f"ranks: rank {self.index} {_death(status)}"
        if report.fault == "lost":
            return None
        return report.text if report.fault == "weights" or self.index == 0 else f"rank {self.index}: {report.text}"


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
        ranks: list[_Rank] = []
        try:
            for index in range(job.config.ranks):
                ranks.append(_start(job, index, Path(folder)))
            with _forwarded_signals(ranks[0]) as interrupted:
                error = _wait(ranks)
        finally:
            _end(ranks)
        report = ranks[0].report()
    if interrupted() and (report is None or report.fault):
        raise KeyboardInterrupt
    if error is not None:
        raise QuadrupedError(f"{error}; {_advice(link, before)}")
    assert report is not None
    return Path(report.text), report.finished


def _start(job: Job, index: int, folder: Path) -> _Rank:
    file, report = folder / f"rank-{index}.json", folder / f"report-{index}.json"
    rank = Process(job, index, threads_per_rank(job.config.ranks), str(folder / "store"), report)
    write_plain(file, rank.to_dict())
    command = [sys.executable, "-m", "quadruped_env.scale.ranks.rank", str(file)]
    # A script of a checkout that is not installed finds the package by itself, and its ranks by this.
    paths = [os.environ.get("PYTHONPATH"), str(Path(quadruped_env.__file__).parents[1])]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    # The pipe is never written to: it tells a rank that this process has ended.
    process = subprocess.Popen(command, stdin=subprocess.PIPE, start_new_session=True, env=environment)  # noqa: S603
    return _Rank(index, process, report)


def _wait(ranks: Sequence[_Rank]) -> str | None:
    """Wait until all ranks have ended, or one has failed; the error then."""
    while not any(rank.failed() for rank in ranks):
        if all(rank.process.poll() is not None for rank in ranks):
            return None
        time.sleep(_POLL)
    # A rank that lost another may end before that one.
    deadline = time.monotonic() + _GRACE
    while True:
        causes = [cause for rank in ranks if (cause := rank.cause()) is not None]
        if causes:
            return causes[0]
        if time.monotonic() > deadline or all(rank.process.poll() is not None for rank in ranks):
            reports = [report for rank in ranks if (report := rank.report()) is not None and report.fault]
            return reports[0].text
        time.sleep(_POLL)


def _end(ranks: Sequence[_Rank]) -> None:
    for rank in ranks:
        rank.process.kill()
    for rank in ranks:
        rank.process.wait()
        if rank.process.stdin is not None:
            rank.process.stdin.close()


def _death(status: int) -> str:
    if status >= 0:
        return f"ended with status {status}; see its error above"
    name = signal.Signals(-status).name
    return f"was killed by {name}" + (" (by the system if memory ran out)" if name == "SIGKILL" else "")


def _advice(link: Path, before: Path) -> str:
    """Where the run is, and how it goes on."""
    directory = link.resolve()
    if directory == before or not directory.is_dir():
        return "no run directory was written"
    checkpoints = directory / CHECKPOINTS
    if checkpoints.is_dir() and any(checkpoints.iterdir()):
        return f"continue from its last checkpoint: {program_command('train', '--resume', directory)}"
    return f"{directory} has no checkpoint yet; start again"


@contextmanager
def _forwarded_signals(rank: _Rank) -> Iterator[Callable[[], bool]]:
    """Within it, the first Ctrl-C or SIGTERM asks a rank to stop and save, and the second one ends this process.

    Yields:
        A function that returns True if there was one.
    """
    received: list[int] = []

    def forward(number: int, frame: FrameType | None) -> None:
        received.append(number)
        if len(received) > 1:
            raise KeyboardInterrupt
        rank.process.send_signal(signal.SIGINT)

    previous: dict[int, Any] = {}
    try:
        for interrupt in (signal.SIGINT, signal.SIGTERM):
            previous[interrupt] = signal.signal(interrupt, forward)
    except ValueError:
        pass  # not in the main thread, where no signals arrive
    try:
        yield lambda: bool(received)
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)
