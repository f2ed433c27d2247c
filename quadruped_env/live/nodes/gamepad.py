"""Drive the robot with a gamepad or joystick (Linux): sends /cmd_vel while the enable button is held.

    mini-quadruped live gamepad                               LB held: left stick walks, right stick turns; B: stop
    mini-quadruped live gamepad --axes 1 0 --buttons 5 1 7    other sticks, and RB held

The left stick's other axis walks sideways, if the robot's legs can roll.

Releasing the button, unplugging the gamepad, or the end of this program makes the robot stand. The stop button sends
/estop, which lets it go limp; the start button ends the stop, and the next velocity command makes the robot stand up.
`jstest /dev/input/js0` shows the numbers of a gamepad.
"""

import argparse
import os
import struct
from pathlib import Path
from typing import Final, Self

from quadruped_env.control.control_config import VELOCITIES
from quadruped_env.control.steering import Velocity
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.messages.steering_messages import velocity_message
from quadruped_env.live.middleware.topics import CMD_VEL, ESTOP
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import Session
from quadruped_env.ros import cdr

_PERIOD: Final = 0.05
"""Time between messages, s."""
_DEAD_ZONE: Final = 0.1
"""Deflection below which a stick counts as centred."""
_STAND: Final[Velocity] = (0.0, 0.0, 0.0)
_EVENT: Final = struct.Struct("=IhBB")
"""Event of Linux's joystick interface: time in ms, value, type, number (`struct js_event`)."""
_BUTTON, _AXIS, _INITIAL = 0x01, 0x02, 0x80
_FULL: Final = 32767


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
        pressed: set[int] = set()
        while True:
            try:
                # The device gives whole events.
                data = os.read(self._file, 64 * _EVENT.size)
            except BlockingIOError:
                return pressed
            except OSError:  # ENODEV
                data = b""
            if not data:
                raise QuadrupedError(f"{self._device}: was unplugged")
            for _, value, kind, number in _EVENT.iter_unpack(data):
                if kind & ~_INITIAL == _AXIS:
                    self.axes[number] = max(-1.0, value / _FULL)
                elif kind & ~_INITIAL == _BUTTON:
                    self.buttons[number] = bool(value)
                    pressed |= {number} if value else set()


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the device, its axes and buttons."""
    parser.add_argument(
        "--device", type=Path, default=Path("/dev/input/js0"), metavar="FILE", help="(default: %(default)s)"
    )
    parser.add_argument(
        "--axes",
        nargs="+",
        type=int,
        default=[1, 3, 0],
        metavar="AXIS",
        help="numbers of the axes: forward, turn and, if there are three, left (default: 1 3 0, of an Xbox controller)",
    )
    parser.add_argument(
        "--buttons",
        nargs=3,
        type=int,
        default=[4, 1, 7],
        metavar=("ENABLE", "STOP", "START"),
        help="numbers of the buttons that enable commands while held, stop, and end the stop (default: 4 1 7)",
    )


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Send until the session ends, then make the robot stand."""
    velocities, stops = session.node.publish(CMD_VEL), session.node.publish(ESTOP)
    enable, stop, start = arguments.buttons
    if len(arguments.axes) not in (2, 3):
        raise QuadrupedError(f"--axes: expected two or three numbers: forward, turn, left; found {len(arguments.axes)}")
    pace, enabled, command = Pace(_PERIOD), False, _STAND
    try:
        with Gamepad(arguments.device) as gamepad:
            for _ in session.turns(lambda: pace.remaining):
                if not pace.tick():
                    continue
                pressed = gamepad.update()
                for button, stopped in ((start, False), (stop, True)):
                    if button in pressed:
                        stops.send(cdr.message(ESTOP.type_name, data=stopped))
                before, enabled = enabled, gamepad.buttons.get(enable, False)
                command = velocity(gamepad, arguments.axes) if enabled else _STAND
                if enabled or before:
                    velocities.send(velocity_message(command))
                session.wait_for("" if velocities.readers else f"a subscription to {CMD_VEL.name}")
    finally:
        if enabled:
            velocities.send(velocity_message(_STAND))
            velocities.wait_until_read(0.5)
    return 0


def velocity(gamepad: Gamepad, axes: list[int]) -> Velocity:
    """Return the command of some axes: full deflection is the end of the range that policies are trained for."""
    values = []
    for entry, axis in zip(VELOCITIES, axes, strict=False):
        low, high = entry.range
        # Up and left are negative on the device.
        deflection = -gamepad.axes.get(axis, 0.0)
        values.append(0.0 if abs(deflection) < _DEAD_ZONE else deflection * (high if deflection > 0.0 else -low))
    return tuple(values)
