"""A user's Python file of terms and robots: executed only if the user names it."""

import functools
import hashlib
import importlib.util
import os
import sys
import traceback
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType
from typing import Any, ClassVar, Final, Self, TypeVar

from quadruped_env.control.control_config import VELOCITIES, Command
from quadruped_env.control.observations import OBSERVATIONS, ObservationField
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.description import description_problem
from quadruped_env.robot.mini_quadruped import MINI_QUADRUPED
from quadruped_env.robot.model_completion import read_files
from quadruped_env.robot.quadruped_design import QuadrupedDesign
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.documents import read_bytes
from quadruped_env.utils.plain import Plain
from quadruped_env.utils.provenance import TaskFile

Term = TypeVar("Term")


TASK_FILE: Final = "task_file"
"""Field of a config's plain values that names the user's file of terms."""
KEPT_FILE: Final = "task.py"
"""Copy of the user's file in a run, as data."""
_FILES: Final = "__read_files__"
"""Attribute of an executed file's module: the model files that it reads in its folder."""


@dataclass(frozen=True, eq=False)
class Terms:
    """Robot and terms of a policy that are not stored in its file: fields of the observation, and commands."""

    kinds: ClassVar[Mapping[str, type]] = {"observations": ObservationField, "commands": Command}
    """Class of the terms in each list."""

    observations: tuple[ObservationField, ...] = OBSERVATIONS
    commands: tuple[Command, ...] = VELOCITIES
    robot: Robot = MINI_QUADRUPED
    file: TaskFile | None = None
    """File that defines what is not built in."""
    path: str | None = None

    def extended(self, file: TaskFile, module: ModuleType) -> Self:
        """Return a copy with the terms and the robot that an executed file defines at its top level.

        A term replaces a built-in one of the same name; an observation whose name the file sets to None is left out.

        Raises:
            QuadrupedError: if the file defines several robots, or a term would replace only a part of a group of terms
                that are computed together.
        """
        values, path = vars(module), str(module.__file__)
        lists: dict[str, Any] = {name: getattr(self, name) for name in self.kinds}
        lists["observations"] = tuple(entry for entry in self.observations if values.get(entry.name, 0) is not None)
        try:
            for name, kind in self.kinds.items():
                lists[name] = merged(lists[name], [value for value in values.values() if isinstance(value, kind)])
        except QuadrupedError as error:
            raise QuadrupedError(f"{path}: {error}") from error
        return replace(self, robot=robot_in(module) or self.robot, file=file, path=path, **lists)


def load_terms(path: str | os.PathLike[str], expected: TaskFile | None = None) -> Terms:
    """Return the built-in terms and robot, extended by a user's file; see `Terms.extended` and `execute`."""
    return Terms().extended(*execute(path, expected))


def recorded_file(recorded: Plain, field: str = TASK_FILE) -> TaskFile | None:
    """Return the user's file that a field of a config's plain values names, by `name` and `sha256`; None for None.

    Raises:
        QuadrupedError: if it is something else.
    """
    if recorded is None:
        return None
    if not isinstance(recorded, dict) or not {"name", "sha256"} <= set(recorded):
        raise QuadrupedError(f"config.{field}: expected name and sha256; found {short(recorded)}")
    return TaskFile(str(recorded["name"]), str(recorded["sha256"]))


def recorded_terms(recorded: Mapping[str, Plain]) -> dict[str, list[str]]:
    """Return names of what the user's file that a config names defines, by kind; empty in configs of early versions."""
    terms = recorded.get("terms")
    if not isinstance(terms, dict) or not all(isinstance(names, list) for names in terms.values()):
        return {}
    return {kind: list(map(str, names)) for kind, names in terms.items()}


def kept_files(file: TaskFile | None) -> dict[str, bytes]:
    """Return name -> content of the copies in a run, from which the file can be executed again: none of no file."""
    return {} if file is None else {**file.beside, KEPT_FILE: file.content}


class TaskFileError(QuadrupedError):
    """The code of a user's file is needed."""


def needs_file(what: str, file: TaskFile) -> TaskFileError:
    """Return the error for something, in words, that needs the code of a user's file."""
    return TaskFileError(
        f"{what} from {short(file.name)}, which is not executed automatically: check the file, then name it with "
        f"--task FILE, or task_file=... in Python; --trust-task, or trust_task=True, executes the copy that a run keeps"
    )


def names_of(term: Plain) -> tuple[str, ...]:
    """Return the names of a term; most terms have one."""
    return tuple(term.names) if hasattr(term, "names") else (term.name,)


