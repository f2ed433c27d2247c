"""Publisher of commands to the driver of a robot."""

import time
from collections.abc import Callable

from quadruped_env.control.joint_command import LIMP, Target, TargetGate
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.messages.joint_messages import Jointed, command_message
from quadruped_env.live.middleware.topics import JOINT_COMMANDS, JOINT_POSITIONS
from quadruped_env.live.session import Session
from quadruped_env.live.single_publisher import SinglePublisherGuard
from quadruped_env.ros import cdr


class CommandPublisher:
    """Sends commands in one of two formats. All joint targets of all nodes go through it, and invalid ones no further.

    Args:
        driver: its joints are commanded.
        arrays: True for the format of ros2_control, which has no limp command.
        publishing: as for `SinglePublisherGuard`.

    Raises:
        QuadrupedError: if another process commands the robot already.
    """

    def __init__(
        self, session: Session, driver: Jointed, arrays: bool = False, publishing: Callable[[], bool] = lambda: True
    ) -> None:
        topic = JOINT_POSITIONS if arrays else JOINT_COMMANDS
        self.guard = SinglePublisherGuard(session, topic, publishing)
        """Watches for other publishers of commands."""
        self._arrays = arrays
        self._commands = session.node.publish(topic)
        self._driver = driver
        self._gate = TargetGate(driver.joint_names, session.say)
        self._last: Target = LIMP
        self._stamp = 0

    def send(self, stamp: int, target: Target) -> None:
        """Send joint targets, or `LIMP`, which an array cannot express: it is not sent.

        If targets are not finite, or too large, the last valid ones are sent again.

        Args:
            stamp: timestamp of the state that is answered, ns.
            target: for the driver's joints (D,), in its units.

        Raises:
            QuadrupedError: if targets were invalid for `INVALID_TIMEOUT`; `LIMP` was sent instead.
        """
        try:
            if target is not LIMP and not self._gate.passes(target, time.monotonic()):
                target = self._last
        except QuadrupedError:
            self._send(stamp, LIMP)
            raise
        self._send(stamp, target)

    def _send(self, stamp: int, target: Target) -> None:
        self._stamp, self._last = stamp, target
        if not self._arrays:
            self._commands.send_bytes(command_message(self._driver, stamp, target))
        elif target is not LIMP:
            self._commands.send(cdr.message(JOINT_POSITIONS.type_name, data=target))

    def let_go(self) -> None:
        """Let the robot go limp if it was ever commanded, and wait for the acknowledgement."""
        if self._stamp:
            self.send(self._stamp, LIMP)
            self._commands.wait_until_read(0.5)
