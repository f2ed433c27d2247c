"""Messages as text: output of `ros2 topic echo`, as YAML and with `--csv`.

YAML: one document per message, in block or flow style, each ended by a line `---`, also as ROS 1 prints it. Notices of
lost messages between them, whose last line ends in `---`, are reported. CSV has no header and no quotes:

    sec,nanosec,frame_id,names...,positions...,velocities...,efforts...

and an empty array is one empty field. Both shorten arrays of over 128 numbers to `...`, unless called with
`--full-length`; shortened arrays are an error.
"""

import re
from collections.abc import Iterator
from itertools import takewhile
from typing import Any, Final

import numpy as np

from quadruped_env.errors import MissingExtraError, QuadrupedError, short
from quadruped_env.ros.robot_messages import RawJointState
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.formats.delimited import is_number, lines, opened, parse_number
from quadruped_env.trajectory.formats.message_rows import assembled
from quadruped_env.trajectory.reading import Reading
from quadruped_env.trajectory.rows import KINDS, Rows
from quadruped_env.utils.arrays import Floats

LOST: Final = "A message was lost!!!"
"""First words of a notice of lost messages."""

_LOST_NOTE: Final = "the recording itself says that messages were lost"
_MAX_DOCUMENT: Final = 1_000_000
"""Maximum characters of a message; no joint state is longer."""
_SHORTENED: Final = "an array is shortened to '...'; record it again with ros2 topic echo --full-length"
_FORM: Final = "expected what ros2 topic echo prints of a sensor_msgs/msg/JointState"
_SPECIAL: Final = {".nan": "nan", ".inf": "inf", "-.inf": "-inf"}
"""Numbers that are not finite in YAML -> in Python."""
_INTEGER: Final = re.compile(r"-?\d{1,18}$", re.ASCII)
_MAX_KEYS_SHOWN: Final = 8
_MAX_DEPTH: Final = 8
"""Maximum levels of nesting; a trajectory has five."""

_STATE_KEYS: Final = ("name", *KINDS)
_ARRAY_KEYS: Final = ("layout", "data")

Node = str | list[Any] | dict[str, Any] | None
"""A node of YAML, its values still as text."""


def read_yaml(reading: Reading) -> Rows | None:
    """Return the messages of YAML text, not validated.

    Raises:
        QuadrupedError: if the file is missing or damaged.
        MissingExtraError: if PyYAML is not installed.
    """
    return assembled(_yaml_messages(reading), reading, is_text=True)


def read_csv(reading: Reading) -> Rows | None:
    """Return the messages of `--csv` text, not validated. Raises a QuadrupedError if the file is missing or damaged."""
    return assembled(_csv_messages(reading), reading, is_text=True)


def _yaml_messages(reading: Reading) -> Iterator[tuple[int, list[RawJointState]]]:
    """Yield the number in the file, and joint states of the messages."""
    reading.row_name = "message"
    with opened(reading) as file:
        number = 0
        for text in _documents(lines(file, reading), reading):
            if text.lstrip().startswith(LOST):
                reading.note(_LOST_NOTE)
                continue
            try:
                state = _state(safe_yaml(text, _MAX_DEPTH), reading)
            except ValueError as error:
                raise reading.error(number, f"{error}; {_FORM}; fix it or delete it") from error
            yield number, [state]
            number += 1
    if not number:
        raise reading.error(None, f"there is no message in it; {_FORM}")


def _csv_messages(reading: Reading) -> Iterator[tuple[int, list[RawJointState]]]:
    """Yield the number of the line, and message."""
    reading.row_name = "line"
    with opened(reading) as file:
        for number, line in enumerate(lines(file, reading), 1):
            if line.startswith((LOST, "\t")):
                reading.note(_LOST_NOTE)
                continue
            try:
                yield number, [_state_of_cells(line.rstrip("\n").split(","), reading.options.names)]
            except ValueError as error:
                raise reading.error(number, f"{error}; fix the line or delete it") from error


def safe_yaml(text: str, max_depth: int) -> Any:
    """Return the only document in YAML text, its scalars as text; None if it is empty.

    Raises:
        ValueError: if it is not YAML, holds several documents or anchors, or is nested too deeply.
        MissingExtraError: if PyYAML is not installed.
    """
    try:
        import yaml
    except ImportError as error:
        raise MissingExtraError("reading YAML", "ros") from error
    depth = 0
    try:
        # Before it is composed, which recurses in C: 30,000 brackets would crash the process.
        for event in yaml.parse(text, yaml.CSafeLoader):
            depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
            if depth > max_depth:
                raise ValueError(f"nested deeper than {max_depth} levels")
            if getattr(event, "anchor", None) is not None:
                raise ValueError(f"there is an anchor or alias, {short(event.anchor)}")
        return yaml.load(text, yaml.CBaseLoader)
    except yaml.YAMLError as error:
        raise ValueError(" ".join(str(error).split())) from error


