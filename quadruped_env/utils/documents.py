"""Reader of small structured files (JSON, TOML) that turns every defect into this package's error, and their forms.

Python's own parsers raise errors of many types: for deep nesting, for bytes that are not text. Opening a pipe waits
forever. Every such file that a user may hand over is read here.
"""

import json
import re
import stat
import tomllib
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from pathlib import Path
from types import UnionType
from typing import Any, Final, Literal, TypeVar, get_args, get_origin, get_type_hints, is_typeddict

from quadruped_env.errors import QuadrupedError, short

Form = TypeVar("Form")

MAX_BYTES: Final = {"JSON": 16_000_000, "TOML": 1_000_000}
"""Maximum size of a document: far larger than any written by this package or by hand; Python's TOML parser is slow."""
_LARGEST: Final = 1e15
"""Largest size of a number in a form: far beyond any result, and far from where squares overflow."""
_NAMES: Final = {str: "a text", bool: "true or false", int: "a whole number", float: "a finite number"}
_HUGE_NUMBER: Final = re.compile(r"\d{301}")
"""Digits of a whole number that no float64 holds: arithmetic would raise an OverflowError."""


def check_regular(path: Path, fix: str) -> None:
    """Raise a QuadrupedError unless a path is a regular file.

    Opening a pipe waits until a process writes to it, and some devices never end.

    Args:
        path: of the file.
        fix: what errors advise, as in "name a TOML file".
    """
    try:
        mode = path.stat().st_mode
    except FileNotFoundError as error:
        raise QuadrupedError(f"{path}: there is no such file; check its name") from error
    except (OSError, ValueError) as error:
        raise _unreadable(path, error, fix) from error
    if not stat.S_ISREG(mode):
        found = "a directory" if stat.S_ISDIR(mode) else "a pipe" if stat.S_ISFIFO(mode) else "a device"
        raise QuadrupedError(f"{path}: is {found}; {fix}")


def read_bytes(path: Path, fix: str, limit: int = -1) -> bytes:
    """Return the content of a regular file, or its first bytes up to a limit; errors as `check_regular`."""
    check_regular(path, fix)
    try:
        with path.open("rb") as file:
            return file.read(limit)
    except OSError as error:
        raise _unreadable(path, error, fix) from error


def read_json(path: Path, fix: str = "name a JSON file") -> Any:
    """Return the document in a JSON file.

    Args:
        path: of the file.
        fix: what errors advise.

    Raises:
        QuadrupedError: if it cannot be read, is not JSON, or is nested too deeply; the message names the file.
    """
    return parse_json(_text(path, "JSON", fix), str(path), fix)


def parse_json(text: str, where: str, fix: str = "fix it") -> Any:
    """Return the document in JSON text; `where` names it in errors. As `read_json`."""
    return _parsed(json.loads, text, where, "JSON", fix)


def read_toml(path: Path, fix: str = "fix it, or name another file") -> dict[str, Any]:
    """Return the document in a TOML file; as `read_json`."""
    document: dict[str, Any] = _parsed(tomllib.loads, _text(path, "TOML", fix), str(path), "TOML", fix)
    return document


def _text(path: Path, language: str, fix: str) -> str:
    limit = MAX_BYTES[language]
    data = read_bytes(path, fix, limit + 1)
    if len(data) > limit:
        raise QuadrupedError(f"{path}: over {limit} bytes are too many; {fix}")
    try:
        # Editors on Windows put a byte-order mark in front.
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise QuadrupedError(
            f"{path}: not valid {language}: byte {error.start} is not UTF-8 ({error.reason}); {fix}"
        ) from error


def _unreadable(path: Path, error: Exception, fix: str) -> QuadrupedError:
    reason = getattr(error, "strerror", None) or str(error)
    return QuadrupedError(f"{path}: cannot be read ({reason}); {fix}")


def _parsed(parse: Callable[[str], Any], text: str, where: str, language: str, fix: str) -> Any:
    if _HUGE_NUMBER.search(text):
        raise QuadrupedError(f"{where}: a number of over 300 digits; {fix}")
    try:
        return parse(text)
    except RecursionError as error:
        raise QuadrupedError(f"{where}: nested too deeply; {fix}") from error
    except ValueError as error:
        raise QuadrupedError(f"{where}: not valid {language}: {error}; {fix}") from error


def fitted(document: Any, form: type[Form], where: str, fix: str) -> Form:
    """Return the parts of a document that a form has; everything else that the document holds is left out.

    Args:
        document: from a JSON file.
        form: a `TypedDict` or a dataclass, whose fields are forms too: `str`, `int`, `float`, `bool`, `Any`, `Literal`,
            `list`, `dict` with texts as keys, or one of these and None. Numbers must be finite.
        where: names the document in errors.
        fix: what errors advise.

    Raises:
        QuadrupedError: if a field is missing or has another form; the message names it, its value and the form.
    """

    def fit(value: Any, form: Any, *place: object) -> Any:
        def expect(fits: bool, expected: str) -> None:
            if not fits:
                at = f"{'.'.join(map(str, place))}: " if place else ""
                raise QuadrupedError(f"{where}: {at}expected {expected}{or_null}; found {short(value)}; {fix}")

        kind, parts, or_null = get_origin(form) or form, get_args(form), ""
        if kind is UnionType:
            if value is None:
                return None
            kind, parts, or_null = get_origin(parts[0]) or parts[0], get_args(parts[0]), " or null"
        if is_typeddict(kind) or is_dataclass(kind):
            expect(isinstance(value, dict), "a table")
            required = kind.__required_keys__ if is_typeddict(kind) else {one.name for one in fields(kind)}
            if missing := sorted(required - value.keys()):
                raise QuadrupedError(f"{where}: {'.'.join(map(str, (*place, missing[0])))} is missing; {fix}")
            hints = get_type_hints(kind)
            found = {key: fit(value[key], hint, *place, key) for key, hint in hints.items() if key in value}
            return found if is_typeddict(kind) else kind(**found)
        if kind is dict:
            expect(isinstance(value, dict), "a table")
            return {key: fit(entry, parts[1], *place, key) for key, entry in value.items()}
        if kind is list:
            expect(isinstance(value, list), "a list")
            return [fit(entry, parts[0], *place, i) for i, entry in enumerate(value)]
        if kind is Literal:
            expect(any(type(value) is type(part) and value == part for part in parts), " or ".join(map(repr, parts)))
        elif kind in (int, float):
            number = type(value) is int or (kind is float and type(value) is float)
            expect(number and abs(value) <= _LARGEST, _NAMES[kind])
        elif kind is not Any:
            expect(type(value) is kind, _NAMES[kind])
        return value

    result: Form = fit(document, form)
    return result
