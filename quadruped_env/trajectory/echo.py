"""What `ros2 topic echo` prints of joint states, as YAML and as `--csv` text.

YAML: a document a message, in block or flow style, each ended by a line `---`. A notice of lost messages may stand
between them; it is reported. CSV has no header and no quotes:

    sec,nanosec,frame_id,names...,positions...,velocities...,efforts...

and an empty array is one empty field. Both shorten arrays of over 128 numbers to `...` unless asked not to
(`--full-length`): those are refused.
"""

import re
from array import array
from collections.abc import Iterator
from itertools import takewhile
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, short
from quadruped_env.ros.joint_state import NANOSECONDS, RawJointState
from quadruped_env.trajectory.delimited import lines, opened, parse_number
from quadruped_env.trajectory.reading import KINDS, Reading, Sample

LOST: Final = "A message was lost!!!"
"""How a notice of lost messages begins"""

_LOST_NOTE: Final = "the recording itself says that messages were lost"
_MAX_DOCUMENT: Final = 1_000_000
"""Characters: a longer one is no joint state"""
_SHORTENED: Final = "an array is shortened to '...'; record it again with ros2 topic echo --full-length"
_FORM: Final = "expected what ros2 topic echo prints of a sensor_msgs/msg/JointState"
_SPECIAL: Final = {".nan": "nan", ".inf": "inf", "-.inf": "-inf"}
"""How YAML writes what is not finite"""
_INTEGER: Final = re.compile(r"-?\d{1,18}$", re.ASCII)
_MAX_KEYS_SHOWN: Final = 8
_MAX_DEPTH: Final = 8
"""Levels of nesting; a joint state has three"""

Node = str | list[Any] | tuple[Any, ...]
"""What YAML says, as text: a scalar, a sequence, or the pairs of a mapping"""


def read_yaml(reading: Reading) -> Iterator[Sample]:
    """The messages of YAML text.

    Raises:
        QuadrupedError: if the file is missing or damaged; whether its values make sense is not checked here.
        MissingExtraError: if PyYAML is not installed.
    """
    yaml = yaml_module()
    reading.row_name = "message"
    with opened(reading) as file:
        number = 0
        for text in _documents(lines(file, reading, 1), reading):
            if text.lstrip().startswith(LOST):
                reading.note(_LOST_NOTE)
                continue
            try:
                yield Sample(number, _state(_document(yaml, text)))
            except (yaml.YAMLError, ValueError) as error:
                reason = " ".join(str(error).split())
                raise reading.error(number, f"{reason}; {_FORM}; mend it or delete it") from error
            number += 1
    if not number:
        raise reading.error(None, f"there is no message in it; {_FORM}")


def read_csv(reading: Reading) -> Iterator[Sample]:
    """The messages of `--csv` text.

    Raises:
        QuadrupedError: if the file is missing or damaged; whether its values make sense is not checked here.
    """
    reading.row_name = "line"
    with opened(reading) as file:
        for number, line in enumerate(lines(file, reading, 1), 1):
            if line.startswith((LOST, "\t")):
                reading.note(_LOST_NOTE)
                continue
            try:
                yield Sample(number, _state_of_cells(line.rstrip("\n").split(","), reading.options.names))
            except ValueError as error:
                raise reading.error(number, f"{error}; mend the line or delete it") from error


def yaml_module() -> Any:
    """PyYAML.

    Raises:
        MissingExtraError: if it is not installed.
    """
    try:
        import yaml
    except ImportError as error:
        raise MissingExtraError("reading YAML", "ros") from error
    return yaml


def _documents(found: Iterator[str], reading: Reading) -> Iterator[str]:
    """The texts between lines that end in `---`, without empty ones."""
    parts: list[str] = []
    size = 0
    for line in found:
        ends = line.rstrip().endswith("---")
        part = line.rstrip().removesuffix("---") if ends else line
        parts.append(part)
        size += len(part)
        if size > _MAX_DOCUMENT:
            raise reading.error(None, f"a message of over {_MAX_DOCUMENT} characters is no joint state; {_FORM}")
        if ends:
            text = "".join(parts)
            parts, size = [], 0
            if text.strip():
                yield text
    if "".join(parts).strip():
        yield "".join(parts)


def _document(yaml: Any, text: str) -> Node | None:
    """The one document in YAML text; None if it is empty.

    Made from PyYAML's events, since its own composer recurses in C: 30,000 brackets end the process.

    Raises:
        yaml.YAMLError: if it is not YAML.
        ValueError: if it holds several documents or anchors, or is nested too deeply.
    """
    root: list[Any] = []
    """The node, once it begins"""
    levels: list[list[Any]] = []
    """The children of the nodes that have begun: of a mapping, key and value by turns"""
    for event in yaml.parse(text, yaml.CSafeLoader):
        children = levels[-1] if levels else root
        if getattr(event, "anchor", None) is not None:
            raise ValueError(f"there is an anchor or alias, {short(event.anchor)}")
        if isinstance(event, yaml.ScalarEvent):
            children.append(event.value)
        elif isinstance(event, yaml.CollectionStartEvent):
            if len(levels) == _MAX_DEPTH:
                raise ValueError(f"it is nested deeper than {_MAX_DEPTH} levels")
            levels.append([])
            children.append(levels[-1])
        elif isinstance(event, yaml.CollectionEndEvent):
            pairs = levels.pop()
            if isinstance(event, yaml.MappingEndEvent):
                (levels[-1] if levels else root)[-1] = tuple(zip(pairs[::2], pairs[1::2], strict=True))
        elif isinstance(event, yaml.DocumentStartEvent) and root:
            raise ValueError("there are two documents")
    return root[0] if root else None


