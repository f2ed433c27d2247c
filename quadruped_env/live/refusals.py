"""The log of refused messages: each reason once a second, with a count, however many messages come."""

import time
from collections.abc import Callable
from typing import Final

from quadruped_env.live.pace import Clock

PERIOD: Final = 1.0
"""s; a reason is logged once in that time"""
MAX_REASONS: Final = 3
"""Reasons that are logged in that time; further ones are only counted"""
_MAX_CHARACTERS: Final = 300
"""Characters of a reason: a message may hold names of any length"""


class Refusals:
    """Counts refused messages by reason, and writes them to the log.

    The first message of a reason is logged at once. Those that follow are logged once a second, with their number.
    What is kept is bounded, whatever the messages hold.

    Args:
        say: writes one line to the log.
        clock: of `time.monotonic`'s kind.
    """

    def __init__(self, say: Callable[[str], None], clock: Clock = time.monotonic) -> None:
        self._say = say
        self._clock = clock
        self._counts: dict[str, int] = {}
        """Reason -> messages that have not been logged"""
        self._others = 0
        """Messages of further reasons that have not been logged"""
        self._since = 0.0
        self.count = 0
        """Messages refused"""

    def __call__(self, reason: str) -> None:
        """Count a message that was refused, and log it if it is time for that."""
        self.report()
        self.count += 1
        reason = _line(reason)
        if not self._counts:
            self._since = self._clock()
        if reason in self._counts:
            self._counts[reason] += 1
        elif len(self._counts) < MAX_REASONS:
            self._counts[reason] = 0
            self._say(f"refused: {reason}")
        else:
            self._others += 1

    def report(self, last: bool = False) -> None:
        """Log what was counted, if it is time for that. To be called often.

        Args:
            last: log it even if the second is not over.
        """
        elapsed = self._clock() - self._since
        if not self._counts or (elapsed < PERIOD and not last):
            return
        for reason, count in self._counts.items():
            if count:
                self._say(f"refused: {reason} ({_messages(count)} in {elapsed:.1f} s)")
        if self._others:
            self._say(f"refused: {_messages(self._others)} for other reasons in {elapsed:.1f} s")
        # A reason that goes on is logged with its count; one that did not occur is new when it comes again.
        self._counts = {reason: 0 for reason, count in self._counts.items() if count}
        self._others = 0
        self._since = self._clock()


def _messages(count: int) -> str:
    return "1 message" if count == 1 else f"{count} messages"


def _line(text: str) -> str:
    """A text as a part of one line: what a terminal would obey is escaped, and what is too long is cut."""
    short = text if len(text) <= _MAX_CHARACTERS else f"{text[:_MAX_CHARACTERS]}..."
    return "".join(one if one.isprintable() else ascii(one)[1:-1] for one in short)
