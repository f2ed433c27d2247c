"""sqlite3 bags that were cut off, damaged or never closed: the rows that SQLite itself can read.

A bag in WAL mode (rosbag2's storage preset `resilient`) that was never closed has its last messages in a file next to
it, `<name>-wal`; a transaction that was cut short has its journal there. SQLite applies both, on a copy. The tables are
defined by https://github.com/ros2/rosbag2: topics (id, name, type, ...) and messages (id, topic_id, timestamp, data).
"""

import os
import shutil
import sqlite3
import struct
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, closing, suppress
from itertools import takewhile
from pathlib import Path
from typing import Any, Final

from quadruped_env.trajectory.formats.storage.records import Message, Topic
from quadruped_env.trajectory.reading import Reading

_SIDECARS: Final = ("-wal", "-journal")
_Row = tuple[Any, ...]


def scan(path: Path, reading: Reading) -> Iterator[Topic | Message]:
    """Yield topics and messages in the order of the file."""
    with path.open("rb") as file:
        header = file.read(32)
    size = path.stat().st_size
    if len(header) < 32:
        reading.damage(f"{path.name}: cut off at byte {size}, within the header")
        return
    (page_size,), (pages,) = struct.unpack_from(">H", header, 16), struct.unpack_from(">I", header, 28)
    page_size = 65536 if page_size == 1 else page_size  # which does not fit the field
    if page_size < 512:
        reading.damage(f"{path.name}: byte 16: {page_size} is not a valid page size")
        return
    if size < pages * page_size and unapplied(path) is None:
        reading.damage(f"{path.name}: cut off at byte {size} of {pages * page_size}")
    if rest := unapplied(path):
        reading.note(f"{rest.name} holds changes that are not in {path.name} yet: both were read, on a copy")
    topics = {"name": str, "type": str, "serialization_format": str}
    for key, name, message_type, encoding in _rows(path, "topics", topics, page_size, reading):
        if name.startswith("/"):
            yield Topic(key, name, message_type, encoding)
    columns = {"topic_id": int, "timestamp": int, "data": bytes}
    for _, topic, time, data in _rows(path, "messages", columns, page_size, reading):
        yield Message(topic, time, data)


def unapplied(path: Path) -> Path | None:
    """Return the file with changes that are not in a database yet, since it was never closed; None without one."""
    files = (path.with_name(path.name + suffix) for suffix in _SIDECARS)
    return next((file for file in files if file.is_file() and file.stat().st_size), None)


def _rows(path: Path, table: str, types: Mapping[str, type], page_size: int, reading: Reading) -> Iterator[_Row]:
    """Yield the id and columns of each row of a table that can be read, where the columns have these types."""
    query = f"SELECT rowid, {', '.join(types)} FROM {table} NOT INDEXED"  # noqa: S608
    last, problem = 0, ""
    with ExitStack() as stack:
        cut_page = path.stat().st_size % page_size > 0
        on_copy = cut_page or unapplied(path) is not None
        database = _opened(_copy(path, page_size, stack), stack, "") if on_copy else _opened(path, stack)

        def is_whole(row: _Row) -> bool:
            # A damaged tree may lead to a page twice, or to one of another table.
            return row[0] > last and all(map(isinstance, row[1:], types.values()))

        try:
            for row in database.execute(f"{query} ORDER BY rowid"):
                if not is_whole(row):
                    problem = "rows of other types, or in another order"
                    break
                last = row[0]
                yield row
            else:
                return
        except sqlite3.Error as error:
            problem = str(error)
        reading.damage(f"{path.name}: {table} are damaged behind row {last}: {problem}")
        found: dict[int, _Row] = {}
        # From the end backwards, and then between, where each row is looked up by its id.
        with suppress(sqlite3.Error):
            for row in takewhile(is_whole, database.execute(f"{query} ORDER BY rowid DESC")):
                found[row[0]] = row
        for key in range(last + 1, min(found, default=0)):
            with suppress(sqlite3.Error):
                found.update(
                    (row[0], row) for row in database.execute(f"{query} WHERE rowid = ?", (key,)) if is_whole(row)
                )
        yield from (found[key] for key in sorted(found))
        if found and (missing := max(found) - last - len(found)):
            reading.damage(f"{path.name}: left out {missing} rows of {table} that cannot be read")


def _copy(path: Path, page_size: int, stack: ExitStack) -> Path:
    """Return a copy of a database and of the changes next to it, which is removed when the stack closes."""
    copy = Path(stack.enter_context(tempfile.TemporaryDirectory())) / "copy"
    for suffix in ("", *_SIDECARS):
        source = path.with_name(path.name + suffix)
        if source.is_file():
            shutil.copyfile(source, copy.with_name(copy.name + suffix))
    # What a file lacks of a page would be zeros for SQLite.
    os.truncate(copy, path.stat().st_size // page_size * page_size)
    return copy


def _opened(path: Path, stack: ExitStack, options: str = "?immutable=1") -> sqlite3.Connection:
    """Return a connection, closed with the stack; by default one that changes nothing."""
    database = sqlite3.connect(f"{path.absolute().as_uri()}{options}", uri=True, isolation_level=None)
    stack.enter_context(closing(database))
    database.text_factory = lambda text: text.decode(errors="replace")
    # Otherwise SQLite reads nothing of a file that is shorter than its header says.
    database.execute("PRAGMA writable_schema = ON")
    return database