def _state(node: Node | None) -> RawJointState:
    """A message of a YAML node; ValueError if it is none."""
    fields = _mapping(node, ("header", "name", *KINDS), "the message")
    header = _mapping(fields["header"], ("stamp", "frame_id"), "header")
    stamp = _mapping(header["stamp"], ("sec", "nanosec"), "header.stamp")
    names = tuple(_scalar(item, "name") for item in _sequence(fields["name"], "name"))
    numbers = [array("d", [_number(item, kind) for item in _sequence(fields[kind], kind)]) for kind in KINDS]
    return RawJointState(_stamp(_scalar(stamp["sec"], "sec"), _scalar(stamp["nanosec"], "nanosec")), names, *numbers)


def _mapping(node: Node | None, keys: tuple[str, ...], what: str) -> dict[str, Any]:
    """Key -> node. YAML's own mappings would keep the last of two equal keys, and say nothing."""
    pairs = node if isinstance(node, tuple) else ()
    found = [key for key, _ in pairs if isinstance(key, str)]
    if sorted(found) != sorted(keys) or len(found) != len(pairs):
        some = ", ".join(short(key)[1:-1] for key in found[:_MAX_KEYS_SHOWN])
        more = f" and {len(found) - _MAX_KEYS_SHOWN} more" if len(found) > _MAX_KEYS_SHOWN else ""
        raise ValueError(f"{what} must have {', '.join(keys)}, each once; found {some or 'none'}{more}")
    return dict(pairs)


def _sequence(node: Node, what: str) -> list[Any]:
    if not isinstance(node, list):
        raise ValueError(f"{what} must be a list; found {short(node)}")
    return node


def _scalar(node: Node, what: str) -> str:
    if not isinstance(node, str):
        raise ValueError(f"{what} must hold single values")
    if node == "...":
        raise ValueError(_SHORTENED)
    return node


def _number(node: Node, what: str) -> float:
    """A number; YAML would take 1e-05 for a text."""
    text = _scalar(node, what)
    return _cell_number(_SPECIAL.get(text, text), what)


def _stamp(sec: str, nanosec: str) -> int:
    for text in (sec, nanosec):
        if not _INTEGER.match(text):
            raise ValueError(f"{short(text)} is not a whole number in a stamp")
    if not 0 <= int(nanosec) < NANOSECONDS or not -(2**31) <= int(sec) < 2**31:
        raise ValueError(f"a stamp of {sec} s and {nanosec} ns is none")
    return int(sec) * NANOSECONDS + int(nanosec)


def _state_of_cells(cells: list[str], given: tuple[str, ...] | None) -> RawJointState:
    """A message of the fields of a line; ValueError if it is none."""
    if "..." in cells:
        raise ValueError(_SHORTENED)
    if len(cells) < 7:
        raise ValueError(f"{len(cells)} fields are too few; {_FORM} --csv")
    stamp = _stamp(cells[0], cells[1])
    names = list(takewhile(lambda cell: cell and not _is_number(cell), cells[3:]))
    rest = cells[3 + max(len(names), 1) :]
    count = len(names) or len(given or ())
    if not names and cells[3]:
        raise ValueError(f"there is {short(cells[3])} where the joints' names begin")
    count = count or _count_without_names(rest)
    numbers = []
    for kind in KINDS:
        if rest and not rest[0]:
            group, rest = [], rest[1:]
        else:
            group, rest = rest[:count], rest[count:]
            if len(group) < count:
                raise ValueError(f"{count} joints and {len(group)} numbers for {kind}")
        numbers.append(array("d", [_cell_number(cell, kind) for cell in group]))
    if rest:
        raise ValueError(f"there are {len(rest)} fields more than {count} joints need")
    return RawJointState(stamp, tuple(names), *numbers)


def _count_without_names(cells: list[str]) -> int:
    """How many numbers each array has, where no names tell."""
    filled = 3 - cells.count("")
    numbers = len(cells) - cells.count("")
    if filled <= 0 or numbers % filled:
        raise ValueError("there are no names to tell where the positions end; give the joints in order (--names)")
    return numbers // filled


def _cell_number(text: str, what: str) -> float:
    try:
        return parse_number(text)
    except ValueError:
        raise ValueError(f"{what}: {short(text)} is not a number") from None


def _is_number(text: str) -> bool:
    try:
        parse_number(text)
    except ValueError:
        return False
    return True
