"""Arguments of the nodes that need the ground: the simulated robot, and the viewer that draws it."""

import argparse

from quadruped_env.simulation import Terrain, find_terrain, flat
from quadruped_env.simulation.built_in_terrains import NAMES
from quadruped_env.simulation.terrain import LEVELS
from quadruped_env.task.task_definition import BUILT_IN, load_task_file
from quadruped_env.task.terrain_section import leg_scale


def add_terrain_arguments(parser: argparse.ArgumentParser, seed: str) -> None:
    """Add `--terrain`, `--level` and `--seed`; `chosen_terrain` reads them.

    Args:
        parser: parser of the node.
        seed: help for the seed.
    """
    parser.add_argument(
        "--terrain",
        metavar="NAME",
        default=flat.name,
        help=f"the ground: {NAMES} (docs/terrain.md), or one from --task's file (default: %(default)s)",
    )
    parser.add_argument(
        "--level",
        type=int,
        metavar="N",
        help=f"level of the terrain, from 1 to {LEVELS}, which is the hardest (default: none; docs/terrain.md)",
    )
    parser.add_argument("--seed", type=int, default=0, metavar="N", help=f"{seed} (default: %(default)s)")


def chosen_terrain(arguments: argparse.Namespace) -> Terrain:
    """The terrain that the arguments name.

    Raises:
        QuadrupedError: if there is no such terrain or level, or the file of `--task` cannot be loaded.
    """
    definition = BUILT_IN if arguments.task is None else load_task_file(arguments.task)
    terrain = find_terrain(arguments.terrain, definition.terrains)
    return terrain.variant(arguments.seed, arguments.level, leg_scale(definition.robot))
