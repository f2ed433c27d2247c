"""A bag that grows while messages come: their bytes as they came."""

import time
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.topics import Topic
from quadruped_env.trajectory.bag_writer import BagOptions, check_target, connect, open_bag


class Recorder:
    """A context that writes what it is given into a new bag; without a message there is none.

    What was written when the process is killed can be read back with `--salvage`, but for the last MB at most.

    Args:
        path: of the bag, a directory.
        storage: `mcap` or `sqlite3`.

    Raises:
        QuadrupedError: if there is something at the path already.
    """

    def __init__(self, path: Path, storage: str = "mcap") -> None:
        check_target(path, overwrite=False)
        self.path = path
        self.count = 0
        """Messages"""
        self.size = 0
        """Bytes of messages"""
        self._options = BagOptions(storage)
        self._stack = ExitStack()
        self._writer: Any = None
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
                self._writer = self._stack.enter_context(open_bag(self.path, self._options))
            if topic not in self._connections:
                self._connections[topic] = connect(self._writer, topic.name, topic.type_name, topic.qos)
            self._last = max(time.time_ns(), self._last + 1)
            self._writer.write(self._connections[topic], self._last, data)
        except OSError as error:
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
            # Whatever happened, the bag is closed as a whole one: what came before is good.
            self._stack.close()
        except OSError as failure:
            raise self._unwritable(failure) from failure

    def _unwritable(self, error: OSError) -> QuadrupedError:
        return QuadrupedError(f"{self.path}: cannot be written ({error.strerror}); make room, or name another place")
