"""The errors this package raises for bad input."""

import difflib
import re
import reprlib
from collections.abc import Iterable
from typing import Final

from quadruped_env.utils.interpreter import install_command

MAX_MESSAGE: Final = 700
"""Maximum length of an error message, characters: a file may hold megabytes."""

_MAX_END: Final = 250
"""Characters kept at the end of a shortened message, where the fix is."""
_MAX_SHOWN: Final = 40
"""Characters shown of a value from a file."""
_MORE: Final = "..."
_CONTROL: Final = re.compile("[\x00-\x1f\x7f-\x9f\u2028-\u202e\u2066-\u2069\ud800-\udfff]")
"""Characters with which a name from a file could control a terminal, or break or reverse a line."""


class QuadrupedError(ValueError):
    """Bad input: the message names what was wrong, where, and how to fix it.

    A message of over `MAX_MESSAGE` characters is cut in the middle, where values from a file stand. Control characters
    are escaped.
    """

    def __init__(self, message: str = "") -> None:
        super().__init__(cut(escaped(message, keep="\n")))


class MissingExtraError(ImportError):
    """A library is missing that an optional extra of this package installs."""

    def __init__(self, purpose: str, extra: str) -> None:
        super().__init__(f"{purpose} needs the '{extra}' extra: {install_command(extra)}")


class QuadrupedWarning(UserWarning):
    """Input that can be used but may not mean what the user intended."""


def cut(message: str) -> str:
    """A message of at most `MAX_MESSAGE` characters: its beginning, and its end."""
    if len(message) <= MAX_MESSAGE:
        return message
    return f"{message[: MAX_MESSAGE - _MAX_END - len(_MORE) - 2]} {_MORE} {message[-_MAX_END:]}"


def escaped(text: str, keep: str = "") -> str:
    """A text whose control characters are escaped, but for those to keep."""
    return _CONTROL.sub(lambda found: found[0] if found[0] in keep else ascii(found[0])[1:-1], text)


def short(value: object) -> str:
    """A value from a file or a caller as a message may show it, however large it is."""
    if isinstance(value, str):
        return repr(value if len(value) <= _MAX_SHOWN else value[:_MAX_SHOWN] + _MORE)
    try:
        text = _REPR.repr(value)
    except ValueError:  # Python refuses to write out whole numbers of over 4300 digits
        return f"a {type(value).__name__} too large to be shown"
    return text if len(text) <= 2 * _MAX_SHOWN else text[: 2 * _MAX_SHOWN] + _MORE


def did_you_mean(word: object, known: Iterable[str]) -> str:
    """End of a message about an unknown word: the known one that is most similar, or nothing.

    The dashes of options and the case do not count: what all words share makes none of them similar.
    """
    bare = {name.strip("-").lower(): name for name in known}
    near = difflib.get_close_matches(str(word)[:_MAX_SHOWN].strip("-").lower(), bare, 1)
    return f"; did you mean {bare[near[0]]}?" if near else ""


_REPR: Final = reprlib.Repr()
_REPR.maxstring = _REPR.maxother = _MAX_SHOWN
