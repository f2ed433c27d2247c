"""Print a script that completes commands, options and their values in a shell.

    mini-quadruped completion bash > ~/.local/share/bash-completion/completions/mini-quadruped
    mini-quadruped completion zsh > ~/.zfunc/_mini-quadruped       with fpath+=~/.zfunc before compinit in ~/.zshrc
    mini-quadruped completion fish > ~/.config/fish/completions/mini-quadruped.fish

It is fast, because it does not start Python: print it again after an update.
"""

import argparse
from pathlib import Path
from typing import Any, Final

from quadruped_env.cli.invocation import Invocation
from quadruped_env.gait import PRESETS
from quadruped_env.policies.files import SHIPPED
from quadruped_env.simulation import TERRAINS

SHELLS: Final = ("bash", "zsh", "fish")
_POLICIES: Final = ("run", "runs", "source", "sources", "policy")
"""Arguments that are a name or a path."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the shell."""
    parser.add_argument("shell", choices=SHELLS, metavar="SHELL", help=", ".join(SHELLS))


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Print the script."""
    import shtab

    from quadruped_env.cli.main import make_parser

    parser = make_parser()
    _add_values(parser)
    print(shtab.complete(parser, arguments.shell))
    return 0


def _add_values(parser: argparse.ArgumentParser) -> None:
    """Give the arguments of a parser and its commands the values and files that complete them."""
    import shtab

    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                _add_values(command)
        elif action.dest in _POLICIES:
            action.complete = _names_or_files(*SHIPPED, *PRESETS)  # type: ignore[attr-defined]
        elif action.dest == "terrain":
            action.choices = [terrain.name for terrain in TERRAINS]
        elif action.type is Path:
            action.complete = shtab.FILE  # type: ignore[attr-defined]


def _names_or_files(*names: str) -> dict[str, Any]:
    """Return names and files as shtab takes values: a function or an expression of each shell."""
    words = " ".join(dict.fromkeys(names))
    function = f'_mini_quadruped_policies() {{ compgen -W "{words}" -- "$1"; compgen -f -- "$1"; }}'
    return {
        "bash": "_mini_quadruped_policies",
        "zsh": f"{{compadd {words}; _files}}",
        "fish": f"{words} (__fish_complete_path (commandline -ct))",
        "preamble": {"bash": function},
    }
