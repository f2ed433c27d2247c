"""The reader of a file, recognised by its content, not by its name."""

import os
import re
from collections.abc import Callable
from contextlib import ExitStack
from functools import partial
from typing import Final

from quadruped_env.errors import short
from quadruped_env.robot.description import description_problem
from quadruped_env.trajectory.formats import bag_reader, echo_text, mapped_csv, project_csv, storage
from quadruped_env.trajectory.formats.storage.records import ZSTD_MAGIC
from quadruped_env.trajectory.reading import Reading
from quadruped_env.trajectory.rows import Rows
from quadruped_env.utils.documents import check_regular

Reader = Callable[[Reading], Rows | None]

_FIX: Final = "name a file of joint states, or the directory of a bag"
_HEAD: Final = 65536
"""Bytes by which a format is recognised."""
_KNOWN: Final = (
    "known are the project's CSV, CSVs whose columns bear the joints' names, any CSV with a column map, ros2 topic "
    "echo (YAML and --csv), rosbag2 (MCAP and sqlite3) and ROS 1 bags"
)
_MAGICS: Final[dict[bytes, Reader]] = {
    b"\x89MCAP0": bag_reader.read,
    b"SQLite format 3\x00": bag_reader.read,
    b"#ROSBAG V2.0": bag_reader.read_ros1,
}
"""First bytes of a file -> its reader."""


def read(reading: Reading, stack: ExitStack) -> Rows | None:
    """Return the rows of a file or bag, not validated; None without a usable one.

    Args:
        reading: of the file.
        stack: when it closes, a decompressed copy of the file is removed.

    Raises:
        QuadrupedError: if there is no such file, its format is unknown, or it is damaged.
        MissingExtraError: if the format needs libraries that are not installed.
    """
    head = _head(reading)
    while head.startswith(ZSTD_MAGIC):
        reading.path = storage.decompressed(reading.path, stack, reading)
        head = _head(reading)
    reader = mapped_csv.read if reading.options.columns is not None else _reader(head, reading)
    return reader(reading)


def _head(reading: Reading) -> bytes:
    """Return the first bytes of a file, or b"" for a directory."""
    try:
        if os.path.isdir(reading.path):
            for path in reading.path.iterdir():
                if not path.is_dir():
                    check_regular(path, _FIX)
            return b""
        check_regular(reading.path, _FIX)
        with reading.path.open("rb") as file:
            head = file.read(_HEAD)
    except OSError as error:
        raise reading.error(None, f"cannot be read ({error.strerror}); name a file of joint states") from error
    if not head:
        raise reading.error(None, "the file is empty; record again")
    return head


def _reader(head: bytes, reading: Reading) -> Reader:
    """Return the reader for a file with these first bytes."""
    if reading.path.is_dir():
        if not storage.storage_files(reading.path):
            raise reading.error(None, "the directory is not a bag; expected metadata.yaml and .mcap or .db3 files")
        return bag_reader.read
    for magic, reader in _MAGICS.items():
        if head.startswith(magic):
            return reader
    if head.startswith(b"#ROSBAG"):
        version = short(head[:13].decode(errors="replace"))
        raise reading.error(None, f"a bag of an old version, {version}; convert it with rosbag migrate")
    return _text_reader(head, reading)


def _text_reader(head: bytes, reading: Reading) -> Reader:
    """Return the reader for text with these first bytes."""
    if problem := description_problem(head):
        raise reading.error(None, problem)
    try:
        # The last character may be cut in two.
        text = head.decode("utf-8-sig", errors="strict" if len(head) < _HEAD else "ignore")
    except UnicodeDecodeError as error:
        raise reading.error(None, f"not a text file ({error.reason}) nor a known bag; {_KNOWN}") from error
    lines = (line for line in text.splitlines() if line.strip(" -") and not line.startswith((echo_text.LOST, "\t")))
    line = next(lines, "")
    cells = line.split(",")
    if line.rstrip() in {"header:", "layout:"} or line.startswith(("header: {", "layout: {", "{header:")):
        return echo_text.read_yaml
    if re.match(r'\s*\{\s*"', line):
        raise reading.error(None, f"JSON is not read; record a bag (ros2 bag record /joint_states); {_KNOWN}")
    if len(cells) >= 7 and all(cell.lstrip("-").isdecimal() for cell in cells[:2]):
        return echo_text.read_csv
    columns = None
    if ";" in line or "." not in line or cells[0] != project_csv.STAMP_COLUMN:
        columns = mapped_csv.by_titles(line, text, reading)
    if columns is None and line.startswith(project_csv.STAMP_COLUMN):
        columns = project_csv.column_map(line, reading)
    if columns is not None:
        return partial(mapped_csv.read, columns=columns)
    if len(cells) > 1:
        raise reading.error(
            None,
            f"text that begins with {short(line)}; if it is a CSV of other columns, add a column map that names them "
            f"(--columns FILE); {_KNOWN}",
        )
    raise reading.error(None, f"text that begins with {short(line)} is not a recording of joint states; {_KNOWN}")
