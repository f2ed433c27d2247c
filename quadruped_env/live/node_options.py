"""Options of nodes that need to know the robot or the ground."""

import argparse
from typing import TYPE_CHECKING

from quadruped_env.control.task_file import load_robot
from quadruped_env.live.messages.driver_joints import add_map_argument
from quadruped_env.robot.robot import Robot

if TYPE_CHECKING:
    from quadruped_env.simulation import Terrain


def add_robot_argument(parser: argparse.ArgumentParser, joint_map: bool = True) -> None:
    """Add `--task`, the file that defines another robot than the built-in one, and by default also `--map`."""
    parser.add_argument(
        "--task",
        metavar="FILE",
        help="Python file that defines your robot or terrain (docs/make-it-yours.md); it is executed (default: the "
        "built-in ones)",
    )
    if joint_map:
        add_map_argument(parser)


def robot_of(arguments: argparse.Namespace) -> Robot:
    """Return the robot of `--task`, or the built-in one. Raises a QuadrupedError if the file defines none."""
    return load_robot(arguments.task)


def add_terrain_arguments(parser: argparse.ArgumentParser, seed: str) -> None:
    """Add `--terrain`, `--level` and `--seed`, with a help for the seed; `chosen_terrain` reads them."""
    from quadruped_env.simulation.built_in_terrains import NAMES, flat
    from quadruped_env.simulation.terrain import LEVELS

    parser.add_argument(
        "--terrain",
        metavar="NAME",
        default=flat.name,
        help=f"the ground: {NAMES} (docs/environment.md), or one from --task's file (default: %(default)s)",
    )
    parser.add_argument(
        "--level",
        type=int,
        metavar="N",
        help=f"level of the terrain, from 1 to {LEVELS}, which is the hardest (default: none; docs/environment.md)",
    )
    parser.add_argument("--seed", type=int, default=0, metavar="N", help=f"{seed} (default: %(default)s)")


def chosen_terrain(arguments: argparse.Namespace) -> "Terrain":
    """Return the terrain that the arguments name.

    Raises:
        QuadrupedError: if there is no such terrain or level, or the file of `--task` cannot be loaded.
    """
    from quadruped_env.simulation.built_in_terrains import find_terrain, terrain_scale
    from quadruped_env.task.task_definition import BUILT_IN, load_task_file

    definition = BUILT_IN if arguments.task is None else load_task_file(arguments.task)
    terrain = find_terrain(arguments.terrain, definition.terrains)
    return terrain.variant(arguments.seed, arguments.level, terrain_scale(terrain, definition.robot))
