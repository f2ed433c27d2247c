"""Nodes on live ROS 2 topics."""

import argparse

from quadruped_env.live.__main__ import add_nodes


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the nodes, each with its arguments. `quadruped_env.live.__main__.main` runs them."""
    add_nodes(parser)
