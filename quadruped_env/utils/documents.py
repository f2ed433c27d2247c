"""Reader of small structured files (JSON, TOML) that turns every defect into this package's error, and their forms.

Python's own parsers raise errors of many types: for numbers of thousands of digits, for deep nesting, for bytes that
are not text. Opening a pipe waits forever, and a TOML key of ten thousand parts takes very long. Every such file that a
user may hand over is read here.
"""

import json
import math
import re
import stat
import sys
import tomllib
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, Final, Literal, TypeVar, Union, get_args, get_origin, get_type_hints, is_typeddict

from quadruped_env.errors import QuadrupedError, short

Form = TypeVar("Form")

MAX_BYTES: Final = {"JSON": 16_000_000, "TOML": 1_000_000}
"""Maximum size of a document: far larger than any written by this package or by hand; Python's TOML parser is slow."""
MAX_DEPTH: Final = 32
"""Maximum nesting depth: far deeper than any document of this package."""

_LARGEST: Final = 1e15
"""Largest size of a number in a form: far beyond any result, and far from where squares overflow."""
_NAMES: Final = {
    str: "a text",
    bool: "true or false",
    int: "a whole number",
    float: "a finite number",
    NoneType: "null",
}
_KINDS: Final = (
    (stat.S_ISDIR, "a directory"),
    (stat.S_ISFIFO, "a pipe"),
    (stat.S_ISCHR, "a device"),
    (stat.S_ISBLK, "a device"),
    (stat.S_ISSOCK, "a socket"),
)
_LONG_KEY: Final = re.compile(
    rf"""(?<![\w-])(?:(?:"[^"\n]{{,99}}+"|'[^'\n]{{,99}}+'|[\w-]++)[ \t]*+\.[ \t]*+){{{MAX_DEPTH}}}"""
)
"""A dotted key of over `MAX_DEPTH` parts: the parser's time grows with the square of their number."""


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
        found = next((name for holds, name in _KINDS if holds(mode)), "no regular file")
        hint = " (save what it gives in a file first)" if stat.S_ISFIFO(mode) else ""
        raise QuadrupedError(f"{path}: is {found}; {fix}{hint}")


def read_json(path: Path, fix: str = "name a JSON file") -> Any:
    """The document in a JSON file.

    Args:
        path: of the file.
        fix: what errors advise.

    Raises:
        QuadrupedError: if it cannot be read, is not JSON, or is nested too deeply; if it holds a number that no float64
            holds. The message names the file and the place.
    """
    return parse_json(_text(path, "JSON", fix), str(path), fix)


def parse_json(text: str, where: str, fix: str = "fix it") -> Any:
    """The document in JSON text; `where` names it in errors. As `read_json`."""
    return _parsed(json.loads, text, where, "JSON", fix)


def read_toml(path: Path, fix: str = "fix it, or name another file") -> dict[str, Any]:
    """The document in a TOML file; as `read_json`."""
    text = _text(path, "TOML", fix)
    if _LONG_KEY.search(text):
        raise QuadrupedError(f"{path}: a key of over {MAX_DEPTH} parts; {fix}")
    document: dict[str, Any] = _parsed(tomllib.loads, text, str(path), "TOML", fix)
    return document


def _text(path: Path, language: str, fix: str) -> str:
    check_regular(path, fix)
    limit = MAX_BYTES[language]
    try:
        with path.open("rb") as file:
            data = file.read(limit + 1)
    except OSError as error:
        raise _unreadable(path, error, fix) from error
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
    try:
        document = parse(text)
    except RecursionError as error:
        raise QuadrupedError(f"{where}: nested deeper than {MAX_DEPTH} levels; {fix}") from error
    # The parsers' own errors are ValueErrors, and so is Python's about whole numbers of over 4300 digits.
    except ValueError as error:
        raise QuadrupedError(f"{where}: not valid {language}: {error}; {fix}") from error
    _check_values(document, where, fix)
    return document


