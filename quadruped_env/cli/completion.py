"""Print a script that completes commands, options and file names in a shell.

    mini-quadruped completion bash > ~/.local/share/bash-completion/completions/mini-quadruped
    mini-quadruped completion zsh > ~/.zfunc/_mini-quadruped       with ~/.zfunc in $fpath
    mini-quadruped completion tcsh > ~/.mini-quadruped.tcsh        which ~/.tcshrc sources

Print it again after an update. The completion is fast, because it does not start Python.
"""

import argparse
from pathlib import Path
from typing import Any, Final

from quadruped_env.cli.commands import Invocation

SHELLS: Final = ("bash", "zsh", "tcsh")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the shell."""
    parser.add_argument("shell", choices=SHELLS, metavar="SHELL", help=f"{', '.join(SHELLS[:-1])} or {SHELLS[-1]}")


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Print the script."""
    import shtab

    from quadruped_env.cli.main import make_parser

    parser = make_parser()
    _complete_files(parser, shtab.FILE)
    print(shtab.complete(parser, arguments.shell))
    return 0


def _complete_files(parser: argparse.ArgumentParser, files: Any) -> None:
    """Let every argument that is a path be completed with file names."""
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                _complete_files(command, files)
        elif action.type is Path:
            action.complete = files  # type: ignore[attr-defined]
