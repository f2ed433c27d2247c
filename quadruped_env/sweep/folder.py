"""A sweep: its definition, its files, and the locks by which its workers share them.

    sweep.json                definition
    task.py                   copy of the user's task file, if there is one
    worker.json               package and libraries of the first worker; all others need the same
    optuna.log                study of Optuna, if fields vary
    trials/0007/<time>-ppo/   run directory of a trial; a further one for each time that it went on from a checkpoint
    trials/0007/result.json   result; a trial that has none is open
    locks/                    a lock belongs to the process that holds it, and ends with the process

The files are all that a sweep goes on from: nothing is unpickled.
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

from quadruped_env.control.task_file import KEPT_FILE
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
"""Environment variable of Optuna's: address of a database for studies, perhaps with a password, so in no file."""
MAX_TRIALS: Final = 100_000
_POLL: Final = 1.0
"""Time between looks at the trials that other workers do, s."""


@dataclass(frozen=True)
class Sweep:
    """A sweep: settings, each of which is trained with every seed. A trial is one training."""

    path: Path
    training: dict[str, Any]
    """Fields of `TrainConfig` that all trials have; of `task`, changes to its config."""
    whole: tuple[str, ...] = ()
    """Sections of the task's config that are set as a whole, so that the recipe's do not count."""
    space: Mapping[str, Any] = field(default_factory=dict)
    """Field that varies -> its distribution."""
    settings: int = 1
    """Number of settings."""
    seeds: int = 1
    """Seeds of each setting, from `training["seed"]` on."""
    study: str = ""
    """Name of the study in Optuna's storage."""
    in_database: bool = False
    """True if the study is in the database of `STORAGE`, and not in the directory."""
    task_file: TaskFile | None = None
    """The user's task file, of which the directory has a copy."""

    def __post_init__(self) -> None:
        for name, count in (("seeds", self.seeds), ("trials", self.settings)):
            if not 1 <= count <= MAX_TRIALS or self.seeds * self.settings > MAX_TRIALS:
                raise QuadrupedError(f"sweep.{name}: expected 1 to {MAX_TRIALS:,} trainings in all; found {count:,}")
        if self.settings > self.size:
            raise QuadrupedError(
                f"sweep.trials: found {self.settings}, and each of the {self.size:g} different settings is tried once; "
                f"lower it, vary more, or give more --seeds"
            )
        check_fields({**self.training, "seed": self.first_seed + self.seeds - 1})
        num_envs = self.training.get("num_envs", TrainConfig.num_envs)
        check_training_seeds("seeds", self.first_seed, self.seeds - 1 + num_envs)

    @property
    def size(self) -> float:
        """Number of different settings in the space."""
        return math.prod(map(size, self.space.values()))

    @property
    def first_seed(self) -> int:
        """Seed of the first training of each setting."""
        return int(self.training.get("seed", TrainConfig.seed))

    def __len__(self) -> int:
        """Number of trials."""
        return self.settings * self.seeds

    def __str__(self) -> str:
        """The definition in a line."""
        seeds = f"{self.seeds} seed{'s' * (self.seeds > 1)}"
        if not self.space:
            return f"{seeds} of one config"
        return f"{self.settings} settings of {', '.join(self.space)}, each with {seeds}"

    def setting(self, number: int) -> int:
        """Setting of a trial; all seeds of the first setting come first."""
        return number // self.seeds

    def seed(self, number: int) -> int:
        """Seed of a trial."""
        return self.first_seed + number % self.seeds

    def config(self, values: Mapping[str, Any], seed: int, definition: TaskDefinition = BUILT_IN) -> TrainConfig:
        """Settings of a training.

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
                fields[name] = tuple(value) if isinstance(value, list) else value
                continue
            nested = value
            for part in reversed(name.removeprefix(TASK).split(".")):
                nested = {part: nested}
            task = changed(task, nested)
        return with_recipe({**fields, **({"task": task} if task else {})}, definition.robot, self.whole)

    def check(self, definition: TaskDefinition = BUILT_IN) -> None:
        """Check each end of the space alone. Values that do not fit together fail in their trial.

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
        """Write the definition into the directory, which must not exist.

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
            write_whole({self.path / KEPT_FILE: file.content})
        document = {"format_version": FORMAT_VERSION, **plain(fields), **circumstances(command)}
        write_json(self.path / SWEEP_FILE, document)
        return Sweep.open(self.path)

    @classmethod
    def open(cls, path: Path) -> "Sweep":
        """The sweep in a directory.

        Raises:
            QuadrupedError: if there is none, or it is damaged.
        """
        file = path / SWEEP_FILE
        if not os.path.isfile(file):  # Path.is_file raises for a name that is too long
            raise QuadrupedError(f"{short(str(path))}: has no {SWEEP_FILE}; name a directory that 'sweep' made")
        document = read_json(file, "start a new sweep")
        try:
            if document["format_version"] != FORMAT_VERSION:
                raise QuadrupedError(
                    f"{file}: made by version {short(document['versions']['mini-quadruped'])} of mini-quadruped, which "
                    f"goes on with it; use that version, or start a new sweep. This one evaluates its runs"
                )
            own = {name: document[name] for name in cls.__dataclass_fields__.keys() - {"path"}}
            own["space"] = {
                name: optuna_module().distributions.json_to_distribution(text) for name, text in own["space"].items()
            }
            own["task_file"] = None if own["task_file"] is None else TaskFile(**own["task_file"])
            return cls(path, **{**own, "whole": tuple(own["whole"])})
        except (KeyError, TypeError, AttributeError) as error:
            raise QuadrupedError(f"{file}: damaged ({short(str(error))}); start a new sweep") from error

    def definition(self, trusted: bool) -> TaskDefinition:
        """What the copy of the user's task file defines; it is executed if it is `trusted`.

        Raises:
            QuadrupedError: if it is not trusted, or not the file of the sweep.
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
        """The directory of a trial."""
        return self.path / "trials" / f"{number:04d}"

    def result(self, number: int) -> dict[str, Any] | None:
        """Result of a trial; None while it is open.

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
        """Numbers of the trials without a result."""
        return [number for number in range(len(self)) if self.result(number) is None]

    def finish(self, number: int, result: Mapping[str, Any]) -> None:
        """Write the result of a trial; an error if the sweep was removed, of which writing would make a part again."""
        self.check_exists()
        write_json(self.trial(number) / "result.json", dict(result))

    def check_exists(self) -> None:
        """Raise a QuadrupedError if the directory was removed."""
        if not os.path.isfile(self.path / SWEEP_FILE):
            raise QuadrupedError(f"{self.path}: the sweep was removed; bring it back, or start a new one")

    def locked(self, name: str, wait: bool = True) -> AbstractContextManager[bool]:
        """A context in which this process holds a lock; its value is False if another one does, without `wait`.

        Raises:
            QuadrupedError: if the file system has no locks.
        """
        self.check_exists()
        return file_lock(self.path / "locks" / name, wait)

    def join(self) -> None:
        """Check that this process can be a worker of the sweep.

        Raises:
            QuadrupedError: if the file system has no locks, or the first worker had another package, Python, torch or
                MuJoCo: results would not be comparable.
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
                f"{path}: the sweep's first worker has {', '.join(other)}, and results of both do not compare; install "
                f"the same on all machines, or start a new sweep"
            )

    def take_trials(self) -> Generator[int]:
        """Numbers of open trials, one at a time, each locked until the next one is asked for.

        While others do the last ones, it waits: a process that is lost leaves its trial to one that waits.
        """
        left = list(range(len(self)))
        while left := [number for number in left if self.result(number) is None]:
            for number in left:
                with self.locked(f"{number:04d}", wait=False) as held:
                    if held and self.result(number) is None:
                        yield number
                        break  # one of those before may be free now
            else:
                time.sleep(_POLL)

    def retry_failed(self) -> None:
        """Give the directories of failed trials other names, so that these are open again."""
        with self.locked("join"):
            for number in range(len(self)):
                if (self.result(number) or {}).get("state") == "failed":
                    path = self.trial(number)
                    path.rename(free_path(path.with_name(f"{path.name}.failed")))
