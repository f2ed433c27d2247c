"""Commands of `mini-quadruped`, and how one was started."""

import argparse
import importlib
import shlex
from dataclasses import dataclass
from types import ModuleType
from typing import Final

from quadruped_env.utils.files import shown_argument
from quadruped_env.utils.program import HelpFormatter

SUMMARIES: Final = {
    "demo": "see a trained robot walk, at once, in a page in your browser",
    "robot": "read your own robot from a URDF, a xacro file or an MJCF",
    "train": "train a walking policy with PPO",
    "sweep": "train many policies at once: seeds of one config, or a search over its settings",
    "evaluate": "evaluate a policy against the scripted gaits, and write a report",
    "compare": "compare several policies on the same episodes",
    "page": "write one HTML file in which a policy's robot walks in any browser",
    "export": "write a policy as ONNX with a manifest, for a robot or a model hub",
    "check-export": "compare runtimes, or a program of your own, with an export's golden trace",
    "import-policy": "make a policy of a zip of Stable-Baselines3, or of ONNX",
    "view": "watch and steer the robot in a browser",
    "live": "run the robot on live ROS 2 topics, without a ROS installation",
    "convert": "convert a recording of joint states to another format",
    "replay": "play a recording again, and measure how closely the robot follows it",
    "identify": "fit the simulator's motors to a recording of a robot",
    "baseline": "measure a scripted gait, and record its joints",
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
        """Command line that is recorded in results, without the directories of this machine."""
        return shlex.join([*shlex.split(self.program), *map(shown_argument, self.arguments)])


def command_module(name: str) -> ModuleType:
    """Return the module of a command of `SUMMARIES`."""
    return importlib.import_module(f"quadruped_env.cli.{name.replace('-', '_')}")


def describe(parser: argparse.ArgumentParser, module: ModuleType) -> None:
    """Give a parser the description and the arguments of a command."""
    parser.description = module.__doc__
    parser.formatter_class = HelpFormatter
    module.add_arguments(parser)
