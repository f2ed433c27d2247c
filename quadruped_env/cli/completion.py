"""Print a script that completes commands, options and their values in a shell.

    mini-quadruped completion bash > ~/.local/share/bash-completion/completions/mini-quadruped
    mini-quadruped completion zsh > ~/.zfunc/_mini-quadruped       with fpath+=~/.zfunc before compinit in ~/.zshrc
    mini-quadruped completion fish > ~/.config/fish/completions/mini-quadruped.fish

It knows the policies, gaits, terrains and nodes of this version, and finds runs in the working directory. It is fast,
because it does not start Python: print it again after an update.
"""

import argparse
import re
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Final, NamedTuple

from quadruped_env.cli.invocation import Invocation
from quadruped_env.gait import PRESETS
from quadruped_env.policies.files import SHIPPED
from quadruped_env.simulation import TERRAINS
from quadruped_env.utils.interpreter import COMMAND
from quadruped_env.utils.program import HelpAll

SHELLS: Final = ("bash", "zsh", "fish")
_WORDS: Final = {
    "run": SHIPPED,
    "runs": SHIPPED,
    "sources": (*SHIPPED, *PRESETS),
    "policy": (*SHIPPED, *PRESETS),
    "terrain": [entry.name for entry in TERRAINS],
}
"""Values of arguments without choices, by their destination."""
_FOLDERS: Final = {"RUN": "runs", "SOURCE": "runs", "POLICY": "runs", "SWEEP": "sweeps"}
"""Directories whose entries are values, by an argument's metavar."""

