"""The log of CycloneDDS, which writes each line to standard error, however many there are."""

import contextlib
import ctypes
import os
import re
import sys
from collections.abc import Iterator
from functools import cache
from typing import Final

_STDERR: Final = "stderr" if sys.platform.startswith("linux") else "__stderrp"
"""Name of C's `stderr`, a pointer to a stream."""
_READ: Final = 65536
_HEAD: Final = re.compile(r"[\d.]+ \[[^\]]*\]\s*\w+: ")
"""Time, domain and thread."""


@cache
def _stream() -> tuple[int, int]:
    """A pipe for the log: its reading end, and a C stream on the other. Lines are lost while it is full."""
    reading, writing = os.pipe()
    for end in (reading, writing):
        os.set_blocking(end, False)
    libc = ctypes.CDLL(None)
    libc.fdopen.restype = ctypes.c_void_p
    return reading, libc.fdopen(writing, b"w")


@contextlib.contextmanager
def captured() -> Iterator[None]:
    """Keep the log of domains that are joined for the first time in this context, for `lines`.

    A domain takes C's `stderr` when it is joined; the library exports no function to choose another stream.
    """
    try:
        stderr = ctypes.c_void_p.in_dll(ctypes.CDLL(None), _STDERR)
    except ValueError:
        yield
        return
    before, stderr.value = stderr.value, _stream()[1]
    try:
        yield
    except BaseException:
        # They tell why the domain could not be joined.
        for line in lines():
            print(line, file=sys.stderr)
        raise
    finally:
        stderr.value = before


def lines() -> list[str]:
    """Lines logged since the last call, without time, domain and thread."""
    try:
        text = os.read(_stream()[0], _READ).decode(errors="replace")
    except BlockingIOError:
        return []
    return [_HEAD.sub("", line, count=1) for line in text.splitlines()]
