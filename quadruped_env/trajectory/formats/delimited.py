"""Text files, line by line: what the readers of all text formats share."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TextIO

from quadruped_env.errors import short
from quadruped_env.trajectory.reading import Reading
from quadruped_env.utils.documents import check_regular


@contextmanager
def opened(reading: Reading) -> Iterator[TextIO]:
    """Provide the file, opened as text; errors of the system and the encoding become this package's."""
    check_regular(reading.path, "name a file of joint states")
    try:
        # Spreadsheets put a byte-order mark in front of UTF-8.
        with reading.path.open(encoding="utf-8-sig") as file:
            yield file
    except UnicodeDecodeError as error:
        raise reading.error(None, f"not a text file ({error.reason}); expected text of joint states") from error
    except OSError as error:
        raise reading.error(None, f"cannot be read ({error.strerror}); name a file of joint states") from error


def lines(file: TextIO, reading: Reading) -> Iterator[str]:
    """Yield the lines of a file, with progress, each with a line end.

    A last line without one gets it, and a remark, since its last number may be cut off.
    """
    size = max(os.fstat(file.fileno()).st_size, 1)
    done = 0
    for number, line in enumerate(file, 1):
        if not line.endswith("\n"):
            last = short(line.rpartition(",")[2].strip())
            reading.note(f"line {number}: the last line does not end, so its last value, {last}, may be cut off")
            line += "\n"  # noqa: PLW2901
        done += len(line)
        if number % 1000 == 0:
            reading.report_progress(done / size)
        yield line


def parse_number(text: str) -> float:
    """Return a number.

    Python's own parser accepts underscores and digits of other scripts, which are damage in a file of numbers.

    Raises:
        ValueError: if the text is not such a number.
    """
    if "_" in text or not text.isascii():
        raise ValueError(text)
    return float(text)


def is_number(text: str) -> bool:
    """Return True if `parse_number` reads a text."""
    try:
        parse_number(text)
    except ValueError:
        return False
    return True
