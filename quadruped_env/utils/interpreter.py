"""Commands for the Python that a program runs under, ready to paste."""

import os
import re
import shlex
import shutil
import sys
from importlib import metadata
from importlib.machinery import PathFinder
from pathlib import Path
from typing import Final

CPU_TORCH: Final = "torch --index-url https://download.pytorch.org/whl/cpu"
"""Arguments of pip and uv: PyPI's build for Linux would bring 2.7 GB of CUDA."""
CPU_TORCH_EXTRAS: Final = ("train", "contrib", "sweep", "ray", "test", "dev")
"""Extras that need torch."""
COMMAND: Final = "mini-quadruped"
"""The installed command, and the name of the distribution."""
_EXAMPLE: Final = re.compile(rf"\b{COMMAND} (?=\w)")
_CHECKOUT: Final = Path(__file__).resolve().parents[2]
"""Directory of a checkout's files; an installed package does not have them."""


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


def pip_command() -> str:
    """Command that installs packages for this Python: pip, or uv where there is no pip."""
    # Not the general find_spec: asked for pip, setuptools' hook in it unloads distutils, with a warning.
    if PathFinder.find_spec("pip") is None:
        return f"uv pip install --python {python_command()}"
    return f"{python_command()} -m pip install"


def install_command(extra: str, portable: bool = False) -> str:
    """Command that installs an extra of this package, and torch's CPU build before it if it is needed.

    Args:
        extra: name of the extra.
        portable: True for a command without this machine's Python, for a page that is read elsewhere.
    """
    pip = "pip install" if portable else pip_command()
    package = f"'{COMMAND}[{extra}]'"
    if not (portable or _is_installed()):
        package = f"-e {shlex.quote(f'{_from_here(_CHECKOUT)}[{extra}]')}"
    torch = extra in CPU_TORCH_EXTRAS and (portable or PathFinder.find_spec("torch") is None)
    return (f"{pip} {CPU_TORCH} && " if torch else "") + f"{pip} {package}"


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
    if _is_installed() or _is_same(Path.cwd(), _CHECKOUT):
        return module_command("quadruped_env")
    return f"{python_command()} {shlex.quote(_from_here(_CHECKOUT / 'quadruped_env'))}"


def _is_installed() -> bool:
    """False for a checkout that was found without being installed."""
    try:
        metadata.distribution(COMMAND)
    except metadata.PackageNotFoundError:
        return not (_CHECKOUT / "pyproject.toml").is_file()
    return True


def _is_same(one: Path, other: Path) -> bool:
    try:
        return one.samefile(other)
    except OSError:
        return False


def _from_here(path: Path) -> str:
    """A path from the working directory on where it is below it, and as it is elsewhere."""
    here = Path.cwd()
    # The checkout's path is resolved, the interpreter's is not: its directory may be a link.
    here = here.resolve() if here.resolve() in path.parents else here
    relative = os.path.relpath(path, here)
    return str(path) if relative.startswith("..") else relative