def _check_values(document: Any, where: str, fix: str) -> None:
    """Raise a QuadrupedError at the first value that later code could not handle."""
    pending: list[tuple[Any, tuple[object, ...]]] = [(document, ())]
    while pending:
        value, place = pending.pop()
        problem = _problem(value, len(place))
        if problem is not None:
            at = f"{short('.'.join(map(str, place)))}: " if place else ""
            raise QuadrupedError(f"{where}: {at}{problem}; {fix}")
        if isinstance(value, dict):
            pending += ((key, (*place, "a key")) for key in value)
            pending += ((part, (*place, key)) for key, part in value.items())
        elif isinstance(value, list):
            pending += ((part, (*place, i)) for i, part in enumerate(value))


def _problem(value: Any, depth: int) -> str | None:
    """Description of a value's defect, or None."""
    if depth > MAX_DEPTH:
        return f"nested deeper than {MAX_DEPTH} levels"
    if isinstance(value, int):
        try:
            math.isfinite(value)
        except OverflowError:
            return f"a whole number beyond {sys.float_info.max:.1e}"
    # "\ud800" is half of a character, and can be neither printed nor written.
    if isinstance(value, str):
        try:
            value.encode()
        except UnicodeEncodeError:
            return f"{short(value)} holds half a character"
    return None


def fitted(document: Any, form: type[Form], where: str, fix: str) -> Form:
    """The parts of a document that a form has; whatever else the document holds is left out.

    Args:
        document: from a JSON file.
        form: a `TypedDict` or a dataclass, whose fields are forms too: `str`, `int`, `float`, `bool`, `Any`, `Literal`,
            `list`, `dict` with texts as keys, or several with `|`. Numbers must be finite.
        where: names the document in errors.
        fix: what errors advise.

    Raises:
        QuadrupedError: if a field is missing or of another form; the message names it, its value and the form.
    """
    try:
        found: Form = _fitted(document, form, ())
    except _UnfitError as error:
        place = f"{where}: {short('.'.join(map(str, error.place)))[1:-1]}" if error.place else where
        problem = " is missing" if error.found is None else f": expected {error.expected}; found {error.found}"
        raise QuadrupedError(f"{place}{problem}; {fix}") from None
    return found


class _UnfitError(Exception):
    """A part of a document that does not fit its form; `found`: None for one that is missing."""

    def __init__(self, place: tuple[object, ...], expected: str, found: str | None) -> None:
        super().__init__(place)
        self.place, self.expected, self.found = place, expected, found


def _fitted(value: Any, form: Any, place: tuple[object, ...]) -> Any:
    if form is Any:
        return value
    kind, parts = get_origin(form) or form, get_args(form)
    if is_typeddict(form) or is_dataclass(form) or kind is dict:
        if not isinstance(value, dict):
            raise _UnfitError(place, "a table", short(value))
        if kind is dict:
            return {key: _fitted(entry, parts[1], (*place, key)) for key, entry in value.items()}
        required = form.__required_keys__ if is_typeddict(form) else {one.name for one in fields(form)}
        if missing := sorted(required - value.keys()):
            raise _UnfitError((*place, missing[0]), "a value", None)
        hints = get_type_hints(form)
        found = {key: _fitted(value[key], hint, (*place, key)) for key, hint in hints.items() if key in value}
        return found if is_typeddict(form) else form(**found)
    if kind is list:
        if not isinstance(value, list):
            raise _UnfitError(place, "a list", short(value))
        return [_fitted(entry, parts[0], (*place, i)) for i, entry in enumerate(value)]
    if kind in (UnionType, Union):
        return _fitted_to_one(value, parts, place)
    if kind is Literal:
        fits = any(type(value) is type(part) and value == part for part in parts)
    elif kind is float:
        fits = type(value) in (int, float) and abs(value) <= _LARGEST
    else:
        fits = type(value) is kind and (kind is not int or abs(value) <= _LARGEST)
    if not fits:
        raise _UnfitError(place, _NAMES.get(kind) or " or ".join(map(repr, parts)), short(value))
    return value


def _fitted_to_one(value: Any, forms: tuple[Any, ...], place: tuple[object, ...]) -> Any:
    """The value in the first form that it fits, or the error of the form that it fits farthest."""
    errors = []
    for form in forms:
        try:
            return _fitted(value, form, place)
        except _UnfitError as error:
            errors.append(error)
    deepest = max(errors, key=lambda error: len(error.place))
    if len(deepest.place) > len(place):
        raise deepest
    raise _UnfitError(place, " or ".join(error.expected for error in errors), errors[0].found)
