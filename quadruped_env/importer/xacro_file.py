"""Expansion of xacro files by the library `xacro`, in a process of its own with limits of time and memory."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Final
from xml.etree.ElementTree import Element

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.importer.files import Folders
from quadruped_env.importer.xml_tree import MAX_BYTES

_SECONDS: Final = 60.0
"""Time after which the expansion is ended: macros can call each other without an end."""


def is_xacro(root: Element) -> bool:
    """Return True if a file needs the library: a URDF that was written by it still declares its namespace."""
    return any(node.tag.startswith("xacro:") for node in root.iter()) or (
        "xmlns:xacro" in root.attrib
        and any("${" in value or "$(" in value for node in root.iter() for value in node.attrib.values())
    )


def expanded(path: Path, folders: Folders) -> bytes:
    """Return the URDF of a xacro file.

    Raises:
        MissingExtraError: if the library is not installed.
        QuadrupedError: if it cannot be expanded, needs a file outside the folders, or more than arithmetic.
    """
    request = {"file": str(path.resolve()), "given": [str(folder) for folder in folders.given]}
    command = [sys.executable, "-m", "quadruped_env.importer.xacro_process"]
    try:
        done = subprocess.run(  # noqa: S603  this package's own module
            command, input=json.dumps(request).encode(), capture_output=True, timeout=_SECONDS, check=False
        )
    except subprocess.TimeoutExpired as error:
        raise QuadrupedError(
            f"{path}: takes over {_SECONDS:.0f} s to expand; look for macros that call each other without an end"
        ) from error
    try:
        answer = json.loads(done.stdout)
    except ValueError as error:
        raise QuadrupedError(
            f"{path}: needs too much memory or time to expand; look for macros without an end"
        ) from error
    if answer.get("missing"):
        raise MissingExtraError("reading xacro files", "xacro")
    if "error" in answer:
        raise QuadrupedError(f"{path}: {answer['error']}")
    text = str(answer["urdf"]).encode()
    if len(text) > MAX_BYTES:
        raise QuadrupedError(f"{path}: expands to {len(text) / 1e6:.0f} MB; the maximum is {MAX_BYTES / 1e6:.0f} MB")
    return text
