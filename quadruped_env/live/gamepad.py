"""Events of a joystick or gamepad, from Linux's joystick interface (`/dev/input/js0`)."""

import os
import struct
from pathlib import Path
from typing import Final, Self

from quadruped_env.errors import QuadrupedError

_EVENT: Final = struct.Struct("=IhBB")
"""Time in ms, value, type, number: `struct js_event`."""
_BUTTON, _AXIS, _INITIAL = 0x01, 0x02, 0x80
_FULL: Final = 32767
_READ: Final = 64 * _EVENT.size


class Gamepad:
    """Context manager of a device with its current axes and buttons.

    Args:
        device: the device file.

    Raises:
        QuadrupedError: if it cannot be opened.
    """

    def __init__(self, device: Path) -> None:
        self._device = device
        self.axes: dict[int, float] = {}
        """Positions in [-1, 1], by number; right and down are positive."""
        self.buttons: dict[int, bool] = {}
        """True while pressed, by number."""
        self._rest = b""

    def __enter__(self) -> Self:
        try:
            self._file = os.open(self._device, os.O_RDONLY | os.O_NONBLOCK)
        except OSError as error:
            raise QuadrupedError(
                f"--device: cannot read {self._device} ({error.strerror}); plug in a gamepad, name another device, or "
                f"join the group 'input'"
            ) from error
        return self

    def __exit__(self, *error: object) -> None:
        os.close(self._file)

    def update(self) -> set[int]:
        """Take all events. Returns the buttons pressed since the last call.

        Raises:
            QuadrupedError: if the device was unplugged.
        """
        pressed = set()
        while data := self._read():
            data = self._rest + data
            whole = len(data) - len(data) % _EVENT.size
            self._rest = data[whole:]
            for _, value, kind, number in _EVENT.iter_unpack(data[:whole]):
                if kind & ~_INITIAL == _AXIS:
                    self.axes[number] = max(-1.0, value / _FULL)
                elif kind & ~_INITIAL == _BUTTON:
                    self.buttons[number] = bool(value)
                    if value:
                        pressed.add(number)
        return pressed

    def _read(self) -> bytes:
        try:
            data = os.read(self._file, _READ)
        except BlockingIOError:
            return b""
        except OSError:  # ENODEV
            data = b""
        if not data:
            raise QuadrupedError(f"{self._device}: was unplugged")
        return data
