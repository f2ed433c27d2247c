"""A node as a program: its loop, log, and clean shutdown."""

import argparse
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from typing import Final, Self, TextIO

from quadruped_env.errors import escaped
from quadruped_env.live.middleware.dds import DOMAIN_VARIABLE, Network
from quadruped_env.live.middleware.names import Names
from quadruped_env.live.middleware.node import Node, Publisher
from quadruped_env.live.pace import Clock, Pace, request_realtime_priority
from quadruped_env.utils.program import on_stop

POLL_PERIOD: Final = 0.1
"""Maximum time between checks whether to end, s."""
STATUS_PERIOD: Final = 1.0
"""Time between checks of the ROS graph for problems, and between log lines about what a node waits for, s."""
_SAME_SIGNAL: Final = 0.5
"""Time within which repeated signals count as one Ctrl-C, s."""
_REMEMBERED: Final = 256
"""Number of lines that `say_once` remembers."""
_ARRIVING: Final = 0.05
"""Time for which the loop continues after the end, since acknowledged messages may still be in delivery, s."""

REFUSALS_PERIOD: Final = 1.0
"""Time between log lines for the same reason, s."""
MAX_REASONS: Final = 3
"""Maximum number of reasons logged per period; further reasons are only counted."""
_MAX_REASON: Final = 300
"""Maximum length of a logged reason in characters, since a message may contain names of any length."""


