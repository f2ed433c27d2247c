"""Check of the Python that a program runs under, and the commands that start it again.

It runs before anything else is imported, so it uses only the standard library, and syntax and functions of Python 3.6:
an older Python than the package needs gets a sentence, not a traceback.
"""

import os
import re
import shlex
import shutil
import sys
from importlib.machinery import PathFinder
from importlib.util import find_spec
from pathlib import Path

OLDEST = (3, 11)
_DISTRIBUTION = "mini-quadruped"
NEEDED = ("gymnasium", "mujoco", "numpy", "safetensors")
OLDEST_MUJOCO = (3, 17)

CPU_TORCH = "torch --index-url https://download.pytorch.org/whl/cpu"
"""Arguments of pip and uv: PyPI's build for Linux would bring 2.7 GB of CUDA."""
CPU_TORCH_EXTRAS = ("train", "contrib", "sweep", "test", "dev")
"""Extras that need torch."""

COMMAND = "mini-quadruped"
"""The installed command."""
_EXAMPLE = re.compile(rf"\b{COMMAND} (?=\w)")

_CHECKOUT = Path(__file__).resolve().parents[2]
"""Directory of a checkout's files; an installed package does not have them."""
_STARTED = getattr(sys, "orig_argv", [sys.executable, *sys.argv])
_LOST = sys.argv[:1] == ["-m"] and not hasattr(sys, "orig_argv")
"""True while `python -m` of a Python before 3.10 looks for a module of this package: its name is not in sys.argv."""


def check_python() -> None:
    """Make sure that this Python has what the package needs.

    A program of this project ends with a line on stderr and status 2 if not, as it does for other errors.

    Raises:
        ModuleNotFoundError: if something is missing; the message says which Python to use, or how to repair MuJoCo.
    """
    missing = [name for name in NEEDED if find_spec(name) is None]
    cure = ""
    if sys.version_info < OLDEST:
        lack = f"is Python {_dotted(sys.version_info[:2])}, and {_dotted(OLDEST)} or later is needed"
    elif missing:
        lack = "has no " + ", ".join(missing)
    else:
        lack = _lack_of_mujoco()
        if not lack:
            return
        # All its parts before one is installed: pip removes an older one last, with files of the new one.
        remove, install = pip_command("uninstall"), pip_command()
        cure = f"{remove} mujoco mujoco-core mujoco-studio && {install} 'mujoco>={_dotted(OLDEST_MUJOCO)}'"
    message = "{} {}; {}".format(sys.executable or "this Python", lack, cure or _cure())
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


def pip_command(action: str = "install") -> str:
    """Command that installs or uninstalls packages for this Python: pip, or uv where there is no pip."""
    # Not the general find_spec: asked for pip, setuptools' hook in it unloads distutils, with a warning.
    if PathFinder.find_spec("pip") is None:
        return f"uv pip {action} --python {python_command()}"
    return f"{python_command()} -m pip {action}" + (" -y" if action == "uninstall" else "")


def install_command(extra: str, portable: bool = False) -> str:
    """Command that installs an extra of this package, and torch's CPU build before it if it is needed.

    Args:
        extra: name of the extra.
        portable: True for a command without this machine's Python, for a page that is read elsewhere.
    """
    from importlib import metadata  # which takes longer to import than all the rest

    pip = "pip install" if portable else pip_command()
    package = f"'{_DISTRIBUTION}[{extra}]'"
    try:
        metadata.distribution(_DISTRIBUTION)
    except metadata.PackageNotFoundError:
        if has_programs() and not portable:
            # A checkout that was found without being installed.
            package = f"-e {shlex.quote(f'{_from_here(_CHECKOUT)}[{extra}]')}"
    torch = extra in CPU_TORCH_EXTRAS and (portable or find_spec("torch") is None)
    return (f"{pip} {CPU_TORCH} && " if torch else "") + f"{pip} {package}"


def pasteable(text: "str | None") -> str:
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
    again = _STARTED[1:] if _is_program() and not _LOST else []
    if own.exists() and not _is_same(own.parent, Path(sys.executable).parent):
        return f"run it with {_join([_from_here(own), *again])}"
    if has_programs():
        what = f", then run it with {_join([_from_here(own), *again])}" if again else ""
        place = _from_here(_CHECKOUT)
        make = "make install" if place == "." else f"make -C {shlex.quote(place)} install"
        return f"'{make}' creates one that has it{what}"
    return "install mini-quadruped for " + ("a later one" if sys.version_info < OLDEST else "it")


def _lack_of_mujoco() -> str:
    """Why the installed MuJoCo cannot be used, or nothing.

    Version 4 is split into several distributions. pip installs them next to an older version, and then removes the
    older one's files, which have the same names.
    """
    from importlib import metadata

    versions = {}
    for name in ("mujoco", "mujoco-core", "mujoco-studio"):
        try:
            versions[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            continue
    found = " and ".join(f"{name} {version}" for name, version in versions.items())
    if "mujoco" in versions:
        version = tuple(int(part) for part in versions["mujoco"].split(".")[:2])
        if version < OLDEST_MUJOCO:
            return f"has mujoco {versions['mujoco']}, and {_dotted(OLDEST_MUJOCO)} or later is needed"
        # Parts that an older version left behind do no harm: it has all files itself.
        if version >= (4, 0) and len(set(versions.values())) > 1:
            return f"has {found}, which do not fit together"
    spec = find_spec("mujoco")
    if spec is None or PathFinder.find_spec("mujoco._structs", spec.submodule_search_locations) is None:
        return f"has {found or 'mujoco'} with files missing"
    return ""


def _dotted(version: "tuple[int, int]") -> str:
    return "{}.{}".format(*version)


def _join(words: "list[str]") -> str:
    return " ".join(map(shlex.quote, words))  # shlex.join is of Python 3.8


def _is_program() -> bool:
    """True if one of this project's programs is being started."""
    if _LOST:
        return True
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
