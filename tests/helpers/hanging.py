"""A guard against readers that hang: no timing, only an end."""

import signal
from contextlib import contextmanager

from waiting import SCALE

SECONDS = 20.0 * SCALE
"""A file that takes longer than this to read hangs the reader."""


class HangError(BaseException):
    """No reader may catch this."""


def _interrupt(*_):
    raise HangError(f"reading took over {SECONDS:g} s")


@contextmanager
def bounded(seconds=SECONDS):
    """Ends what takes too long with a HangError."""
    before = signal.signal(signal.SIGALRM, _interrupt)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
