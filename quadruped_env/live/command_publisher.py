"""Publisher of commands to the driver of a robot."""

from quadruped_env.control.joint_command import LIMP, Target
from quadruped_env.live.messages.joint_messages import Jointed, command_message, positions_message
from quadruped_env.live.middleware.node import Node
from quadruped_env.live.middleware.topics import JOINT_COMMANDS, JOINT_POSITIONS


class CommandPublisher:
    """Sends commands in one of two formats.

    Args:
        node: the publishing node.
        driver: its joints are commanded.
        arrays: True for the format of ros2_control, which has no limp command.
    """

    def __init__(self, node: Node, driver: Jointed, arrays: bool) -> None:
        self._arrays = arrays
        self._commands = node.publish(JOINT_POSITIONS if arrays else JOINT_COMMANDS)
        self._driver = driver
        self._stamp = 0

    def send(self, stamp: int, target: Target) -> None:
        """Send joint targets, or `LIMP`, which an array cannot express: it is not sent.

        Args:
            stamp: timestamp of the state that is answered, ns.
            target: for the driver's joints (D,), in its units.
        """
        self._stamp = stamp
        if not self._arrays:
            self._commands.send_bytes(command_message(self._driver, stamp, target))
        elif target is not LIMP:
            self._commands.send(positions_message(target))

    def let_go(self) -> None:
        """Let the robot go limp if it was ever commanded, and wait for the acknowledgement."""
        if self._stamp:
            self.send(self._stamp, LIMP)
            self._commands.wait_until_read(0.5)