# `current` is the unfinished word, `option` the one before it, `place` the command and node.
_FIND: Final = """\
    _mini_quadruped_values "$place $option" ||
        { [[ $current == -* ]] && _mini_quadruped_values "$place -"; } || _mini_quadruped_values "$place"
"""
# Not compgen -W, which would execute what a directory's name contains.
_BASH: Final = f"""\
_mini_quadruped() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} option=${{COMP_WORDS[COMP_CWORD - 1]}} place choices folder files found
    [[ $current == = ]] && current=
    [[ $option == = ]] && option=${{COMP_WORDS[COMP_CWORD - 2]}}
    ((COMP_CWORD > 1)) && place=${{COMP_WORDS[1]}}
    [[ $place == live ]] && ((COMP_CWORD > 2)) && place="live ${{COMP_WORDS[2]}}"
{_FIND}
    COMPREPLY=()
    for found in $choices; do
        [[ $found == "$current"* ]] && COMPREPLY+=("$found")
    done
    [[ $folder ]] && for found in "$folder"/*; do
        [[ -e $found && $found == "$current"* ]] && COMPREPLY+=("$(printf %q "$found")")
    done
    if [[ $files && ${{#COMPREPLY[@]}} == 0 ]]; then
        compopt -o filenames 2>/dev/null
        while IFS= read -r found; do COMPREPLY+=("$found"); done < <(compgen -f -- "$current")
    fi
}}
complete -F _mini_quadruped {COMMAND}"""
_ZSH: Final = f"""\
local current=$words[CURRENT] option=$words[CURRENT-1] place choices folder files
local -a found
((CURRENT > 2)) && place=$words[2]
[[ $place == live ]] && ((CURRENT > 3)) && place="live $words[3]"
if [[ $current == --*=* ]]; then
    option=${{current%%=*}} current=
    compset -P '*='
fi
{_FIND}
found=(${{=choices}})
[[ -n $folder ]] && found+=($folder/*(N))
compadd -- $found || {{ [[ -n $files ]] && _files }}"""
_FISH: Final = f"""\
function __mini_quadruped_at
    set -l typed (commandline -opc)
    set -e typed[1]
    string match -q -- $argv "$typed "
end
function __mini_quadruped_in
    for found in $argv/*/
        echo $found
    end
end
complete -c {COMMAND} -f"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the shell."""
    parser.add_argument("shell", choices=SHELLS, metavar="SHELL", help=", ".join(SHELLS))


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Print the script."""
    from quadruped_env.cli.main import make_parser

    parser = make_parser()
    if arguments.shell == "fish":
        print("\n".join([_FISH, *_fish_lines(parser)]))
    elif arguments.shell == "zsh":
        print(f"#compdef {COMMAND}\n{_values_function(parser)}\n{_ZSH}")
    else:
        print(f"{_values_function(parser)}\n{_BASH}")
    return 0


class _Values(NamedTuple):
    """Values that complete an argument."""

    words: tuple[str, ...] = ()
    folder: str = ""
    """Directory whose entries are values."""
    files: bool = False
    """Complete the names of files, if nothing else fits."""


def _values(*actions: argparse.Action) -> _Values:
    """Values of the arguments that may stand in one place."""
    words: dict[str, None] = {}
    folder, files = "", False
    for action in actions:
        metavar = str(action.metavar)
        words |= dict.fromkeys(map(str, action.choices or _WORDS.get(action.dest, ())))
        folder = _FOLDERS.get(metavar, folder)
        files = files or action.type is Path or metavar in {*_FOLDERS, "FILE", "TASK"}
    return _Values(tuple(words), folder, files)


def _parsers(parser: argparse.ArgumentParser, place: str = "") -> Iterator[tuple[str, argparse.ArgumentParser]]:
    """The parser, and those of its commands and their nodes, each with the words that lead to it."""
    yield place, parser
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for name, command in action.choices.items():
                yield from _parsers(command, f"{place} {name}".lstrip())


def _options(parser: argparse.ArgumentParser) -> dict[argparse.Action, str]:
    """The options of a parser, with their help."""
    hidden = dict(item for one in parser._actions if isinstance(one, HelpAll) for item in one.hidden.items())
    texts = {action: str(hidden.get(action, action.help)) for action in parser._actions if action.option_strings}
    return {action: text for action, text in texts.items() if text != argparse.SUPPRESS}


def _positional(parser: argparse.ArgumentParser) -> list[argparse.Action]:
    return [action for action in parser._actions if not action.option_strings]


def _values_function(parser: argparse.ArgumentParser) -> str:
    """A function for bash and zsh that sets `choices`, `folder` and `files` of a place, or fails if it has none."""
    places: dict[_Values, list[str]] = {}
    for place, command in _parsers(parser):
        options = _options(command)
        for action in options:
            if action.nargs != 0:
                places.setdefault(_values(action), []).extend(f"{place} {option}" for option in action.option_strings)
        names = _Values(tuple(option for action in options for option in action.option_strings))
        positional = _positional(command)
        places.setdefault(names, []).append(f"{place} -")
        places.setdefault(_values(*positional) if positional else names, []).append(place)
    lines = [
        f"    {'|'.join(map(shlex.quote, names))}) "
        f"choices={shlex.quote(' '.join(values.words))} folder={values.folder} files={'1' * values.files} ;;"
        for values, names in places.items()
    ]
    return "\n".join(["_mini_quadruped_values() {", '    case "$1" in', *lines, "    *) return 1 ;;", "    esac", "}"])


def _fish_lines(parser: argparse.ArgumentParser) -> Iterator[str]:
    def line(pattern: str, rest: str, values: _Values, text: str = "") -> str:
        words = [*values.words, *([f"(__mini_quadruped_in {values.folder})"] if values.folder else [])]
        about = re.split(r"[.,;:(]", text.replace("%%", "%"))[0].strip()
        parts = [f"complete -c {COMMAND} -n {_quoted(f'__mini_quadruped_at {_quoted(pattern)}')} {rest}"]
        parts += [f"-a {_quoted(' '.join(words))}"] if words else []
        parts += ["-F" if values.files else "-f"]
        return " ".join([*parts, *([f"-d {_quoted(about)}"] if about else [])])

    for place, command in _parsers(parser):
        children = [action for action in command._actions if isinstance(action, argparse._SubParsersAction)]
        pattern = f"{place} " if children else f"{place} *"
        for action, text in _options(command).items():
            names = [f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}" for name in action.option_strings]
            value = action.nargs != 0
            yield line(pattern, " ".join(names + ["-r"] * value), _values(action) if value else _Values(), text)
        for child in children:
            for choice in child._choices_actions:
                yield line(pattern, "", _Values((choice.dest,)), choice.help or "")
        if _positional(command) and not children:
            yield line(pattern, "", _values(*_positional(command)))


def _quoted(text: str) -> str:
    """A word of fish."""
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"
