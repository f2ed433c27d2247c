"""Commands of `mini-quadruped`, and functions that run one."""

import argparse
import importlib
import shlex
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Final

from quadruped_env._python import SCRIPTS, pasteable
from quadruped_env.program import run_program

SUMMARIES: Final = {
    "train": "train a walking policy with PPO",
    "sweep": "train many policies at once: seeds of one config, or a search over its settings",
    "evaluate": "evaluate a policy against the scripted gaits, and write a report",
    "compare": "compare several policies on the same episodes",
    "sim2sim": "run a policy in a second physics engine, and measure what it loses there",
    "export": "write a policy as ONNX with a manifest, for a robot or a model hub",
    "view": "watch and steer the robot in a browser",
    "live": "run the robot on live ROS 2 topics, without a ROS installation",
    "convert": "convert a recording of joint states to another format",
    "replay": "play a recording again, and measure how closely the robot follows it",
    "identify": "fit the simulator's motors to a recording of a robot",
    "baseline": "measure a scripted gait, and record its joints",
    "tune-gait": "search the parameters of the scripted gaits",
    "completion": "print a script that completes these commands in a shell",
}
"""Summary of each command, in the order of `mini-quadruped --help`.

Each is a module of this package with a docstring (the description), `add_arguments(parser)` and
`run(arguments, invocation)`. They stand here as well so that `--help` need not import them.
"""


@dataclass(frozen=True)
class Invocation:
    """A program as it was started."""

    program: str
    """`mini-quadruped replay`."""
    arguments: tuple[str, ...]

    @property
    def line(self) -> str:
        """Command line that is recorded in results."""
        return shlex.join([*shlex.split(self.program), *self.arguments])


def command_module(name: str) -> ModuleType:
    """The module of a command of `SUMMARIES`."""
    return importlib.import_module(f"quadruped_env.cli.{name.replace('-', '_')}")


def describe(parser: argparse.ArgumentParser, module: ModuleType) -> None:
    """Give a parser the description and the arguments of a command."""
    parser.description = pasteable(module.__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    module.add_arguments(parser)


def run_module(module: ModuleType, prog: str, arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Run a command with parsed arguments.

    Args:
        module: module of the command.
        prog: name of the program in errors and warnings.
        arguments: parsed arguments.
        invocation: program and arguments as typed.

    Returns:
        Exit status: 0 for success, 2 after an error of this package, else that of the command.
    """
    return run_program(prog, lambda: int(module.run(arguments, invocation)))


def run_script(name: str, arguments: Sequence[str] | None = None) -> int:
    """Run a command as a script of the checkout: `python train/ppo.py` is `mini-quadruped train`.

    Args:
        name: name of the command.
        arguments: command-line arguments. None: those of the process.

    Returns:
        Exit status, as of `run_module`.
    """
    typed = tuple(sys.argv[1:] if arguments is None else arguments)
    module = command_module(name)
    parser = argparse.ArgumentParser()
    describe(parser, module)
    invocation = Invocation(f"python {SCRIPTS[name]}", typed)
    return run_module(module, parser.prog, parser.parse_args(typed), invocation)
