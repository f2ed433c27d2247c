"""A node as a program: log, status line, and clean shutdown."""

import argparse
import shutil
import sys
import time
from collections.abc import Iterable, Iterator
from contextlib import ExitStack
from types import TracebackType
from typing import Any, Final, Self, TextIO

from quadruped_env.errors import escaped
from quadruped_env.live.middleware import dds_log
from quadruped_env.live.middleware.dds import DOMAIN_VARIABLE, Network
from quadruped_env.live.middleware.names import Names
from quadruped_env.live.middleware.node import Node, Publisher, Subscription
from quadruped_env.live.pace import Pace, Rate, request_realtime_priority
from quadruped_env.live.refusals import Refusals
from quadruped_env.utils.program import CLEAR_LINE, on_stop

POLL_PERIOD: Final = 0.1
"""Maximum time between checks whether to end, s."""
STATUS_PERIOD: Final = 1.0
"""Time between status lines on a terminal, s."""
STATUS_PERIOD_LOG: Final = 10.0
"""Time between status lines in a log file, s."""
PROBLEMS_PERIOD: Final = 1.0
"""Time between checks of the ROS graph for problems, s."""
WAITING_PERIOD: Final = 1.0
"""Time between log lines about what a node waits for, s."""
_SAME_SIGNAL: Final = 0.5
"""Time within which repeated signals count as one Ctrl-C, s."""
_ARRIVING: Final = 0.05
"""Time for which the loop continues after the end, since acknowledged messages may still be in delivery, s."""
_REMEMBERED: Final = 256
"""Number of lines that `say_once` remembers."""


