"""Check of the Python that a program runs under, and the commands that start it again.

It runs before anything else is imported, so it uses only the standard library and syntax that an old Python accepts.
"""

import os
import re
import shlex
import shutil
import sys
from importlib.util import find_spec
from pathlib import Path

OLDEST = (3, 11)
_DISTRIBUTION = "mini-quadruped"
NEEDED = ("gymnasium", "mujoco", "numpy", "safetensors")

COMMAND = "mini-quadruped"
"""The installed command."""
_EXAMPLE = re.compile(rf"\b{COMMAND} (?=\w)")

_CHECKOUT = Path(__file__).resolve().parents[1]
"""Directory of a checkout's files; an installed package does not have them."""
_STARTED = getattr(sys, "orig_argv", [sys.executable, *sys.argv])


def check_python() -> None:
    """Make sure that this Python has what the package needs.

    A program of this project ends with a line on stderr and status 2 if not, as it does for other errors.

    Raises:
        ModuleNotFoundError: if something is missing; the message says which Python to use.
    """
    missing = [name for name in NEEDED if find_spec(name) is None]
    if sys.version_info < OLDEST:
        lack = "is Python {}.{}, and {}.{} or later is needed".format(*sys.version_info[:2], *OLDEST)
    elif missing:
        lack = "has no " + ", ".join(missing)
    else:
        return
    message = "{} {}; {}".format(sys.executable or "this Python", lack, _cure())
    if _is_program():
        print(f"error: {message}", file=sys.stderr)
        raise SystemExit(2)
    raise ModuleNotFoundError(message, name=missing[0] if missing else None)


def python_command() -> str:
    """Command that starts this Python: `python` if that is the same one, otherwise its path."""
    found = shutil.which("python")
    if not sys.executable or (found and _is_same(Path(found).parent, Path(sys.executable).parent)):
        return "python"
    return shlex.quote(_from_here(Path(sys.executable)))


def program_command(name: str, *arguments: object) -> str:
    """A command that runs a program of this package from here.

    Args:
        name: of the subcommand, such as `train`, or `live`.
        arguments: of the program.
    """
    return " ".join([_command(), name, *(shlex.quote(str(argument)) for argument in arguments)])


def module_command(module: str, *arguments: object) -> str:
    """A command that runs a module that is installed."""
    return f"{python_command()} -m {shlex.join([module, *map(str, arguments)])}"


def has_programs() -> bool:
    """True if the programs are next to the package, as in a checkout."""
    return (_CHECKOUT / "pyproject.toml").is_file() and (_CHECKOUT / "train").is_dir()


def pip_command() -> str:
    """Command that installs packages for this Python."""
    return f"{python_command()} -m pip install"


def install_command(extra: str) -> str:
    """Command that installs an extra of this package for this Python."""
    from importlib import metadata  # which takes longer to import than all the rest

    try:
        metadata.distribution(_DISTRIBUTION)
    except metadata.PackageNotFoundError:
        if has_programs():
            # A checkout that was found without being installed.
            return f"{pip_command()} -e {shlex.quote(f'{_from_here(_CHECKOUT)}[{extra}]')}"
    return f"{pip_command()} '{_DISTRIBUTION}[{extra}]'"


def pasteable(text: str | None) -> str:
    """A text, such as a command's docstring, with examples such as `mini-quadruped train` ready to paste."""
    return _EXAMPLE.sub(lambda _: _command() + " ", text or "")


def _command() -> str:
    """`mini-quadruped` if the PATH has this Python's, else its path, else what works without an installation."""
    here = Path(sys.executable).parent
    found = shutil.which(COMMAND)
    if found and _is_same(Path(found).parent, here):
        return COMMAND
    script = here / COMMAND
    if script.is_file():
        return shlex.quote(_from_here(script))
    if has_programs() and not _is_same(Path.cwd(), _CHECKOUT):
        return f"{python_command()} {shlex.quote(_from_here(_CHECKOUT / 'quadruped_env'))}"
    return module_command("quadruped_env")


def _started_module() -> str:
    """The module after `python -m`, or nothing."""
    return _STARTED[_STARTED.index("-m") + 1] if "-m" in _STARTED[:-1] else ""


def _cure() -> str:
    own = _CHECKOUT / (".venv/Scripts/python.exe" if os.name == "nt" else ".venv/bin/python")
    again = _STARTED[1:] if _is_program() else []
    if own.exists() and not _is_same(own.parent, Path(sys.executable).parent):
        return f"run it with {shlex.join([_from_here(own), *again])}"
    if has_programs():
        what = f", then run it with {shlex.join([_from_here(own), *again])}" if again else ""
        place = _from_here(_CHECKOUT)
        make = "make install" if place == "." else f"make -C {shlex.quote(place)} install"
        return f"'{make}' creates one that has it{what}"
    return "install mini-quadruped for it"


def _is_program() -> bool:
    """True if one of this project's programs is being started."""
    if _started_module():
        return _started_module().split(".")[0] == "quadruped_env"
    main = getattr(sys.modules.get("__main__"), "__file__", None)
    if main is None:
        return False
    folders = [_CHECKOUT / folder for folder in ("train", "evaluate", "tools", "quadruped_env")]
    return Path(main).stem == COMMAND or Path(main).resolve().parent in folders


def _is_same(one: Path, other: Path) -> bool:
    try:
        return one.samefile(other)
    except OSError:
        return False


def _from_here(path: Path) -> str:
    """A path from the working directory on where it is below it, and as it is elsewhere."""
    relative = os.path.relpath(path, _real_cwd(path))
    return str(path) if relative.startswith("..") else relative


def _real_cwd(path: Path) -> Path:
    # The checkout's path is resolved, the interpreter's is not: its directory may be a link.
    here = Path.cwd()
    resolved = here.resolve()
    return resolved if resolved in path.parents else here
