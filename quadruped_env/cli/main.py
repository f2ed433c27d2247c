"""The command `mini-quadruped`."""

import argparse
import sys
from collections.abc import Sequence

from quadruped_env._version import __version__
from quadruped_env.cli.invocation import SUMMARIES, Invocation, command_module, describe
from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.interpreter import COMMAND
from quadruped_env.utils.program import ArgumentParser, HelpFormatter, run_program

_DESCRIPTION = """\
A four-legged robot that learns to walk: train it, evaluate it, watch it, record it, and run it on ROS 2 topics.
"""
_EPILOG = f"""\
first steps:
  {COMMAND} demo                 a robot that walks in your browser, at once
  {COMMAND} train                a policy that walks, after about two minutes
  {COMMAND} evaluate             its report, against the scripted gaits
  {COMMAND} view                 the robot in a browser

'{COMMAND} COMMAND --help' describes each command.
"""


def make_parser(only: str | None = None) -> argparse.ArgumentParser:
    """Return the parser of `mini-quadruped`; with `only`, no module of the other commands is imported."""
    parser = ArgumentParser(prog=COMMAND, description=_DESCRIPTION, epilog=_EPILOG, formatter_class=HelpFormatter)
    parser.add_argument("--version", action="version", version=f"{COMMAND} {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True, title="commands")
    for name, summary in SUMMARIES.items():
        command = commands.add_parser(name, help=summary)
        if only in (None, name):
            describe(command, command_module(name))
            command.set_defaults(in_options=command.in_options)
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command that the arguments name, or print the help if there is none; the exit status."""
    typed = list(sys.argv[1:] if arguments is None else arguments) or ["--help"]
    name = typed[0] if typed and typed[0] in SUMMARIES else ""
    if name == "live":
        # Its nodes have commands of their own, of which only one is imported.
        from quadruped_env.live.__main__ import main as run_node

        return run_node(typed[1:])
    invocation = Invocation(f"{COMMAND} {name}".strip(), tuple(typed[1:]))

    def run() -> int:
        args = make_parser(only=name).parse_args(typed)
        try:
            return int(command_module(name).run(args, invocation))
        except QuadrupedError as error:
            # Only here fields have options: the package names fields, also to callers in Python.
            raise QuadrupedError(args.in_options(str(error))) from error

    return run_program(invocation.program, run)