def merged(built_in: Sequence[Term], own: Sequence[Term]) -> tuple[Term, ...]:
    """Return the built-in terms followed by a user's terms; a user's term replaces a built-in one of the same name.

    Raises:
        QuadrupedError: if a term would replace only a part of a group of terms that are computed together.
    """
    terms = list(built_in)
    for term in own:
        if any(term is other for other in built_in):
            continue
        taken = [i for i, entry in enumerate(terms) if set(names_of(entry)) & set(names_of(term))]
        if not taken:
            terms.append(term)
        elif len(taken) == 1 and set(names_of(terms[taken[0]])) <= set(names_of(term)):
            terms[taken[0]] = term
        else:
            whole = " and ".join(" and ".join(names_of(terms[i])) for i in taken)
            raise QuadrupedError(
                f"{' and '.join(names_of(term))} would replace a part of {whole}, which are computed together; name "
                f"all of them, or choose another name and give the old one the weight 0"
            )
    return tuple(terms)


@functools.cache
def robot_in(module: ModuleType) -> Robot | None:
    """Return the robot of an executed file: a `Robot` or a `QuadrupedDesign` at its top level; None if there is none.

    It is built once, so that everything that names the file shares its compiled model.

    Raises:
        QuadrupedError: if there are several.
    """
    found: list[Robot] = []
    for value in vars(module).values():
        robot = value.robot() if isinstance(value, QuadrupedDesign) else value
        if isinstance(robot, Robot) and robot not in (MINI_QUADRUPED, *found):
            found.append(robot)
    if len(found) > 1:
        names = " and ".join(repr(robot.name) for robot in found)
        raise QuadrupedError(
            f"{module.__file__}: defines the robots {names}; a task has one robot, so keep one at the top level"
        )
    return next(iter(found), None)


def load_robot(path: str | os.PathLike[str] | None) -> Robot:
    """Return the robot that a user's file defines, or the built-in one for a file without robots or no file.

    The file's code is executed, so load only files that you trust.

    Raises:
        QuadrupedError: as `execute`, or if the file defines several robots.
    """
    return MINI_QUADRUPED if path is None else load_terms(path).robot


def execute(path: str | os.PathLike[str], expected: TaskFile | None = None) -> tuple[TaskFile, ModuleType]:
    """Execute a file of terms, once per process, path and content.

    Raises:
        QuadrupedError: if the file cannot be read, differs from the expected one, which is verified before anything is
            executed, or raises an error.
    """
    file = Path(path)
    content = read_bytes(file, "name the Python file of your terms")
    if file.suffix == ".json":  # whose content would be executed as an expression
        raise QuadrupedError(
            f"{file}: is a JSON file, and a Python file of terms is expected; changes of the config are for "
            f"'mini-quadruped train --task', and a run keeps them"
        )
    if problem := description_problem(content):
        raise QuadrupedError(f"{file}: {problem}")
    name = file.name if expected is None else expected.name
    found = TaskFile(name, hashlib.sha256(content).hexdigest(), content)
    if expected is not None and found.sha256 != expected.sha256:
        raise QuadrupedError(
            f"{file}: its SHA-256 is {found.sha256[:12]}..., and the task was made with {short(expected.name)} of "
            f"{short(expected.sha256)[:12]}...; name that version of the file with --task FILE"
        )
    module = _executed(file, content)
    return replace(found, beside=vars(module)[_FILES]), module


def _executed(file: Path, content: bytes) -> ModuleType:
    path = str(file.resolve())
    name = f"quadruped_env_task_{hashlib.sha256(os.fsencode(path) + content).hexdigest()[:16]}"
    if name in sys.modules:
        return sys.modules[name]
    spec = importlib.util.spec_from_loader(name, loader=None, origin=path)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    module.__file__ = path
    # Registered, because unpickling an env looks up the file's classes by their module.
    sys.modules[name] = module
    files: dict[Path, bytes] = {}
    token = read_files.set(files)
    try:
        # Compiled from the bytes that were hashed.
        exec(compile(content, path, "exec"), vars(module))  # noqa: S102
    except Exception as error:
        del sys.modules[name]
        frames = traceback.extract_tb(error.__traceback__)
        lines = [frame.lineno for frame in frames if frame.filename == path]
        line = lines[-1] if lines else getattr(error, "lineno", None)
        where = f", line {line}" if line else ""
        raise QuadrupedError(f"{file}{where}: {type(error).__name__}: {error}") from error
    finally:
        read_files.reset(token)
    folder = Path(path).parent
    found = {Path(os.path.abspath(name)): content for name, content in files.items()}
    vars(module)[_FILES] = {
        name.relative_to(folder).as_posix(): content for name, content in found.items() if name.is_relative_to(folder)
    }
    return module
