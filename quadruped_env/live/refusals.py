"""Log of refused messages: each reason at most once per second, with a count."""

import time
from collections.abc import Callable
from typing import Final

from quadruped_env.errors import escaped
from quadruped_env.live.pace import Clock

PERIOD: Final = 1.0
"""Time between log lines for the same reason, s."""
MAX_REASONS: Final = 3
"""Maximum number of reasons logged per period; further reasons are only counted."""
_MAX_CHARACTERS: Final = 300
"""Maximum length of a logged reason in characters, since a message may contain names of any length."""


class Refusals:
    """Counts refused messages by reason, and writes them to the log.

    The first message of a reason is logged at once. Later ones are logged once per second, with their number.
    Memory use is bounded, whatever the messages contain.

    Args:
        say: writes one line to the log.
        clock: a monotonic clock such as `time.monotonic`.
    """

    def __init__(self, say: Callable[[str], None], clock: Clock = time.monotonic) -> None:
        self._say = say
        self._clock = clock
        self._counts: dict[str, int] = {}
        """Reason -> number of messages not logged yet."""
        self._others = 0
        """Number of messages with further reasons that have not been logged yet."""
        self._since = 0.0
        self.count = 0
        """Number of messages refused."""

    def __call__(self, reason: str) -> None:
        """Count a refused message, and log it if the period allows it."""
        self.report()
        self.count += 1
        reason = escaped(reason if len(reason) <= _MAX_CHARACTERS else f"{reason[:_MAX_CHARACTERS]}...")
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
        """Log the counts if the period is over. Call this often.

        Args:
            last: log them even if the period is not over.
        """
        elapsed = self._clock() - self._since
        if not self._counts or (elapsed < PERIOD and not last):
            return
        for reason, count in self._counts.items():
            if count:
                self._say(f"refused: {reason} ({_messages(count)} in {elapsed:.1f} s)")
        if self._others:
            self._say(f"refused: {_messages(self._others)} for other reasons in {elapsed:.1f} s")
        # A reason that did not occur in this period counts as new when it occurs again.
        self._counts = {reason: 0 for reason, count in self._counts.items() if count}
        self._others = 0
        self._since = self._clock()


def _messages(count: int) -> str:
    return "1 message" if count == 1 else f"{count} messages"
