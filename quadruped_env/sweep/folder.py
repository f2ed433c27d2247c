"""A sweep: its definition, its files, and the locks by which its workers share them.

    sweep.json                definition
    task.py                   copy of the user's task file, if there is one
    worker.json               versions of the first worker's package and libraries; all others need the same
    optuna.log                study of Optuna, if fields vary
    trials/0007/<time>-ppo/   run directory of a trial; one more each time that the trial went on from a checkpoint
    trials/0007/result.json   result; a trial without one is open
    locks/                    locks; the system releases a lock when the process that holds it ends

A sweep goes on from these files alone, and nothing is unpickled.
"""

import math
import os
import time
import uuid
from collections.abc import Generator, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from quadruped_env.control.task_file import KEPT_FILE, kept_files
from quadruped_env.envs.arguments import changed, task_config
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot import asset_path
from quadruped_env.sweep.space import TASK, ends, in_words, optuna_module, size
from quadruped_env.task import BUILT_IN, TaskDefinition, load_task_file
from quadruped_env.training import TrainConfig
from quadruped_env.training.recipes import with_recipe
from quadruped_env.training.train_config import check_fields
from quadruped_env.utils.documents import read_json
from quadruped_env.utils.files import free_path, write_json, write_whole
from quadruped_env.utils.locks import check_locks, file_lock
from quadruped_env.utils.plain import plain
from quadruped_env.utils.provenance import TaskFile, circumstances, package_hash, versions
from quadruped_env.utils.seeds import check_training_seeds

FORMAT_VERSION: Final = 2
SWEEP_FILE: Final = "sweep.json"
STORAGE: Final = "OPTUNA_STORAGE"
"""Optuna's environment variable for the address of a database. It may hold a password, so no file keeps it."""
MAX_TRIALS: Final = 100_000
_POLL: Final = 1.0
"""Time between two checks of the trials that other workers do, s."""


