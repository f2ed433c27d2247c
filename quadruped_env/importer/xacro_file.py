"""Expansion of xacro files by the library `xacro`, in a process of its own with limits of time and memory."""

import importlib.util
import subprocess
import sys
from typing import Final

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.importer.files import Folders
from quadruped_env.importer.xml_tree import MAX_BYTES, Node

REFUSED: Final = 3
"""Exit status of the process when its output is the reason why a file cannot be expanded."""
_SECONDS: Final = 60.0
"""Time after which the expansion is ended: macros can call each other without an end."""


def is_xacro(root: Node) -> bool:
    """Return True if a file needs the library: a URDF that was written by it still declares its namespace."""
    return any(node.tag.startswith("xacro:") for node in root.iter()) or (
        "xmlns:xacro" in root.attributes
        and any("${" in value or "$(" in value for node in root.iter() for value in node.attributes.values())
    )


def expanded(folders: Folders) -> bytes:
    """Return the URDF of the xacro file to which the folders belong.

    Raises:
        MissingExtraError: if the library is not installed.
        QuadrupedError: if it cannot be expanded, needs a file outside the folders, or more than arithmetic.
    """
    if importlib.util.find_spec("xacro") is None:
        raise MissingExtraError("reading xacro files", "xacro")
    command = [sys.executable, "-m", "quadruped_env.importer.xacro_process", *map(str, (folders.file, *folders.given))]
    try:
        done = subprocess.run(command, capture_output=True, timeout=_SECONDS, check=False)  # noqa: S603  our own module
    except subprocess.TimeoutExpired as error:
        raise QuadrupedError(
            f"takes over {_SECONDS:.0f} s to expand; look for macros that call each other without an end"
        ) from error
    if done.returncode == REFUSED:
        raise QuadrupedError(f"xacro: {done.stdout.decode(errors='replace')}")
    if done.returncode:
        raise QuadrupedError("needs too much memory or time to expand; look for macros without an end")
    if len(done.stdout) > MAX_BYTES:
        raise QuadrupedError(f"expands to {len(done.stdout) / 1e6:.0f} MB; the maximum is {MAX_BYTES / 1e6:.0f} MB")
    return done.stdout
