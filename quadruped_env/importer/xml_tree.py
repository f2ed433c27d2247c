"""Reader of XML that names lines in errors, and expands no entities."""

from pathlib import Path
from typing import Final
from xml.etree.ElementTree import Element
from xml.parsers import expat

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.utils.documents import check_regular

MAX_BYTES: Final = 20_000_000
"""Maximum size of a description; the largest public ones have 1 MB."""
_MAX_DEPTH: Final = 200
FIX: Final = "name a URDF, a xacro file or an MJCF"


class Node(Element):
    """An element that knows its line."""

    line = 0


class _Builder:
    def __init__(self, source: str) -> None:
        self.parser = expat.ParserCreate()
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.EntityDeclHandler = self._entity
        self.parser.buffer_text = True
        self.open: list[Node] = []
        self.root: Node | None = None
        self._source = source

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        node = Node(tag, attributes)
        node.line = self.parser.CurrentLineNumber
        if len(self.open) >= _MAX_DEPTH:
            raise QuadrupedError(f"{self._source}, line {node.line}: elements are nested over {_MAX_DEPTH} deep; {FIX}")
        if self.open:
            self.open[-1].append(node)
        self.root = self.root if self.root is not None else node
        self.open.append(node)

    def _end(self, tag: str) -> None:
        self.open.pop()

    def _entity(self, name: str, *_: object) -> None:
        raise QuadrupedError(
            f"{self._source}, line {self.parser.CurrentLineNumber}: declares the entity {short(name)}, and entities "
            f"are not expanded, because a few of them can fill the memory; write its text where it is used"
        )


def read_bytes(path: Path, fix: str = FIX, limit: int = MAX_BYTES) -> bytes:
    """Return the content of a regular file of limited size.

    Raises:
        QuadrupedError: if it is missing, no regular file, too large, or cannot be read.
    """
    check_regular(path, fix)
    size = path.stat().st_size
    if size > limit:
        raise QuadrupedError(f"{path}: has {size / 1e6:.0f} MB; the maximum is {limit / 1e6:.0f} MB; {fix}")
    try:
        return path.read_bytes()
    except OSError as error:
        raise QuadrupedError(f"{path}: cannot be read ({error.strerror}); {fix}") from error


def parse(content: bytes, source: str) -> Node:
    """Return the root element of XML, without its texts; `source` names it in errors.

    Raises:
        QuadrupedError: if it is not XML, declares entities, or is nested too deeply.
    """
    builder = _Builder(source)
    try:
        builder.parser.Parse(content, True)
    except (expat.ExpatError, LookupError, ValueError) as error:
        if isinstance(error, QuadrupedError):
            raise
        raise QuadrupedError(f"{source}: is not XML ({error}); {FIX}") from error
    assert builder.root is not None
    return builder.root
