"""Where the programs put their results: never over an older one, unless asked."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from quadruped_env.errors import QuadrupedError
from quadruped_env.files import PART, write_whole


def free_path(path: Path) -> Path:
    """The path itself, or with the first number from 2 behind its name that is not taken, nor unfinished."""
    number = 1
    free = path
    while free.exists() or free.with_name(free.name + PART).exists():
        number += 1
        free = path.with_name(f"{path.stem}-{number}{path.suffix}")
    return free


def check_free(paths: Iterable[Path], overwrite: bool) -> None:
    """Raise a QuadrupedError if one of the files is there already, and is not to be overwritten."""
    for path in paths:
        if path.is_dir() or (path.exists() and not overwrite):
            raise QuadrupedError(f"{path}: exists already; name another place, or ask to overwrite it (--overwrite)")


def write_json(path: Path, document: dict[str, Any]) -> None:
    """Write a document in full or not at all, making the directories on the way.

    Raises:
        QuadrupedError: if it cannot be written.
    """
    write_whole({path: (json.dumps(document, indent=2, allow_nan=False) + "\n").encode()})
