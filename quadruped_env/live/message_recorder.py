"""Records received messages into a bag, as the bytes that arrived."""

import sqlite3
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Final, Self

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.middleware.topics import Topic
from quadruped_env.trajectory.formats.bag_writer import check_target, connect, open_bag, save_progress
from quadruped_env.utils.files import PART, put_in_place, unwritable
from quadruped_env.utils.interpreter import program_command

_SAVE_EVERY: Final = 500_000
"""Message bytes after which the recording is saved, so that a killed recorder does not lose them."""


class Recorder:
    """Context manager that writes messages into a new bag; without a message no bag is created.

    The bag is written in a directory named `<path>.part` and moved to its place when it is complete. If the process is
    killed or the disk is full, it stays there;
    `--repair salvage` recovers all but at most the last MB.

    Args:
        path: the bag's directory.
        storage: `mcap` or `sqlite3`.

    Raises:
        QuadrupedError: if the path already exists, or there is an unfinished recording next to it.
    """

    def __init__(self, path: Path, storage: str = "mcap") -> None:
        check_target(path, overwrite=False)
        self.path = path
        self._part = path.with_name(path.name + PART) / path.name
        """The bag while it is written. It already has its final name, since storage files are named after it."""
        if self._part.parent.exists():
            raise QuadrupedError(
                f"{self._part.parent}: holds a recording that was cut short; read it back "
                f"({program_command('convert', self._part, 'OUT', '--repair', 'salvage')}) and remove it, or name "
                f"another place"
            )
        self.count = 0
        """Number of messages written."""
        self.size = 0
        """Size of the messages written, bytes."""
        self._storage = storage
        self._stack = ExitStack()
        self._writer: Any = None
        self._failed = False
        self._connections: dict[Topic, Any] = {}
        self._last = 0

    def write(self, topic: Topic, data: bytes) -> None:
        """Write a message with the current time, which is strictly increasing to preserve the order.

        Args:
            topic: the message's topic; its quality of service is stored in the bag.
            data: CDR bytes.

        Raises:
            QuadrupedError: if the bag cannot be written.
            MissingExtraError: if rosbags is not installed.
        """
        try:
            if self._writer is None:
                self._writer = self._stack.enter_context(open_bag(self._part, self._storage))
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
        """Number of topics with at least one message."""
        return len(self._connections)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        try:
            # Complete the bag even after an error elsewhere: the messages so far are valid.
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
            f"{unwritable(self.path, error)}; what was recorded until then is kept in {self._part} (--repair salvage)"
        )
