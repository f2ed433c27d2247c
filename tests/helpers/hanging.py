"""A timeout for readers that hang. It bounds a test; no test measures time with it."""

import signal
from contextlib import contextmanager

from waiting import SCALE

SECONDS = 20.0 * SCALE
"""Timeout for reading one file, s; a longer read counts as a hang."""


class HangError(BaseException):
    """Error of a read that hangs; a BaseException, so that no reader catches it."""


def _interrupt(*_):
    raise HangError(f"reading took over {SECONDS:g} s")


@contextmanager
def bounded(seconds=SECONDS):
    """Raise a HangError in a block that takes too long."""
    before = signal.signal(signal.SIGALRM, _interrupt)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
