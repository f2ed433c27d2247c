"""Process in which a xacro file is expanded.

The library's own evaluator runs Python expressions whose nested code it does not check, and `$(eval)`, `$(env)` and
`$(find)` read the environment. Here expressions are arithmetic, and only files in the given folders are read.
"""

import sys
from pathlib import Path
from typing import Any
from xml.dom import minidom

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.importer.arithmetic import check_arithmetic
from quadruped_env.importer.files import Folders
from quadruped_env.importer.xacro_file import REFUSED
from quadruped_env.importer.xml_tree import parse, read_bytes

_MEMORY = 2_000_000_000
"""Maximum memory of the process, bytes."""
_SECONDS = 50
"""Maximum processor time of the process, s."""


def main() -> int:
    """Write the URDF of a xacro file to stdout, or why there is none; the arguments are the file and its folders."""
    _limit()
    path, *given = map(Path, sys.argv[1:])
    try:
        text = expand(path, Folders(tuple(given), path))
    except RecursionError:
        text = "macros or properties refer to each other without an end"
    except Exception as error:
        text = line(error)
    else:
        sys.stdout.buffer.write(text.encode())
        return 0
    sys.stdout.buffer.write(text.encode(errors="replace"))
    return REFUSED


def _limit() -> None:
    try:
        import resource
    except ModuleNotFoundError:  # Windows, where the time limit remains
        return
    for kind, most in ((resource.RLIMIT_AS, _MEMORY), (resource.RLIMIT_CPU, _SECONDS), (resource.RLIMIT_FSIZE, 0)):
        try:
            resource.setrlimit(kind, (most, most))
        except (ValueError, OSError):
            continue


def line(error: Exception) -> str:
    """Return the message of the error that the library has wrapped, on one line."""
    while isinstance(getattr(error, "exc", None), Exception):
        error = error.exc  # type: ignore[attr-defined]
    return " ".join(str(error).split()) or type(error).__name__


def expand(path: Path, folders: Folders) -> str:
    """Return the URDF of a xacro file; the library is restricted from then on."""
    import xacro
    from xacro import substitution_args

    _restrict(xacro, substitution_args, folders)
    xacro.verbosity = 0
    document = xacro.process_file(str(path.resolve()), mappings={})
    text: str = document.toxml()
    return text


def _restrict(xacro: Any, substitution_args: Any, folders: Folders) -> None:
    """Replace what the library evaluates, opens and looks up."""

    def inside(name: str) -> Path:
        place = Path(name)
        if not folders.contain(place):
            raise QuadrupedError(
                f"{short(name)} is outside the folders that are searched; name its folder with --folder"
            )
        return place

    def parsed(content: Any, filename: str | None = None) -> minidom.Document:
        place = inside(str(filename))
        data = read_bytes(place, "name a xacro file")
        parse(data, place.name)  # refuses entities, which minidom would expand
        return minidom.parseString(data)  # noqa: S318

    def load_yaml(name: str) -> Any:
        import yaml

        data = read_bytes(inside(xacro.abs_filename_spec(name)), "name a YAML file", 1_000_000)
        return xacro.YamlListWrapper.wrap(yaml.safe_load(data))

    def refused(name: str) -> Any:
        def refuse(*_: Any, **__: Any) -> None:
            raise QuadrupedError(
                f"$({name} ...) runs code or reads the environment, and is not evaluated; write its value"
            )

        return refuse

    evaluate = xacro.safe_eval

    def checked(text: str, symbols: Any, *rest: Any) -> Any:
        check_arithmetic(text)
        return evaluate(text, symbols, *rest)

    xacro.parse, xacro.safe_eval = parsed, checked
    xacro._global_symbols["load_yaml"] = xacro._global_symbols["xacro"]["load_yaml"] = load_yaml
    substitution_args._eval_find = lambda name: str(folders.package(name))
    substitution_args._eval = refused("eval")
    substitution_args._eval_env = refused("env")
    substitution_args._eval_optenv = lambda name, default="": default


if __name__ == "__main__":
    sys.exit(main())
