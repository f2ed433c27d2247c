"""Run one node: `python -m quadruped_env.live NODE`."""

import argparse
import os
import sys
from collections.abc import Sequence

from quadruped_env._python import pasteable
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.live.nodes import MODULES, node_module
from quadruped_env.live.session import Session, add_common_arguments

_EPILOG = """\
Nodes meet on DDS as those of ROS 2 do, each other and those of a ROS 2 installation: the same topics, types and
qualities of service. ROS_DOMAIN_ID says on which domain; nothing leaves this machine without --subnet. Ctrl-C ends a
node. 'python -m quadruped_env.live NODE --help' says more.
"""


def make_parser() -> argparse.ArgumentParser:
    """The parser of all nodes' arguments."""
    parser = argparse.ArgumentParser(
        prog=pasteable("python -m quadruped_env.live"),
        description="The robot on live ROS 2 topics, without a ROS installation.",
        epilog=pasteable(_EPILOG),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    nodes = parser.add_subparsers(dest="node", metavar="NODE", required=True)
    for name in MODULES:
        module = node_module(name)
        node = nodes.add_parser(
            name,
            help=module.SUMMARY,
            description=pasteable(module.__doc__),
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        module.add_arguments(node)
        add_common_arguments(node)
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the node that the arguments name; 0 if it ended well, 2 if it could not do what was asked."""
    args = make_parser().parse_args(arguments)
    try:
        module = node_module(args.node)
        if hasattr(module, "start"):
            return int(module.start(args))
        with Session(args.node, args) as session:
            return int(module.run(session, args))
    except (QuadrupedError, MissingExtraError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        # Whoever read what is printed has gone; Python would find that out again when it ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