def _documents(found: Iterator[str], reading: Reading) -> Iterator[str]:
    """Yield the texts between lines `---`, except empty ones.

    Raises:
        QuadrupedError: if a message is too long, or a line of one ends in `---`, whose end may be cut off.
    """
    parts: list[str] = []
    size = 0
    for number, line in enumerate(found, 1):
        ends = line.rstrip().endswith("---")
        part = line.rstrip().removesuffix("---") if ends else line
        # Nothing ends the line of a notice before the separator.
        if ends and part and not (parts or [part])[0].startswith(LOST):
            raise QuadrupedError(
                f"{reading.name}: line {number}: {short(line.strip())} ends in ---, which belongs on a line of "
                f"its own, so what is before it may be cut off; fix it, or delete the message"
            )
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


def _state(node: Node, reading: Reading) -> RawJointState:
    """Return the joint state in a node, of a `JointState` or `Float64MultiArray`.

    Raises ValueError if the node holds another message.
    """
    keys = _keys(node)
    if _ARRAY_KEYS[0] in keys:
        if reading.options.period is None:
            raise ValueError("an array has no timestamp: give the time from row to row in s (--stamps 0.02)")
        data = _numbers(_mapping(node, _ARRAY_KEYS, "the message")["data"], "data")
        return RawJointState(0, (), data, np.empty(0), np.empty(0))
    fields = _mapping(node, ("header", *_STATE_KEYS), "the message")
    ros1 = ("seq",) if "seq" in _keys(fields["header"]) else ()
    header = _mapping(fields["header"], (*ros1, "stamp", "frame_id"), "header")
    names = [_scalar(item, "name") for item in _sequence(fields["name"], "name")]
    stamp = _time(header["stamp"], "header.stamp")
    return RawJointState(stamp, tuple(names), *(_numbers(fields[kind], kind) for kind in KINDS))


def _time(node: Node, what: str) -> int:
    """Return a time or a duration, ns."""
    keys = ("secs", "nsecs") if "secs" in _keys(node) else ("sec", "nanosec")
    found = _mapping(node, keys, what)
    return _stamp(*(_scalar(found[key], key) for key in keys))


def _numbers(node: Node, what: str) -> Floats:
    return np.array([_number(item, what) for item in _sequence(node, what)], dtype=np.float64)


def _keys(node: Node) -> list[str]:
    """Return keys of a mapping; none of another node."""
    return [str(key) for key in node] if isinstance(node, dict) else []


def _mapping(node: Node, keys: tuple[str, ...], what: str) -> dict[str, Any]:
    """Return a mapping with these keys. Raises ValueError for another node."""
    found = _keys(node)
    if sorted(found) != sorted(keys):
        some = ", ".join(short(key)[1:-1] for key in found[:_MAX_KEYS_SHOWN])
        more = f" and {len(found) - _MAX_KEYS_SHOWN} more" if len(found) > _MAX_KEYS_SHOWN else ""
        raise ValueError(f"{what} must have {', '.join(keys)}; found {some or 'none'}{more}")
    assert isinstance(node, dict)
    return node


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
    """Return a number; to YAML, 1e-05 is a text."""
    text = _scalar(node, what)
    return _cell_number(_SPECIAL.get(text, text), what)


def _stamp(sec: str, nanosec: str) -> int:
    for text in (sec, nanosec):
        if not _INTEGER.match(text):
            raise ValueError(f"{short(text)} is not a whole number in a timestamp")
    if not 0 <= int(nanosec) < NS_PER_SECOND or not -(2**31) <= int(sec) < 2**31:
        raise ValueError(f"{sec} s and {nanosec} ns are not a valid timestamp")
    return int(sec) * NS_PER_SECOND + int(nanosec)


def _state_of_cells(cells: list[str], given: tuple[str, ...] | None) -> RawJointState:
    """Return the message in the fields of a line. Raises ValueError if they are not a joint state."""
    if "..." in cells:
        raise ValueError(_SHORTENED)
    if len(cells) < 7:
        raise ValueError(f"{len(cells)} fields are too few; {_FORM} --csv")
    stamp = _stamp(cells[0], cells[1])
    names = list(takewhile(lambda cell: cell and not is_number(cell), cells[3:]))
    rest = cells[3 + max(len(names), 1) :]
    count = len(names) or len(given or ())
    if not names and cells[3]:
        raise ValueError(f"found {short(cells[3])} where the joints' names begin")
    count = count or _count_without_names(rest)
    numbers = []
    for kind in KINDS:
        if rest and not rest[0]:
            group, rest = [], rest[1:]
        else:
            group, rest = rest[:count], rest[count:]
            if len(group) < count:
                raise ValueError(f"{count} joints and {len(group)} numbers for {kind}")
        numbers.append(np.array([_cell_number(cell, kind) for cell in group], dtype=np.float64))
    if rest:
        raise ValueError(f"there are {len(rest)} fields more than {count} joints need")
    return RawJointState(stamp, tuple(names), *numbers)


def _count_without_names(cells: list[str]) -> int:
    """Return the length of the arrays of a message without names."""
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
