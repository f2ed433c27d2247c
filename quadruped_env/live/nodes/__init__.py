"""The nodes. Each has a docstring, `add_arguments(parser)` and `run(session, arguments)`, as a module or a class.

A node that starts other nodes has `start(arguments)` instead of `run`.
"""

import importlib
from typing import Any, Final

SUMMARIES: Final = {
    "display": "gait + state + viewer, like the tutorial's launch file",
    "walk": "sim + controller + state + viewer + teleop",
    "sim": "the simulated robot in real time",
    "gait": "a scripted gait on /joint_states, like the tutorial's publisher",
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
_MODULES: Final = {
    **dict.fromkeys(("display", "walk"), "launch"),
    **dict.fromkeys(("echo", "list", "hz", "record"), "listen"),
}
"""Modules that hold several nodes, as classes."""


def node_module(name: str) -> Any:
    """Return the module or class of a node of `SUMMARIES`."""
    module = importlib.import_module(f"{__name__}.{_MODULES.get(name, name)}")
    return getattr(module, name.capitalize()) if name in _MODULES else module
