"""The option `--task` of nodes that need to know the robot."""

import argparse

from quadruped_env.control.task_file import load_robot
from quadruped_env.robot.robot import Robot


def add_robot_argument(parser: argparse.ArgumentParser) -> None:
    """Add `--task`: the file that defines another robot than the built-in one."""
    parser.add_argument(
        "--task",
        metavar="FILE",
        help="Python file that defines your robot or terrain (docs/make-it-yours.md); it is executed (default: the "
        "built-in ones)",
    )


def robot_of(arguments: argparse.Namespace) -> Robot:
    """The robot that `--task` names, or the built-in one.

    Raises:
        QuadrupedError: if the file cannot be read, raises an error, or defines more than one robot.
    """
    return load_robot(arguments.task)


def robot_arguments(arguments: argparse.Namespace) -> list[str]:
    """The option as given, for the nodes of a launch."""
    return [] if arguments.task is None else ["--task", arguments.task]