@dataclass(frozen=True)
class Sweep:
    """Settings, each of which is trained with every seed. A trial is one training."""

    path: Path
    training: dict[str, Any]
    """Fields of `TrainConfig` that all trials share; `task` holds changes to its config."""
    whole: tuple[str, ...] = ()
    """Sections of the task's config that are set as a whole and replace the recipe's."""
    space: Mapping[str, Any] = field(default_factory=dict)
    """Field that varies -> its distribution."""
    settings: int = 1
    """Number of settings."""
    seeds: int = 1
    """Seeds of each setting, from `training["seed"]` on."""
    study: str = ""
    """Name of the study in Optuna's storage."""
    in_database: bool = False
    """True if the study is in the database that `STORAGE` names, and not in the directory."""
    task_file: TaskFile | None = None
    """The user's task file; the directory has a copy."""

    def __post_init__(self) -> None:
        for name, count in (("seeds", self.seeds), ("trials", self.settings)):
            if not 1 <= count <= MAX_TRIALS or self.seeds * self.settings > MAX_TRIALS:
                raise QuadrupedError(f"sweep.{name}: expected 1 to {MAX_TRIALS:,} trainings in all; found {count:,}")
        if self.settings > self.size:
            raise QuadrupedError(
                f"sweep.trials: found {self.settings}, but a setting is tried once, and there are {self.size:g}; lower "
                f"it, vary more, or give more --seeds"
            )
        check_fields({**self.training, "seed": self.first_seed + self.seeds - 1})
        num_envs = self.training.get("num_envs", TrainConfig.num_envs)
        check_training_seeds("seeds", self.first_seed, self.seeds - 1 + num_envs)

    @property
    def size(self) -> float:
        """Return the number of different settings in the space."""
        return math.prod(map(size, self.space.values()))

    @property
    def first_seed(self) -> int:
        """Return the seed of the first training of each setting."""
        return int(self.training.get("seed", TrainConfig.seed))

    def __len__(self) -> int:
        """Return the number of trials."""
        return self.settings * self.seeds

    def __str__(self) -> str:
        """Return the definition in a line."""
        seeds = f"{self.seeds} seed{'s' * (self.seeds > 1)}"
        if not self.space:
            return f"{seeds} of one config"
        return f"{self.settings} settings of {', '.join(self.space)}, each with {seeds}"

    def setting(self, number: int) -> int:
        """Return the setting of a trial; all seeds of the first setting come first."""
        return number // self.seeds

    def seed(self, number: int) -> int:
        """Return the seed of a trial."""
        return self.first_seed + number % self.seeds

    def config(self, values: Mapping[str, Any], seed: int, definition: TaskDefinition = BUILT_IN) -> TrainConfig:
        """Return the settings of a training.

        Args:
            values: field of the space -> value.
            seed: seed of the training.
            definition: what the user's task file defines.

        Raises:
            QuadrupedError: if a value is not valid, or values do not fit together.
        """
        fields, task = {**self.training, "seed": seed}, dict(self.training.get("task", {}))
        for name, value in values.items():
            if not name.startswith(TASK):
                fields[name] = value
                continue
            nested = value
            for part in reversed(name.removeprefix(TASK).split(".")):
                nested = {part: nested}
            task = changed(task, nested)
        return with_recipe({**fields, **({"task": task} if task else {})}, definition.robot, self.whole)

    def check(self, definition: TaskDefinition = BUILT_IN) -> None:
        """Check each end of the space on its own. Values that do not fit together fail in their trial.

        Raises:
            QuadrupedError: if one of them is not valid; the message names the field.
        """
        for values in ({}, *({name: value} for name, found in self.space.items() for value in ends(found))):
            try:
                config = self.config(values, self.first_seed, definition)
                task_config(config.action_mode, config.task, definition.path)
            except QuadrupedError as error:
                raise QuadrupedError(f"sweep.vary {in_words(values)}: {error}" if values else str(error)) from error

    def create(self, command: str, definition: TaskDefinition = BUILT_IN) -> "Sweep":
        """Write the definition into the directory, and return the sweep.

        Raises:
            QuadrupedError: if it cannot be written.
        """
        file, fields = definition.file, {name: value for name, value in vars(self).items() if name != "path"}
        fields |= {
            "space": {name: optuna_module().distributions.distribution_to_json(f) for name, f in self.space.items()},
            "study": f"{self.path.name}-{uuid.uuid4().hex[:8]}",
            "in_database": bool(self.space) and STORAGE in os.environ,
            "task_file": None if file is None else file.to_dict(),
        }
        if file is not None:
            write_whole({self.path / name: content for name, content in kept_files(file).items()})
        document = {"format_version": FORMAT_VERSION, **plain(fields), **circumstances(command)}
        write_json(self.path / SWEEP_FILE, document)
        return Sweep.open(self.path)

    @classmethod
    def open(cls, path: Path) -> "Sweep":
        """Read the sweep in a directory.

        Raises:
            QuadrupedError: if there is none, or its definition is damaged.
        """
        file = path / SWEEP_FILE
        if not os.path.isfile(file):  # Path.is_file raises for a name that is too long
            raise QuadrupedError(f"{short(str(path))}: has no {SWEEP_FILE}; name a directory that 'sweep' made")
        document = read_json(file, "start a new sweep")
        try:
            if document["format_version"] != FORMAT_VERSION:
                raise QuadrupedError(
                    f"made by version {short(document['versions']['mini-quadruped'])} of mini-quadruped, which goes on "
                    f"with it; use that version, or start a new sweep. This one evaluates its runs"
                )
            own = {name: document[name] for name in cls.__dataclass_fields__.keys() - {"path"}}
            own["space"] = {
                name: optuna_module().distributions.json_to_distribution(text) for name, text in own["space"].items()
            }
            own["task_file"] = None if own["task_file"] is None else TaskFile(**own["task_file"])
            return cls(path, **{**own, "whole": tuple(own["whole"])})
        except QuadrupedError as error:
            raise QuadrupedError(f"{file}: {error}") from error
        except (KeyError, TypeError, AttributeError, ValueError) as error:
            raise QuadrupedError(f"{file}: damaged ({short(str(error))}); start a new sweep") from error

    def definition(self, trusted: bool) -> TaskDefinition:
        """Execute the copy of the user's task file if it is `trusted`, and return what it defines.

        Raises:
            QuadrupedError: if it is not trusted, or differs from the file that the sweep was made with.
        """
        if self.task_file is None:
            return BUILT_IN
        if not trusted:
            raise QuadrupedError(
                f"{self.path / KEPT_FILE}: this sweep has terms from {short(self.task_file.name)}, which is not "
                f"executed automatically: check the file, then give --trust-task"
            )
        return load_task_file(self.path / KEPT_FILE, self.task_file)

    def trial(self, number: int) -> Path:
        """Return the directory of a trial."""
        return self.path / "trials" / f"{number:04d}"

    def result(self, number: int) -> dict[str, Any] | None:
        """Return the result of a trial; None while it is open.

        Raises:
            QuadrupedError: if the file is damaged.
        """
        path = self.trial(number) / "result.json"
        if not os.path.lexists(path):
            return None
        found = read_json(path, "remove it, and the trial is open again")
        if not isinstance(found, dict) or not {"state", "score", "values", "seconds"} <= found.keys():
            raise QuadrupedError(f"{path}: not a result; remove it, and the trial is open again")
        return found

    def open_trials(self) -> list[int]:
        """Return the numbers of the trials without a result."""
        return [number for number in range(len(self)) if self.result(number) is None]

    def finish(self, number: int, result: Mapping[str, Any]) -> None:
        """Write the result of a trial; if the sweep was removed, raise a QuadrupedError and make nothing again."""
        self.check_exists()
        write_json(self.trial(number) / "result.json", dict(result))

    def check_exists(self) -> None:
        """Raise a QuadrupedError if the directory was removed."""
        if not os.path.isfile(self.path / SWEEP_FILE):
            raise QuadrupedError(f"{self.path}: the sweep was removed; bring it back, or start a new one")

    def locked(self, name: str, wait: bool = True) -> AbstractContextManager[bool]:
        """Return a context in which this process holds a lock. Without `wait` it yields False if another process does.

        Raises:
            QuadrupedError: if the file system has no locks, or refuses to write.
        """
        self.check_exists()
        return file_lock(self.path / "locks" / name, wait)

    def join(self) -> None:
        """Check that this process can be a worker of the sweep.

        Raises:
            QuadrupedError: if the file system has no locks, or the first worker had another package, Python, torch or
                MuJoCo, so that results would not be comparable.
        """
        self.check_exists()
        check_locks(self.path / "locks")
        libraries, path = versions(), self.path / "worker.json"
        own = {name: libraries[name] for name in ("python", "torch", "mujoco")}
        own["package"] = package_hash(asset_path("mini_quadruped.xml"))
        with self.locked("join"):
            if not os.path.lexists(path):
                write_json(path, own)
        first = read_json(path, "remove it if no trial is finished")
        other = [f"{name} {first.get(name)} (here {value})" for name, value in own.items() if value != first.get(name)]
        if other:
            raise QuadrupedError(
                f"{path}: the sweep's first worker has {', '.join(other)}, so results would not be comparable; install "
                f"the same versions on all machines, or start a new sweep"
            )

    def take_trials(self) -> Generator[int]:
        """Yield the numbers of open trials, each locked until the next one is asked for.

        While other workers do the last trials, it waits, to take over the trial of a worker that is lost.
        """
        left = list(range(len(self)))
        while left := [number for number in left if self.result(number) is None]:
            for number in left:
                with self.locked(f"{number:04d}", wait=False) as held:
                    if held and self.result(number) is None:
                        yield number
                        break  # an earlier one may be free now
            else:
                time.sleep(_POLL)

    def retry_failed(self) -> None:
        """Rename the directories of failed trials, so that these trials are open again."""
        with self.locked("join"):
            for number in range(len(self)):
                if (self.result(number) or {}).get("state") == "failed":
                    path = self.trial(number)
                    path.rename(free_path(path.with_name(f"{path.name}.failed")))