def add_common_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments that all nodes share."""
    group = parser.add_argument_group("every node")
    group.add_argument(
        "--subnet",
        action="store_true",
        help="communicate with other machines of the subnet; without it, with this machine only. The DDS domain is "
        f"{DOMAIN_VARIABLE}, or 0",
    )
    group.add_argument(
        "--namespace",
        metavar="NS",
        help="namespace of the node and its topics, except /tf, /tf_static, /clock and /diagnostics",
    )
    group.add_argument(
        "--remap",
        action="append",
        default=[],
        metavar="FROM:=TO",
        help="use another topic",
    )


def add_realtime_argument(parser: argparse.ArgumentParser) -> None:
    """Add the argument of nodes with real-time deadlines."""
    parser.add_argument(
        "--realtime", action="store_true", help="run with real-time priority (SCHED_FIFO), if the system permits it"
    )


class Refusals:
    """Counts refused messages by reason, and writes them to the log.

    The first message of a reason is logged at once, and later ones once per second, with their number. Memory use is
    bounded, whatever the messages contain.

    Args:
        say: writes one line to the log.
        clock: a monotonic clock such as `time.monotonic`.
    """

    def __init__(self, say: Callable[[str], None], clock: Clock = time.monotonic) -> None:
        self._say = say
        self._clock = clock
        self._counts: dict[str, int] = {}
        """Reason -> number of messages not logged yet."""
        self._since = clock()
        self.count = 0
        """Number of messages refused."""

    def __call__(self, reason: str) -> None:
        """Count a refused message, and log it if its reason is new."""
        self.report()
        self.count += 1
        reason = escaped(reason if len(reason) <= _MAX_REASON else f"{reason[:_MAX_REASON]}...")
        if not self._counts:
            self._since = self._clock()
        if reason not in self._counts and len(self._counts) >= MAX_REASONS:
            reason = "for other reasons"
        if reason in self._counts:
            self._counts[reason] += 1
        else:
            self._counts[reason] = 0
            self._say(f"refused: {reason}")

    def report(self, last: bool = False) -> None:
        """Log the counts if the period is over, or if `last`. Call this often."""
        elapsed = self._clock() - self._since
        if not self._counts or (elapsed < REFUSALS_PERIOD and not last):
            return
        for reason, count in self._counts.items():
            if count:
                self._say(f"refused: {reason} ({count} message{'s' * (count > 1)} in {elapsed:.1f} s)")
        # A reason that did not occur in this period counts as new when it occurs again.
        self._counts = {reason: 0 for reason, count in self._counts.items() if count}
        self._since = self._clock()


class Session:
    """A running node: a context manager with a loop (`turns`) that ends with Ctrl-C, after a time, or by `stop`.

    Args:
        name: the node's name.
        arguments: parsed arguments, including `add_common_arguments`, and perhaps `realtime` and `seconds`.
        log: text stream for the log; by default standard error.

    Raises:
        QuadrupedError: as `Node`.
    """

    def __init__(self, name: str, arguments: argparse.Namespace, log: TextIO | None = None) -> None:
        # Before DDS starts its threads, so that they inherit the priority.
        refusal = request_realtime_priority() if getattr(arguments, "realtime", False) else ""
        names = Names.of(name, arguments.namespace, tuple(arguments.remap))
        self.node = Node(name, Network.from_environment(arguments.subnet), names)
        self.every_turn: list[Callable[[], object]] = []
        """Called at every turn of the loop, before the node's own work."""
        self.refuse = Refusals(self.say)
        """Counts a refused message, and logs the reason once per second."""
        self._log = log or sys.stderr
        self._stopped_at: float | None = None
        self._start = time.monotonic()
        seconds = getattr(arguments, "seconds", None)
        self._end = None if seconds is None else self._start + seconds
        self._waiting_for = ""
        self._waiting_since = self._waiting_logged = self._start
        self._said: deque[str] = deque(maxlen=_REMEMBERED)
        self._pace = Pace(STATUS_PERIOD)
        self._ends_with = ExitStack()
        if refusal:
            self.say(f"--realtime: {refusal}; continuing with normal priority")

    def __enter__(self) -> Self:
        self._ends_with.enter_context(on_stop(self._interrupted))
        self.say(f"on {self.node.network}")
        return self

    def __exit__(self, kind: type[BaseException] | None, *error: object) -> None:
        self._ends_with.close()
        self.refuse.report(last=True)
        if kind is None:
            counts = [
                f"{one.count} {'on' if isinstance(one, Publisher) else 'from'} {one.topic.name}"
                for one in self.node.ends
                if one.count
            ]
            messages = f"; messages: {', '.join(counts)}" if counts else ""
            missing = f"; waited for {self._waiting_for}" if self._waiting_for else ""
            self.say(f"ended after {self.elapsed:.1f} s{messages}{missing}")
        self.node.close()

    @property
    def running(self) -> bool:
        """True until the session has to end."""
        return self._stopped_at is None and (self._end is None or time.monotonic() < self._end)

    @property
    def elapsed(self) -> float:
        """Time since the start, s."""
        return time.monotonic() - self._start

    def stop(self) -> None:
        """Request the node to end at its next turn."""
        self._stopped_at = self._stopped_at or time.monotonic()

    def wait(self, seconds: float = POLL_PERIOD) -> bool:
        """Wait for a message, for at most `seconds` and `POLL_PERIOD`. Returns True if a message is available."""
        return self.node.wait(min(seconds, POLL_PERIOD))

    def turns(self, remaining: Callable[[], float] = lambda: POLL_PERIOD, drain: bool = False) -> Iterator[None]:
        """Run the loop of every node: each turn waits for a message and calls `every_turn`; then the caller works.

        Args:
            remaining: returns the time after which a turn is due without a message, s; at most `POLL_PERIOD`.
            drain: True to continue for a moment after the end of the session, for nodes that only listen. Otherwise
                messages would be lost that were received, and acknowledged to their publisher, between the last turn
                and the signal. A node that commands ends at once.
        """
        while self.running:
            self.wait(remaining())
            yield from self._turn()
        end = time.monotonic() + _ARRIVING * drain
        while time.monotonic() < end:
            self.wait(end - time.monotonic())
            yield from self._turn()

    def _turn(self) -> Iterator[None]:
        for take in self.every_turn:
            take()
        yield
        self.report()

    def say(self, text: str) -> None:
        """Write a line to the log."""
        self._log.write(f"[{self.node.name}] {escaped(text)}\n")
        self._log.flush()

    def say_once(self, text: str) -> None:
        """Write a line to the log unless it is among the last lines written by this method."""
        if text not in self._said:
            self._said.append(text)
            self.say(text)

    def wait_for(self, what: str) -> None:
        """Log what the node waits for, once per second with the time.

        Args:
            what: description of what is missing; empty if nothing is.
        """
        now, before = time.monotonic(), self._waiting_for
        self._waiting_for = what
        if what and not before:
            self._waiting_since = self._waiting_logged = now
            self.say(f"waiting for {what}")
        elif before and not what:
            self.say(f"waited {now - self._waiting_since:.1f} s for {before}")
        elif what and now - self._waiting_logged >= STATUS_PERIOD:
            self._waiting_logged = now
            self.say(f"waiting for {what} ({now - self._waiting_since:.0f} s)")

    def report(self) -> None:
        """Log refused messages and problems of the ROS graph, if it is time."""
        self.refuse.report()
        if not self._pace.tick():
            return
        for problem in self.node.graph.problems():
            self.say_once(problem)

    def _interrupted(self, number: int) -> None:
        # A terminal and a launcher may both forward the same Ctrl-C; a later one means that the node hangs.
        if self._stopped_at is not None and time.monotonic() - self._stopped_at > _SAME_SIGNAL:
            raise KeyboardInterrupt
        self.stop()
