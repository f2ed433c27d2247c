"""The run directory of a training: its settings, its progress, and the policy."""

import contextlib
import csv
import errno
import io
import json
import os
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, Final

from quadruped_env.control.task_file import kept_files
from quadruped_env.errors import QuadrupedError
from quadruped_env.policies.files import CHECKPOINTS
from quadruped_env.training.train_config import TrainConfig
from quadruped_env.utils.files import LATEST, unwritable, write_whole
from quadruped_env.utils.provenance import TaskFile, git_commit, machine, versions

CONFIG_FILE: Final = "config.json"
PROGRESS_FILE: Final = "progress.csv"
RESUME_FILE: Final = "sb3_model.zip"
"""File from which a training can go on"""
RESUMED_FROM: Final = "resumed_from"
"""Field of a resumed run's config and of its policy's card"""
PROGRESS_COLUMNS: Final = ("timesteps", "seconds", "return", "fall_rate", "forward_velocity_error", "yaw_rate_error")
"""First columns of progress.csv: environment steps and s, counted on from a resumed run; and since the row
before: reward of a whole episode at the present rate; falls in the time of a whole episode; velocity errors in m/s and
rad/s, root mean square, with the exploration's noise. Runs of earlier versions have these alone."""
TERM_COLUMN: Final = "reward_"
"""Prefix of the other columns, one per reward term: its mean, weighted, per second."""


class Run:
    """A run directory `<parent>/<time>-<name>/`, and `<parent>/latest` that points to it.

    Its files appear when they are whole, but for two that grow: progress.csv, by whole rows, and TensorBoard's.

    Args:
        parent: the directory of all runs.
        config: settings of the training.
        task: the whole config of its task.
        command: what the user typed.
        resumed_from: facts about the run that it goes on from, if there is one.
        curve: that run's rows of progress.csv.
        columns: further columns of progress.csv.
        task_file: the user's file of the task, if there is one; the run keeps it as data.

    Raises:
        QuadrupedError: if the directory cannot be made, or something else is in the place of `latest`.
    """

    def __init__(
        self,
        parent: Path,
        config: TrainConfig,
        task: dict[str, Any],
        command: str,
        resumed_from: Mapping[str, Any] | None = None,
        curve: Sequence[Mapping[str, Any]] = (),
        columns: Iterable[str] = (),
        task_file: TaskFile | None = None,
    ) -> None:
        check_latest(parent)
        self.facts = {"command": command, "git_commit": git_commit(), "versions": versions(), "machine": machine()}
        if resumed_from is not None:
            self.facts[RESUMED_FROM] = dict(resumed_from)
        document = {"training": asdict(config), "task": task, **self.facts}
        # Terms that only the resumed run had keep their columns.
        self._columns = tuple(dict.fromkeys([*PROGRESS_COLUMNS, *columns, *(curve[0] if curve else ())]))
        self.directory = new_directory(parent, config.name)
        kept = kept_files(task_file)
        self.kept = tuple(kept)
        header = dict(zip(self._columns, self._columns, strict=True))
        try:
            write_whole(
                {
                    **{self.directory / name: content for name, content in kept.items()},
                    self.directory / PROGRESS_FILE: "".join(map(self._line, (header, *curve))).encode(),
                    self.directory / CONFIG_FILE: (json.dumps(document, indent=2) + "\n").encode(),
                }
            )
        except QuadrupedError:
            with contextlib.suppress(OSError):
                self.directory.rmdir()
            raise
        self._progress = (self.directory / PROGRESS_FILE).open("ab", buffering=0)
        _point_latest(parent / LATEST, self.directory)

    def log(self, row: Mapping[str, float]) -> None:
        """Add a row to progress.csv.

        Raises:
            QuadrupedError: if it cannot be written; the rows before it stay.
        """
        line, end = self._line(row).encode(), self._progress.tell()
        try:
            if self._progress.write(line) != len(line):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        except OSError as error:
            self._progress.truncate(end)
            raise unwritable(self.directory / PROGRESS_FILE, error) from error

    def close(self) -> None:
        """Finish the files."""
        self._progress.close()

    def _line(self, row: Mapping[str, Any]) -> str:
        text = io.StringIO()
        csv.DictWriter(text, self._columns).writerow(row)
        return text.getvalue()


def check_latest(parent: Path) -> None:
    """Refuse a directory of runs in which something else has the name of the link to the newest one.

    Raises:
        QuadrupedError: if that is so.
    """
    link = parent / LATEST
    if os.path.lexists(link) and not link.is_symlink():
        raise QuadrupedError(
            f"{link} is not a symbolic link, and the name is reserved for the link to the newest run; "
            f"rename it, or name another place"
        )


def run_name(directory: Path) -> str:
    """Return the name of a run in messages: its directory, or `<run>/checkpoints/<checkpoint>`."""
    directory = directory.resolve()
    # A checkpoint's own name does not say whose it is.
    return "/".join(directory.parts[-3 if directory.parent.name == CHECKPOINTS else -1 :])


def new_directory(parent: Path, name: str) -> Path:
    """Make the directory `<parent>/<time>-<name>`, and return it.

    Raises:
        QuadrupedError: if it cannot be made.
    """
    name = f"{time.strftime('%Y%m%d-%H%M%S')}-{name}"
    # Two processes that start within one second must not share a directory.
    for suffix in ("", *(f"-{i}" for i in range(2, 1000))):
        directory = parent / f"{name}{suffix}"
        try:
            directory.mkdir(parents=True)
        except FileExistsError:
            continue
        except OSError as error:
            raise QuadrupedError(f"cannot create {directory} ({error.strerror}); name another place") from error
        return directory
    raise QuadrupedError(f"{parent / name}: exists a thousand times; clear {parent}")


def _point_latest(link: Path, directory: Path) -> None:
    temporary = link.with_name(f".{LATEST}-{os.getpid()}")
    try:
        temporary.unlink(missing_ok=True)
        temporary.symlink_to(directory.name)
        temporary.replace(link)
    except OSError as error:
        raise unwritable(link, error) from error
