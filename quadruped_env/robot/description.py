"""Recognition of robot descriptions in XML: a URDF, an MJCF, a xacro file or an SDF."""

import os
import re
from typing import Final

from quadruped_env.errors import QuadrupedError

HEAD: Final = 1 << 16
"""Bytes at the beginning of a file from which it is recognised."""
_KINDS: Final = {"robot": "a URDF", "mujoco": "an MJCF", "mujocoinclude": "an MJCF", "sdf": "an SDF"}
"""Root element -> kind of description."""
_ROOT: Final = re.compile(
    rb"(?:\xef\xbb\xbf)?\s*(?:<\?.*?\?>\s*|<!--.*?-->\s*)*<(robot|mujoco|mujocoinclude|sdf)\b([^>]*)>", re.DOTALL
)


def description_problem(content: bytes) -> str:
    """Return the kind of a robot's description in XML, and how it becomes a robot; nothing for other content."""
    root = _ROOT.match(content)
    if root is None:
        return ""
    kind = "a xacro file" if b"xmlns:xacro" in root[2] else _KINDS[root[1].decode()]
    if kind == "an SDF":
        return f"this is {kind} and cannot be imported; convert it to URDF or MJCF (docs/robots.md)"
    return (
        f"this is {kind}, not a Python file; 'mini-quadruped robot FILE' reads it and writes a Python file for --task "
        f"FILE or task_file=... (docs/robots.md)"
    )


def check_no_description(path: str | os.PathLike[str]) -> None:
    """Raise a QuadrupedError if a file is a robot's description in XML; one that cannot be read is not."""
    try:
        if not os.path.isfile(path):  # opening a named pipe would wait
            return
        with open(path, "rb") as file:
            problem = description_problem(file.read(HEAD))
    except OSError:
        return
    if problem:
        raise QuadrupedError(f"{os.fspath(path)}: {problem}")
