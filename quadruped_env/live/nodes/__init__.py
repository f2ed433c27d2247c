"""The nodes: one module per node, with a docstring, `add_arguments(parser)` and `run(session, arguments)`.

One that starts other nodes has `start(arguments)` in place of `run`.
"""

import importlib
from types import ModuleType
from typing import Final

SUMMARIES: Final = {
    "display": "gait + state + viewer, as the tutorial's launch file",
    "walk": "sim + controller + state + viewer + teleop",
    "sim": "the simulated robot in real time",
    "gait": "a scripted gait on /joint_states, as the tutorial's publisher, or as commands",
    "state": "joint states in, transforms out: robot_state_publisher's job",
    "controller": "a policy drives the robot: states and /cmd_vel in, joint commands out",
    "view": "the live robot in the browser, with keys that steer it",
    "teleop": "drive the robot with the keyboard: /cmd_vel",
    "echo": "print the messages of a topic",
    "list": "list the topics, their types, and who publishes and subscribes",
    "hz": "measure how often messages come",
    "record": "record topics into a bag",
}
"""Node -> one line about it, in the order of --help. They stand here so that a node is run without importing others."""


def node_module(name: str) -> ModuleType:
    """The module of a node of `SUMMARIES`."""
    return importlib.import_module(f"{__name__}.{name}")
