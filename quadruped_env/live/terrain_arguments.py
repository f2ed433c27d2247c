"""Arguments of the nodes that need the ground: the simulated robot, and the viewer that draws it."""

import argparse

from quadruped_env.simulation import TERRAINS, Terrain, find_terrain, flat
from quadruped_env.simulation.terrain import summary


def add_terrain_arguments(parser: argparse.ArgumentParser, seed: str) -> None:
    """Add `--terrain` and `--seed`; `chosen_terrain` reads them.

    Args:
        parser: parser of the node.
        seed: help for the seed.
    """
    parser.add_argument(
        "--terrain",
        choices=[entry.name for entry in TERRAINS],
        default=flat.name,
        help=f"the ground, level around the start: {summary()} (%(default)s)",
    )
    parser.add_argument("--seed", type=int, default=0, metavar="N", help=f"{seed} (%(default)s)")


def chosen_terrain(arguments: argparse.Namespace) -> Terrain:
    """The terrain that the arguments name."""
    return find_terrain(arguments.terrain).variant(arguments.seed)
