"""Writing of files and directories that appear under their name only when they are complete.

They are written in a hidden directory next to their place, `.<name>.<random>.part`, flushed to the disk, and renamed. A
full disk or an error leaves what was there before; so does a kill, which also leaves the hidden directory behind.
"""

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

from quadruped_env.errors import QuadrupedError

PART: Final = ".part"
"""Suffix of incomplete files and directories."""

LATEST: Final = "latest"
"""Link to the newest run, next to it."""
_NAME_SHOWN: Final = 50
"""Characters of a name that its hidden directory's name has: names have at most 255 bytes."""


@contextmanager
def whole(path: Path) -> Iterator[Path]:
    """Yield a path to create a file or a directory at, which becomes `path` when the context ends without an error.

    It has the last name of `path`, lies on the same file system and does not exist yet. Missing parents of `path` are
    made. A file replaces a file in one step; a directory replaces whatever is at `path`. A symbolic link stays, and
    what it points to is replaced.

    Raises:
        QuadrupedError: if the system refuses to write, also within the context.
    """
    try:
        target = Path(os.path.realpath(path))
        path.parent.mkdir(parents=True, exist_ok=True)
        prefix = f".{target.name[:_NAME_SHOWN]}."
        with TemporaryDirectory(PART, prefix, target.parent, ignore_cleanup_errors=True) as directory:
            part = Path(directory) / (target.name or "root")
            yield part
            put_in_place(part, target)
    except OSError as error:
        raise unwritable(path, error) from error


def write_whole(files: Mapping[Path, bytes]) -> None:
    """Write files that belong together: all of them are on the disk before the first appears, in the given order.

    Raises:
        QuadrupedError: if one of them cannot be written; then none of them appears.
    """
    with ExitStack() as stack:
        # A stack ends its contexts in reverse, and their ends make the files appear.
        for path, content in reversed(list(files.items())):
            part = stack.enter_context(whole(path))
            part.write_bytes(content)
            _flush(part)


def write_json(path: Path, document: dict[str, Any]) -> None:
    """Write a JSON document completely or not at all; missing parent directories are created.

    Raises:
        QuadrupedError: if it cannot be written.
    """
    write_whole({path: (json.dumps(document, indent=2, allow_nan=False) + "\n").encode()})


def free_path(path: Path) -> Path:
    """Return the path itself, or the first of `<name>-2`, `<name>-3`, ... that neither exists nor is being written."""
    number = 1
    free = path
    while free.exists() or free.with_name(free.name + PART).exists():
        number += 1
        free = path.with_name(f"{path.stem}-{number}{path.suffix}")
    return free


def check_free(paths: Iterable[Path], overwrite: bool) -> None:
    """Refuse to overwrite files.

    Raises:
        QuadrupedError: if one of the paths is a directory, or exists and `overwrite` is false.
    """
    for path in paths:
        if path.is_dir() or (path.exists() and not overwrite):
            raise QuadrupedError(f"{path}: exists already; name another place, or ask to overwrite it (--overwrite)")


def shown_path(path: Path) -> str:
    """Return a path without the directories of this machine, to show to others.

    Relative to the working directory; of a path that lies elsewhere, its name and its directory's name.
    """
    if not path.is_absolute():
        return str(path)
    try:
        return str(path.relative_to(Path.cwd()))
    except ValueError:
        # The root and a user's home below it are not shown.
        return "/".join(path.parts[-2:]) if len(path.parts) > 4 else path.name


def shown_argument(text: str, names_only: bool = False) -> str:
    """Return an argument of a command line, without the directories of this machine, as it is recorded.

    An absolute path is shown relative to the working directory; one that lies elsewhere, by its name.

    Args:
        text: a path, `--option=PATH`, or anything else, which stays.
        names_only: True to show relative paths by their names, too.
    """
    option, equals, value = text.partition("=") if text.startswith("-") else ("", "", text)
    path = Path(value)
    if "://" in value or not (path.is_absolute() or names_only):
        return text
    below = not names_only and path.is_relative_to(Path.cwd())
    return f"{option}{equals}{path.relative_to(Path.cwd()) if below else path.name or value}"


def unwritable(path: Path, error: Exception) -> QuadrupedError:
    """Return the error for a path that the system, or SQLite, refuses to write."""
    reason = getattr(error, "strerror", None) or error
    return QuadrupedError(f"{path}: cannot be written ({reason}); make room, or name another place")


def _flush(path: Path) -> None:
    """Make the system write a file, or every file of a directory, to the disk."""
    files = (file for file in path.rglob("*") if file.is_file()) if path.is_dir() else (path,)
    for file in files:
        descriptor = os.open(file, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


def put_in_place(part: Path, target: Path) -> None:
    """Flush a file or directory to the disk and give it another name on the same file system.

    Raises:
        OSError: if the system refuses that; then what was at the target is still there.
    """
    _flush(part)
    if not part.is_dir():
        part.replace(target)
        return
    # A directory cannot replace one that holds files: the old one is moved away, and back if the new one cannot come.
    old = part.with_name(f".{part.name[:_NAME_SHOWN]}.old")
    if target.exists():
        target.rename(old)
    try:
        part.rename(target)
    except OSError:
        if old.exists():
            old.rename(target)
        raise
