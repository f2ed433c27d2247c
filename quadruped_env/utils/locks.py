"""Locks of files, by which processes of several machines share a directory. A lock ends with its process."""

import fcntl
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from quadruped_env.errors import QuadrupedError


@contextmanager
def file_lock(path: Path, wait: bool = True) -> Iterator[bool]:
    """Within it, this process has the lock of a file, which is made if it does not exist.

    Yields:
        True; without `wait`, False if another process has it.

    Raises:
        QuadrupedError: if the file system has no locks.
        OSError: if the file cannot be made.
    """
    path.parent.mkdir(exist_ok=True)
    with path.open("a", encoding="utf-8") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
            held = True
        except BlockingIOError:
            held = False
        except OSError as error:
            raise _no_locks(path.parent, str(error)) from error
        yield held


def check_locks(directory: Path) -> None:
    """Check that the file system of a directory has locks, and that they are not of this machine alone.

    Raises:
        QuadrupedError: if that is not so; the message names the file system.
    """
    with file_lock(directory / "check"), file_lock(directory / "check", wait=False) as twice:
        if twice:
            raise _no_locks(directory, "two have the same lock")
    if any(option in file_system(directory) for option in ("nolock", "local_lock=all", "local_lock=flock")):
        raise _no_locks(directory, "its locks are of one machine alone")


def file_system(path: Path) -> str:
    """Type of a path's file system, and of NFS its mount options; 'unknown' where the system does not tell."""
    try:
        mounts = [line.split() for line in Path("/proc/self/mounts").read_text(encoding="utf-8").splitlines()]
    except OSError:
        return "unknown"
    above = {str(parent) for parent in (path.resolve(), *path.resolve().parents)}
    found = max((mount for mount in mounts if mount[1] in above), key=lambda mount: len(mount[1]))
    return f"{found[2]}, {found[3]}" if found[2].startswith("nfs") else found[2]


def _no_locks(path: Path, reason: str) -> QuadrupedError:
    return QuadrupedError(
        f"{path}: its file system ({file_system(path)}) has no file locks ({reason}), by which processes share it; "
        f"take a local disk, or NFS of version 4 that is mounted with locks"
    )
