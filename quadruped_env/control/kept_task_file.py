"""The copy of a user's task file that a run keeps as data: its path, its content, and what has changed since."""

import hashlib
import os
from pathlib import Path
from typing import Final

from quadruped_env.control.policy import CARD_FILE
from quadruped_env.control.task_file import KEPT_FILE, TASK_FILE, changed_definitions, recorded_file
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.utils.documents import check_regular, read_json
from quadruped_env.utils.provenance import TERRAIN_FILE, TaskFile

_MAX_KEPT_BYTES: Final = 1_000_000
"""Maximum size of a task file that is shown and compared: far larger than any written by hand."""


def kept_file(directory: Path) -> tuple[Path, TaskFile] | None:
    """The copy of the user's file that a run keeps, with the file's name and hash; None for a run without a file.

    Args:
        directory: of a policy, as `policy_directory` gives it.

    Raises:
        QuadrupedError: if a file is damaged, or the run keeps no copy.
    """
    document = read_json(directory / CARD_FILE, "the file is damaged, train again")
    task = document.get("config") if isinstance(document, dict) else None
    task = task if isinstance(task, dict) else {}
    file = recorded_file(task.get(TASK_FILE)) or recorded_file(task.get(TERRAIN_FILE), TERRAIN_FILE)
    if file is None:
        return None
    path = directory / KEPT_FILE
    if not os.path.exists(path):
        raise QuadrupedError(
            f"{path}: missing, so there is no copy of {short(file.name)} to trust; name the file with --task FILE"
        )
    check_regular(path, "name the file with --task FILE")
    return path, file


def kept_content(directory: Path, recorded: TaskFile) -> bytes | None:
    """Content of the copy that a run keeps of its task file; None without one, or if it is not as recorded."""
    path = directory / KEPT_FILE
    try:
        if not path.is_file() or path.stat().st_size > _MAX_KEPT_BYTES:
            return None
        content = path.read_bytes()
    except OSError:
        return None
    return content if hashlib.sha256(content).hexdigest() == recorded.sha256 else None


def code_changes(directory: Path, recorded: TaskFile, file: TaskFile) -> tuple[str, ...] | None:
    """Names whose code in a file differs from that in a run's copy; None if the run has no copy that can be compared.

    No code is executed.
    """
    if recorded.sha256 == file.sha256:
        return ()
    kept = kept_content(directory, recorded)
    return None if kept is None else changed_definitions(kept, file.content)
