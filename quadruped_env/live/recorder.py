"""A bag that grows while messages come: their bytes as they came."""

import sqlite3
import time
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Self

from quadruped_env._python import program_command
from quadruped_env.errors import QuadrupedError
from quadruped_env.files import PART, put_in_place, unwritable
from quadruped_env.live.topics import Topic
from quadruped_env.trajectory.formats.bag_writer import BagOptions, check_target, connect, open_bag, save_progress

_SAVE_EVERY: Final = 500_000
"""Bytes of messages after which a killed recorder must not lose them"""


class Recorder:
    """A context that writes what it is given into a new bag; without a message there is none.

    The bag grows in a directory named `<path>.part`, and comes to its place when it is whole. What was written when the
    process is killed or the disk is full stays there; `--salvage` reads it back, but for the last MB at most.

    Args:
        path: of the bag, a directory.
        storage: `mcap` or `sqlite3`.

    Raises:
        QuadrupedError: if there is something at the path already, or an unfinished recording next to it.
    """

    def __init__(self, path: Path, storage: str = "mcap") -> None:
        check_target(path, overwrite=False)
        self.path = path
        self._part = path.with_name(path.name + PART) / path.name
        """The bag while it grows. Storage files are called as their bag is, so it has its name already."""
        if self._part.parent.exists():
            raise QuadrupedError(
                f"{self._part.parent}: holds a recording that was cut short; read it back "
                f"({program_command('convert', self._part, 'OUT', '--salvage')}) and remove it, or name another place"
            )
        self.count = 0
        """Messages"""
        self.size = 0
        """Bytes of messages"""
        self._options = BagOptions(storage)
        self._stack = ExitStack()
        self._writer: Any = None
        self._failed = False
        self._connections: dict[Topic, Any] = {}
        self._last = 0

    def write(self, topic: Topic, data: bytes) -> None:
        """Write a message, at the time of now: later than the one before, so that their order stays.

        Args:
            topic: whose it is; its quality of service is kept in the bag.
            data: CDR.

        Raises:
            QuadrupedError: if the bag cannot be written.
            MissingExtraError: if rosbags is not installed.
        """
        try:
            if self._writer is None:
                self._writer = self._stack.enter_context(open_bag(self._part, self._options))
            if topic not in self._connections:
                self._connections[topic] = connect(self._writer, topic.name, topic.type_name, topic.qos)
            self._last = max(time.time_ns(), self._last + 1)
            self._writer.write(self._connections[topic], self._last, data)
            if self.size // _SAVE_EVERY != (self.size + len(data)) // _SAVE_EVERY:
                save_progress(self._writer)
        except (OSError, sqlite3.Error) as error:
            self._failed = True
            raise self._unwritable(error) from error
        self.count += 1
        self.size += len(data)

    @property
    def topics(self) -> int:
        """How many have had a message."""
        return len(self._connections)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        try:
            # Whatever happened elsewhere, the bag is closed as a whole one: what came before is good.
            self._stack.close()
            if self._writer is not None and not self._failed:
                check_target(self.path, overwrite=False)
                put_in_place(self._part, self.path)
                self._part.parent.rmdir()
        except (OSError, sqlite3.Error) as failure:
            if not self._failed:
                raise self._unwritable(failure) from failure

    def _unwritable(self, error: Exception) -> QuadrupedError:
        if not self._part.exists():
            return unwritable(self.path, error)
        return QuadrupedError(
            f"{unwritable(self.path, error)}; what was recorded until then is kept in {self._part} (--salvage)"
        )
