"""Commands that programs print, ready to paste."""

import os
import shlex
import shutil
import sys
from pathlib import Path
from typing import Final

CPU_TORCH: Final = "torch --index-url https://download.pytorch.org/whl/cpu"
"""Arguments of pip and uv: PyPI's build for Linux would bring 2.7 GB of CUDA."""
CPU_TORCH_EXTRAS: Final = ("train", "contrib", "sweep", "ray", "test", "dev")
"""Extras that need torch."""
COMMAND: Final = "mini-quadruped"
"""The installed command, and the name of the distribution."""


def program_command(name: str, *arguments: object) -> str:
    """Return a command that runs a program of this package under this Python.

    Args:
        name: of the subcommand, such as `train`, or `live`.
        arguments: of the program.
    """
    script = Path(sys.executable).with_name(COMMAND)
    if shutil.which(COMMAND) == str(script):
        command = [COMMAND]
    elif script.is_file():
        command = [_from_here(script)]
    else:  # a checkout that is not installed
        command = [_from_here(Path(sys.executable)), _from_here(Path(__file__).resolve().parents[1])]
    return shlex.join([*command, name, *map(str, arguments)])


def module_command(module: str, *arguments: object) -> str:
    """Return a command that runs an installed module under this Python."""
    return shlex.join([_from_here(Path(sys.executable)), "-m", module, *map(str, arguments)])


def install_command(extra: str) -> str:
    """Return a command that installs an extra of this package, and torch's CPU build before it if it is needed."""
    torch = f"pip install {CPU_TORCH} && " if extra in CPU_TORCH_EXTRAS else ""
    return f"{torch}pip install '{COMMAND}[{extra}]'"


def _from_here(path: Path) -> str:
    """Return a path from the working directory on where it is below it, and as it is elsewhere."""
    relative = os.path.relpath(path, Path.cwd())
    return str(path) if relative.startswith("..") else relative
