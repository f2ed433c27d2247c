"""Reader of XML that names lines in errors, and expands no entities."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final
from xml.parsers import expat

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.utils import documents
from quadruped_env.utils.documents import check_regular

MAX_BYTES: Final = 20_000_000
"""Maximum size of a description; the largest public ones have 1 MB."""
_MAX_DEPTH: Final = 200
FIX: Final = "name a URDF, a xacro file or an MJCF"


@dataclass
class Node:
    """An element, without its texts."""

    tag: str
    attributes: dict[str, str]
    line: int
    children: list["Node"] = field(default_factory=list)

    def get(self, name: str) -> str | None:
        """Return the value of an attribute, or None."""
        return self.attributes.get(name)

    def findall(self, tag: str) -> list["Node"]:
        """Return the children of a tag."""
        return [child for child in self.children if child.tag == tag]

    def iter(self) -> Iterator["Node"]:
        """Yield the element and all below it."""
        yield self
        for child in self.children:
            yield from child.iter()


def read_bytes(path: Path, fix: str = FIX, limit: int = MAX_BYTES) -> bytes:
    """Return the content of a regular file of limited size.

    Raises:
        QuadrupedError: if it is missing, no regular file, too large, or cannot be read.
    """
    check_regular(path, fix)
    size = path.stat().st_size
    if size > limit:
        raise QuadrupedError(f"{path}: has {size / 1e6:.0f} MB; the maximum is {limit / 1e6:.0f} MB; {fix}")
    return documents.read_bytes(path, fix)


def parse(content: bytes, where: str = "") -> Node:
    """Return the root element of XML; `where` begins its errors, with the name of a file that another one includes.

    Raises:
        QuadrupedError: if it is not XML, declares entities, or is nested too deeply.
    """
    parser = expat.ParserCreate()
    document = Node("", {}, 0)
    stack = [document]

    def start(tag: str, attributes: dict[str, str]) -> None:
        node = Node(tag, attributes, parser.CurrentLineNumber)
        if len(stack) > _MAX_DEPTH:
            raise QuadrupedError(f"{where}line {node.line}: elements are nested over {_MAX_DEPTH} deep; {FIX}")
        stack[-1].children.append(node)
        stack.append(node)

    def entity(name: str, *_: object) -> None:
        raise QuadrupedError(
            f"{where}line {parser.CurrentLineNumber}: declares the entity {short(name)}, and entities are not "
            f"expanded, because a few of them can fill the memory; write its text where it is used"
        )

    parser.StartElementHandler, parser.EntityDeclHandler = start, entity
    parser.EndElementHandler = lambda _: stack.pop()
    try:
        parser.Parse(content, True)
    except QuadrupedError:
        raise
    except (expat.ExpatError, LookupError, ValueError) as error:
        raise QuadrupedError(f"{where}is not XML ({error}); {FIX}") from error
    return document.children[0]
