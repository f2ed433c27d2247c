"""Drive the robot with the keyboard of this terminal: sends /cmd_vel.

    up, down      w, s    faster, slower or backwards    0.1 m/s per press
    left, right   a, d    turn to the left, the right    0.2 rad/s per press
                  , .     walk to the left, the right    0.1 m/s per press, if its legs can roll
    space                 stand
    q                     stand, and end

A command holds until the next one, because a terminal does not report key releases. It is sent at 10 Hz; when this
program ends or is killed, the controller makes the robot stand.
"""

import argparse

from quadruped_env.control.control_config import VELOCITIES
from quadruped_env.control.steering import FORWARD_STEP, TURN_STEP, Velocity, next_step
from quadruped_env.live.keyboard import DOWN, LEFT, RIGHT, UP, Keyboard
from quadruped_env.live.messages.steering_messages import velocity_message
from quadruped_env.live.middleware.topics import CMD_VEL
from quadruped_env.live.pace import Pace
from quadruped_env.live.session import POLL_PERIOD, Session

PERIOD = 0.1
"""Time between messages, s."""
STOP, END = " ", "q"
STEPS = {
    **dict.fromkeys((UP, "w"), (1, 0, 0)),
    **dict.fromkeys((DOWN, "s"), (-1, 0, 0)),
    **dict.fromkeys((LEFT, "a"), (0, 1, 0)),
    **dict.fromkeys((RIGHT, "d"), (0, -1, 0)),
    ",": (0, 0, 1),
    ".": (0, 0, -1),
}
"""Key -> steps of each velocity."""
SIZES = FORWARD_STEP, TURN_STEP, FORWARD_STEP
"""Change of each velocity by a step, m/s and rad/s."""
STAND: Velocity = (0.0, 0.0, 0.0)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add nothing: this node has no arguments of its own."""


def run(session: Session, arguments: argparse.Namespace) -> int:
    """Read keys until the session ends, then make the robot stand."""
    publisher = session.node.publish(CMD_VEL)
    command = STAND
    pace = Pace(PERIOD)
    with Keyboard() as keyboard:
        session.say("arrows or w a s d: walk and turn; , .: sideways; space: stand; q: end")
        for _ in session.turns(lambda: 0.0):
            keys = keyboard.pressed(min(pace.remaining, POLL_PERIOD))
            before = command
            for key in keys:
                command = after(command, key)
            if END in keys or keyboard.gone:
                break
            if command != before:
                left = f", {command[2]:+.1f} m/s to the left" if command[2] or before[2] else ""
                session.say(f"{command[0]:+.1f} m/s, {command[1]:+.1f} rad/s{left}")
            if pace.tick() or command != before:
                publisher.send(velocity_message(command))
            session.wait_for("" if publisher.readers else f"a subscription to {CMD_VEL.name}")
    publisher.send(velocity_message(STAND))
    publisher.wait_until_read(0.5)
    return 0


def after(command: Velocity, key: str) -> Velocity:
    """Return the command after a key press, clipped to the range that policies are trained for."""
    if key in (STOP, END):
        return STAND
    if key not in STEPS:
        return command
    ranges = [entry.range for entry in VELOCITIES]
    return tuple(
        min(max(next_step(value, size, steps), low), high)
        for value, size, steps, (low, high) in zip(command, SIZES, STEPS[key], ranges, strict=True)
    )
