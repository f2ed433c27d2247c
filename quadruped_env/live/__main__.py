"""Run one node: `python -m quadruped_env.live NODE`, or `mini-quadruped live NODE`."""

import argparse
import inspect
import sys
from collections.abc import Sequence

from quadruped_env.live.nodes import SUMMARIES, node_module
from quadruped_env.live.session import Session, add_common_arguments
from quadruped_env.utils.interpreter import COMMAND
from quadruped_env.utils.program import ArgumentParser, HelpFormatter, run_program

_DESCRIPTION = "The robot on live ROS 2 topics, without a ROS installation."
_EPILOG = """\
Nodes discover each other, and the nodes of a ROS 2 installation, over DDS: same topics, types and QoS. ROS_DOMAIN_ID
selects the domain; without --subnet nothing leaves this machine. Ctrl-C ends a node. 'mini-quadruped live NODE --help'
describes each node.
"""


def make_parser(only: str | None = None) -> argparse.ArgumentParser:
    """Return the parser of the nodes' arguments.

    Args:
        only: the node whose arguments are needed; the other nodes get no arguments, and their modules are not imported.
    """
    parser = ArgumentParser(prog=f"{COMMAND} live")
    add_nodes(parser, only)
    return parser


def add_nodes(parser: argparse.ArgumentParser, only: str | None = None) -> None:
    """Add the description and the nodes to a parser; `only` as in `make_parser`."""
    parser.description = _DESCRIPTION
    parser.epilog = _EPILOG
    parser.formatter_class = HelpFormatter
    nodes = parser.add_subparsers(dest="node", metavar="NODE", required=True, title="nodes")
    for name, summary in SUMMARIES.items():
        node = nodes.add_parser(name, help=summary, formatter_class=HelpFormatter)
        if only in (None, name):
            module = node_module(name)
            node.description = inspect.cleandoc(module.__doc__)
            module.add_arguments(node)
            add_common_arguments(node)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the node that the arguments name, or print the help if there is none.

    Returns:
        The exit status: 0 on success, 2 after an error.
    """
    typed = list(sys.argv[1:] if arguments is None else arguments) or ["--help"]
    name = typed[0] if typed[0] in SUMMARIES else ""

    def run() -> int:
        # Only the node's own module is imported: faster start and less memory on a robot.
        parser = make_parser(only=name)
        args = parser.parse_args(typed)
        module = node_module(args.node)
        if hasattr(module, "start"):
            return int(module.start(args))
        with Session(args.node, args) as session:
            return int(module.run(session, args))

    return run_program(f"{COMMAND} live {name}".strip(), run)


if __name__ == "__main__":
    sys.exit(main())
