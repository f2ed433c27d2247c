"""The nodes: one module per node, with a docstring, `add_arguments(parser)` and `run(session, arguments)`.

A node that starts other nodes has `start(arguments)` instead of `run`.
"""

import importlib
from types import ModuleType
from typing import Final

SUMMARIES: Final = {
    "display": "gait + state + viewer, like the tutorial's launch file",
    "walk": "sim + controller + state + viewer + teleop",
    "sim": "the simulated robot in real time",
    "gait": "a scripted gait on /joint_states, like the tutorial's publisher, or as commands",
    "state": "joint states in, transforms out, like robot_state_publisher",
    "controller": "a policy drives the robot: states and /cmd_vel in, joint commands out",
    "calibrate": "move a hanging robot's motors one after another, ask what moved, and write the map of --map",
    "view": "the live robot in the browser, with keys to steer it",
    "teleop": "drive the robot with the keyboard: /cmd_vel",
    "gamepad": "drive the robot with a gamepad or joystick: /cmd_vel, /estop",
    "echo": "print the messages of a topic",
    "list": "list topics, types, publishers and subscriptions",
    "hz": "measure the rate of messages",
    "record": "record topics into a bag",
}
"""Node -> summary, in the order of --help. Kept here so that running a node does not import the others."""
PRINTING: Final = ("echo", "hz")
"""Nodes whose only result is what they print, and which end when its reader does."""


def node_module(name: str) -> ModuleType:
    """The module of a node of `SUMMARIES`."""
    return importlib.import_module(f"{__name__}.{name}")
