"""Key presses from a terminal."""

import os
import re
import select
import sys
from typing import Any, Final, Self

from quadruped_env.errors import QuadrupedError

UP: Final = "up"
DOWN: Final = "down"
LEFT: Final = "left"
RIGHT: Final = "right"

_ARROWS: Final = {b"A": UP, b"B": DOWN, b"C": RIGHT, b"D": LEFT}
_KEY: Final = re.compile(rb"\x1b[\[O](?P<arrow>[A-D])|\x1b[\[O][0-9;]*[E-Z~a-z]|(?P<char>[^\x1b])")
_UNFINISHED: Final = re.compile(rb"\x1b([\[O][0-9;]*)?$")
_READ: Final = 1024


class Keyboard:
    """Context manager that reads keys from standard input immediately and without echo.

    Raises:
        QuadrupedError: if it is not a terminal.
    """

    def __init__(self) -> None:
        self._terminal = sys.stdin.fileno()
        if not os.isatty(self._terminal):
            raise QuadrupedError("the keyboard: standard input is not a terminal; start this node from one")
        self._settings: Any = None
        self._rest = b""
        self.gone = False
        """True if the terminal was closed."""

    def __enter__(self) -> Self:
        import termios
        import tty

        self._settings = termios.tcgetattr(self._terminal)
        tty.setcbreak(self._terminal)
        return self

    def __exit__(self, *error: object) -> None:
        import termios

        if not self.gone:
            termios.tcsetattr(self._terminal, termios.TCSADRAIN, self._settings)

    def pressed(self, seconds: float) -> list[str]:
        """Return the keys since the last call: characters, `UP`, `DOWN`, `LEFT`, `RIGHT`. Waits if there are none.

        Args:
            seconds: timeout, s.
        """
        if self.gone or not select.select([self._terminal], [], [], max(0.0, seconds))[0]:
            return []
        try:
            data = os.read(self._terminal, _READ)
        except OSError:
            data = b""
        self.gone = not data
        keys, self._rest = split_keys(self._rest + data)
        return keys


def split_keys(data: bytes) -> tuple[list[str], bytes]:
    """Return the keys in a terminal's bytes, and the remaining bytes of an incomplete key sequence."""
    unfinished = _UNFINISHED.search(data)
    rest = unfinished[0] if unfinished else b""
    keys = []
    for match in _KEY.finditer(data[: len(data) - len(rest)]):
        if match["arrow"]:
            keys.append(_ARROWS[match["arrow"]])
        elif match["char"]:
            keys.append(match["char"].decode("latin-1"))
    return keys, rest
