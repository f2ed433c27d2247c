"""A user's own algorithm or policy class, `my_algorithm.py:MyPPO`: executed only where the user names it."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from quadruped_env.control.task_file import execute
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.utils.provenance import TaskFile

OPTIONS: Final = ("algo", "policy")
"""Fields of `TrainConfig` that may name such a class."""
RECORDED: Final = "user_code"
"""Field of a run's config and card with the files of these classes."""


def is_user_class(text: str) -> bool:
    """True for `FILE.py:NAME`."""
    return ".py:" in text


def recorded_name(text: str) -> str:
    """The name of an algorithm or class in a run's files, without the directory of its file."""
    return Path(text).name if is_user_class(text) else text


def absolute_name(text: str) -> str:
    """The name of an algorithm or class for processes in other working directories."""
    return str(Path(text).resolve()) if is_user_class(text) else text


def load_class(option: str, text: str) -> tuple[TaskFile, type[Any]]:
    """A file, which is executed, and the class in it that a user names.

    Args:
        option: the field, for the message.
        text: `FILE.py:NAME`.

    Raises:
        QuadrupedError: if the file cannot be executed, or has no such class.
    """
    path, _, name = text.rpartition(":")
    file, module = execute(path)
    kind = getattr(module, name, None)
    if not isinstance(kind, type):
        raise QuadrupedError(f"--{option}: {path} defines no class {short(name)}; write --{option} FILE.py:CLASS")
    return file, kind


def recorded(values: Mapping[str, Any]) -> dict[str, dict[str, str]]:
    """Name and SHA-256 of the files of the classes in a training's settings, by field; they are executed."""
    named = {option: values[option] for option in OPTIONS if is_user_class(values[option])}
    return {option: load_class(option, text)[0].to_dict() for option, text in named.items()}


def changes(before: Any, values: Mapping[str, Any]) -> str:
    """Differences of the code of a resumed training from that of its run, in a sentence; empty without differences.

    Args:
        before: a run's `RECORDED` field, of any value.
        values: settings of the resumed training.
    """
    known = before if isinstance(before, dict) else {}
    differing = {  # both classes may be of one file
        file["name"]: None
        for option, file in recorded(values).items()
        if not isinstance(known.get(option), dict) or known[option].get("sha256") != file["sha256"]
    }
    return f"the code of {' and '.join(differing)} differs from the run's" if differing else ""
