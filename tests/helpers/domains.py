"""DDS domains for tests: one per test, also where several test suites run on one machine."""

import contextlib
import fcntl
import random
import tempfile
from pathlib import Path

FIRST, LAST = 41, 100
"""Domains above those in common use, and below those whose ports Linux gives to any program (from 32768 on)."""


@contextlib.contextmanager
def claimed():
    """A domain that no other test uses now."""
    numbers = list(range(FIRST, LAST + 1))
    random.shuffle(numbers)
    for number in numbers:
        with (Path(tempfile.gettempdir()) / f"quadruped-test-domain-{number}.lock").open("w") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                continue
            yield number
            return
    raise RuntimeError("every domain for tests is taken")
