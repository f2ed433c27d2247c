"""Recognition of robot descriptions in XML, which no importer reads: a URDF, an MJCF, a xacro file or an SDF."""

import codecs
import os
from typing import Any, Final
from xml.etree import ElementTree

from quadruped_env.errors import QuadrupedError

HEAD: Final = 1 << 16
"""Bytes at the beginning of a file from which it is recognised."""
_KINDS: Final = {"robot": "a URDF", "mujoco": "an MJCF", "mujocoinclude": "an MJCF", "sdf": "an SDF"}
"""Root element -> kind of description."""
_XACRO: Final = "xacro"


def description_problem(content: bytes) -> str:
    """Kind of a robot's description in XML, and how a robot is given; empty for other content, or its beginning."""
    text = content.removeprefix(codecs.BOM_UTF8).lstrip()
    if not text.startswith(b"<"):
        return ""
    parser: Any = ElementTree.XMLPullParser(["start-ns", "start"])  # whose events typeshed does not tell apart
    prefixes, kind = [], ""
    try:
        parser.feed(text)
        for event, value in parser.read_events():
            if event == "start":
                kind = _KINDS.get(value.tag, "")
                break
            prefixes.append(value[0])
    except (ElementTree.ParseError, LookupError, ValueError):  # the last two for encodings that it lacks
        return ""
    if not kind:
        return ""
    return (
        f"this is {'a xacro file' if _XACRO in prefixes else kind} and cannot be imported; give the robot as a "
        f"QuadrupedDesign or a Robot in a Python file, with --task FILE or task_file=... "
        f"(docs/robots.md)"
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
