"""File locks, by which processes of several machines share a directory. A lock ends with its process."""

import fcntl
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from quadruped_env.errors import QuadrupedError


@contextmanager
def file_lock(path: Path, wait: bool = True) -> Iterator[bool]:
    """Hold the lock on a file within the context; the file is made if it does not exist.

    Yields:
        True; without `wait`, False if another process has it.

    Raises:
        QuadrupedError: if the file system has no locks, or the file cannot be made.
    """
    try:
        path.parent.mkdir(exist_ok=True)
        opened = path.open("a", encoding="utf-8")
    except OSError as error:
        raise QuadrupedError(f"{path}: cannot be written ({error.strerror}); make room, or allow it") from error
    with opened as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
            held = True
        except BlockingIOError:
            held = False
        except OSError as error:
            raise _no_locks(path.parent, str(error)) from error
        yield held


def check_locks(directory: Path) -> None:
    """Check that the file system of a directory has locks, and that other machines see them.

    Raises:
        QuadrupedError: if it has none, or they hold on this machine alone; the message names the file system.
    """
    with file_lock(directory / "check"), file_lock(directory / "check", wait=False) as twice:
        if twice:
            raise _no_locks(directory, "two processes got the same lock")
    if any(option in file_system(directory) for option in ("nolock", "local_lock=all", "local_lock=flock")):
        raise _no_locks(directory, "other machines do not see its locks")


def file_system(path: Path) -> str:
    """Return the type of a path's file system, with NFS's mount options; 'unknown' if there is no list of mounts."""
    try:
        mounts = [line.split() for line in Path("/proc/self/mounts").read_text(encoding="utf-8").splitlines()]
    except OSError:
        return "unknown"
    above = {str(parent) for parent in (path.resolve(), *path.resolve().parents)}
    found = max((mount for mount in mounts if mount[1] in above), key=lambda mount: len(mount[1]))
    return f"{found[2]}, {found[3]}" if found[2].startswith("nfs") else found[2]


def _no_locks(path: Path, reason: str) -> QuadrupedError:
    """Return the error for a file system without locks."""
    return QuadrupedError(
        f"{path}: its file system ({file_system(path)}) has no file locks ({reason}), which the "
        f"workers of a sweep need; use a local disk, or NFS version 4 mounted with locks"
    )