def add_common_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments that all nodes share."""
    group = parser.add_argument_group("every node")
    group.add_argument("--domain-id", type=int, metavar="N", help=f"DDS domain ID, 0 to 232 ({DOMAIN_VARIABLE}, or 0)")
    group.add_argument(
        "--subnet",
        action="store_true",
        help="communicate with other machines of the subnet; without it, with this machine only",
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
        help="use another topic; __node:=NAME renames the node. ROS's form works too: --ros-args -r FROM:=TO "
        "-r __ns:=/NS -p use_sim_time:=true",
    )
    group.add_argument("--seconds", type=float, metavar="S", help="end after S seconds (default: with Ctrl-C)")
    group.add_argument("--quiet", action="store_true", help="no status line")


def add_realtime_argument(parser: argparse.ArgumentParser) -> None:
    """Add the argument of nodes with real-time deadlines."""
    parser.add_argument(
        "--realtime", action="store_true", help="run with real-time priority (SCHED_FIFO), if the system permits it"
    )


class Session:
    """A running node: a context manager that ends with Ctrl-C, after a time, or by `stop`.

    Args:
        name: the node's name.
        arguments: parsed arguments, including those of `add_common_arguments`.
        log: text stream for log and status line; by default standard error.

    Raises:
        MissingExtraError: if cyclonedds is not installed.
        QuadrupedError: if the domain cannot be joined.
    """

    def __init__(self, name: str, arguments: argparse.Namespace, log: TextIO | None = None) -> None:
        # Before DDS starts its threads, so that they inherit the priority.
        refusal = request_realtime_priority() if getattr(arguments, "realtime", False) else ""
        with dds_log.captured():
            names = Names.of(name, arguments.namespace, tuple(arguments.remap))
            self.node = Node(name, Network.from_environment(arguments.domain_id, arguments.subnet), names)
        self._log = log or sys.stderr
        self._quiet: bool = arguments.quiet
        self._stopped = False
        self._stopped_at = 0.0
        self._start = time.monotonic()
        self._end = None if arguments.seconds is None else self._start + arguments.seconds
        self._waiting_for = ""
        self._waiting_since = self._waiting_logged = self._start
        self._said: dict[str, None] = {}
        self.refuse = Refusals(self.say)
        """Counts a refused message, and logs the reason once a second"""
        self._dds_lines = Refusals(self.say, prefix="CycloneDDS")
        self._rates: dict[Any, Rate] = {}
        self._status_pace = Pace(STATUS_PERIOD if self._log.isatty() else STATUS_PERIOD_LOG)
        self._problems_pace = Pace(PROBLEMS_PERIOD)
        self._ends_with = ExitStack()
        self._status_pace.tick()
        if refusal:
            self.say(f"--realtime: {refusal}; continuing with normal priority")

    def __enter__(self) -> Self:
        self._ends_with.enter_context(on_stop(self._interrupted))
        self.say(f"on {self.node.network}")
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self._ends_with.close()
        self._take_dds_lines()
        for lines in (self.refuse, self._dds_lines):
            lines.report(last=True)
        if self._log.isatty():
            # Clear the status line before an error is printed.
            self._log.write(CLEAR_LINE)
        if kind is None:
            counts = [
                f"{one.count} {verb} {one.topic.name}"
                for ends, verb in ((self.node.publishers, "on"), (self.node.subscriptions, "from"))
                for one in ends
                if one.count
            ]
            messages = f"; messages: {', '.join(counts)}" if counts else ""
            missing = f"; waited for {self._waiting_for}" if self._waiting_for else ""
            self.say(f"ended after {self.elapsed:.1f} s{messages}{missing}")
        self.node.close()

    @property
    def running(self) -> bool:
        """True until the session has to end."""
        return not self._stopped and (self._end is None or time.monotonic() < self._end)

    @property
    def elapsed(self) -> float:
        """Time since the start, s."""
        return time.monotonic() - self._start

    def stop(self) -> None:
        """Request the node to end at its next check."""
        self._stopped = True

    def wait(self, seconds: float = POLL_PERIOD) -> bool:
        """Wait for a message, for at most `seconds` and `POLL_PERIOD`. Returns True if a message is available."""
        self._take_dds_lines()
        return self.node.wait(min(seconds, POLL_PERIOD))

    def turns(self, seconds: float = POLL_PERIOD) -> Iterator[None]:
        """Iterate over the turns of a node's loop. Each turn waits for a message; the caller then takes all messages.

        The turns continue for a moment after the end of the session. Otherwise messages would be lost that were
        received, and acknowledged to their publisher, between the last turn and the signal.

        Args:
            seconds: timeout for a message, at most `POLL_PERIOD`, s.
        """
        while self.running:
            self.wait(seconds)
            yield
        end = time.monotonic() + _ARRIVING
        while (remaining := end - time.monotonic()) > 0.0:
            self.wait(remaining)
            yield

    def say(self, text: str) -> None:
        """Write a line to the log."""
        self._write(f"[{self.node.name}] {escaped(text)}\n")

    def say_once(self, text: str) -> None:
        """Write a line to the log unless it is among the last lines written by this method."""
        if text not in self._said:
            if len(self._said) >= _REMEMBERED:
                del self._said[next(iter(self._said))]
            self._said[text] = None
            self.say(text)

    def wait_for(self, what: str) -> None:
        """Log what the node waits for, once per second with the time. On a terminal, the status line has the repeats.

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
        elif what and now - self._waiting_logged >= WAITING_PERIOD:
            self._waiting_logged = now
            if self._quiet or not self._log.isatty():
                self.say(self._waiting_text(now))

    def _waiting_text(self, now: float) -> str:
        return f"waiting for {self._waiting_for} ({now - self._waiting_since:.0f} s)"

    def report(self, *details: str) -> None:
        """Update the status line, and log problems of the ROS graph. Call this often; it limits its own rate."""
        self.refuse.report()
        self._take_dds_lines()
        if self._problems_pace.tick():
            for problem in self.node.graph.problems():
                self.say_once(problem)
        if self._status_pace.tick() and not self._quiet:
            self._write_status(self._ends(details))

    def _take_dds_lines(self) -> None:
        for line in dds_log.lines():
            self._dds_lines(line)
        self._dds_lines.report()

    def _ends(self, details: Iterable[str]) -> str:
        parts = [f"{self.elapsed:.0f} s", *(detail for detail in details if detail)]
        ends: list[Publisher | Subscription[Any]] = [*self.node.publishers, *self.node.subscriptions]
        for one in ends:
            rate = self._rates.setdefault(one, Rate(since=self._start)).per_second(one.count)
            parts.append(_rate_text(one, rate))
        if self._waiting_for:
            parts.append(self._waiting_text(time.monotonic()))
        return " | ".join(parts)

    def _write_status(self, text: str) -> None:
        if not self._log.isatty():
            self.say(text)
            return
        # A line that wraps could not be cleared.
        width = shutil.get_terminal_size().columns - 1
        self._log.write(f"{CLEAR_LINE}{f'[{self.node.name}] {text}'[:width]}")
        self._log.flush()

    def _write(self, line: str) -> None:
        # Other nodes may share the terminal and have a status line on the current line.
        self._log.write(f"{CLEAR_LINE}{line}" if self._log.isatty() else line)
        self._log.flush()

    def _interrupted(self, number: int) -> None:
        now = time.monotonic()
        # A terminal and a launcher may both forward the same Ctrl-C; a later one means that the node hangs.
        if self._stopped and now - self._stopped_at > _SAME_SIGNAL:
            raise KeyboardInterrupt
        if not self._stopped:
            self._stopped_at = now
            self.stop()


def _rate_text(one: Publisher | Subscription[Any], rate: float) -> str:
    if isinstance(one, Publisher):
        return f"{one.topic.name} {rate:.1f} Hz to {one.readers}"
    latency = one.latency
    late = "" if latency is None else f", {1e3 * latency:.1f} ms old"
    return f"{one.topic.name} {rate:.1f} Hz{late}"
