"""The run or checkpoint that a training goes on from: its settings, its step count and its learning curve."""

import csv
import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any, Final, NotRequired, TypedDict

from quadruped_env.control.task_file import TASK_FILE, TaskFileError, recorded_terms
from quadruped_env.envs.arguments import changed
from quadruped_env.errors import QuadrupedError, QuadrupedWarning, short
from quadruped_env.policies import load_policy, task_note
from quadruped_env.policies.files import finished_directory
from quadruped_env.policies.not_a_policy import not_a_policy
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE
from quadruped_env.task import BUILT_IN, TaskConfig, TaskDefinition
from quadruped_env.task.task_config import flat
from quadruped_env.training.run_directory import (
    CONFIG_FILE,
    PROGRESS_FILE,
    RESUME_FILE,
    RESUMED_FROM,
    run_name,
)
from quadruped_env.training.train_config import TrainConfig
from quadruped_env.utils.documents import fitted, read_json
from quadruped_env.utils.provenance import TERRAIN_FILE

_NEW: Final = "start a new training"
_REMOVED: Final = {"policy": ("",), "device": ("cpu",), "ranks": ()}
"""Fields of `TrainConfig` in earlier versions, with the values of trainings that can be resumed (all, if none)."""
_BUDGET: Final = frozenset({"timesteps", "seconds"})


class _StoredRun(TypedDict):
    """Fields of config.json."""

    training: dict[str, Any]
    task: dict[str, Any]
    resumed_from: NotRequired[dict[str, Any] | None]


class _Used(TypedDict):
    """Budget that a run has used."""

    timesteps: int
    seconds: float


class _StoredProgress(_Used):
    """Facts on a policy's card."""

    budget_left: float


@dataclass(frozen=True)
class Parent:
    """A run or checkpoint to go on from."""

    directory: Path
    config: TrainConfig
    """The training that left it, with the whole task"""
    timesteps: int
    """Environment steps that its policy has learned from, its own parents' steps included"""
    seconds: float
    """Wall clock that they took"""
    budget_left: float
    """Share of the schedules that is left, from 1 at the start of a training to 0 when its budget is used"""
    began: _Used
    """`timesteps` and `seconds` at the start of its own run, more than 0 if that was resumed, too"""
    curve: tuple[dict[str, str], ...]
    """Rows of progress.csv up to `timesteps`"""
    definition: TaskDefinition = BUILT_IN
    """Terms and robot of its task"""
    task_changes: str = ""
    """A sentence if its task file is another version than the one that it was trained with; else empty."""

    @property
    def name(self) -> str:
        """The run, or the run and its checkpoint."""
        return run_name(self.directory)

    @classmethod
    def load(cls, directory: Path, definition: TaskDefinition = BUILT_IN) -> "Parent":
        """Read a run; of one that was killed, its last checkpoint.

        Raises:
            QuadrupedError: if the directory is not a complete run; the message names the file, the field and the fix.

        Warns:
            QuadrupedWarning: if it is a checkpoint, though the run was named.
        """
        if not os.path.isdir(directory):  # Path.is_dir raises for a name that is too long
            problem = not_a_policy(str(directory)) or f"{directory} is not a directory"
            raise QuadrupedError(f"{problem}; name a run such as runs/latest")
        directory = finished_directory(directory)
        for name in (CONFIG_FILE, CARD_FILE, TENSORS_FILE, RESUME_FILE, PROGRESS_FILE):
            if not (directory / name).is_file():
                raise QuadrupedError(
                    f"{directory / name} is missing, so the run is incomplete; resume one of its checkpoints/, or "
                    f"{_NEW}"
                )
        config, began = _read_config(directory / CONFIG_FILE, definition)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", QuadrupedWarning)  # it says the same as `task_changes`
            policy, path = load_policy(directory, definition.path), directory / CARD_FILE
        if config.asymmetric_critic and TASK_FILE in policy.task:
            _check_privileged(recorded_terms(policy.task[TASK_FILE]).get("privileged", []), definition)
        card = fitted(policy.card, _StoredProgress, f"{path}: card", _NEW)
        curve = _read_curve(directory / PROGRESS_FILE, card["timesteps"])
        return cls(
            directory, config, **card, began=began, curve=curve, definition=definition, task_changes=task_note(policy)
        )

    def resumed(self, changes: Mapping[str, Any]) -> TrainConfig:
        """Settings of the resumed training: this run's, with another budget or another reward.

        Without a budget it is the rest of this run's, or the same amount again if that was used.

        Args:
            changes: `timesteps` or `seconds`, and `task` with changes to its `reward`.

        Raises:
            QuadrupedError: if another setting is to change, or a value is not valid.
        """
        task = changes.get("task", {})
        other = changes.keys() - _BUDGET - {"task"} | {f"task.{name}" for name in task.keys() - {"reward"}}
        if other:
            raise QuadrupedError(
                f"training.{min(other)}: {self.name} keeps its own: a resumed training changes its budget (timesteps, "
                f"seconds) and its reward (task.reward) alone; leave it out, or {_NEW}"
            )
        settings = {name: value for name, value in changes.items() if name != "task"}
        if "timesteps" in changes:
            settings = {"seconds": None, **settings}
        elif "seconds" not in changes:
            budget = "timesteps" if self.config.seconds is None else "seconds"
            whole, used = getattr(self.config, budget), getattr(self, budget) - self.began[budget]  # type: ignore[literal-required]
            settings[budget] = whole - used if used < whole else whole
        reward = {"reward": task["reward"]} if "reward" in task else {}
        return replace(self.config, **settings, task=changed(self.config.task, reward))

    def reward_changes(self, config: TrainConfig) -> str:
        """Differences of a resumed training's reward from this one's, in a sentence; empty without differences."""
        whole = TaskConfig.from_dict(config.task, self.definition).to_dict()
        then, now = flat(self.config.task["reward"]), flat(whole["reward"])
        found = [f"reward.{path} {now[path]} (the run: {then[path]})" for path in now if now[path] != then[path]]
        return f"the reward differs from the run's: {'; '.join(found)}" if found else ""

    def facts(self) -> dict[str, Any]:
        """Facts about the parent in a resumed run's files."""
        facts = {"run": self.name, "timesteps": self.timesteps, "seconds": self.seconds}
        changes = {"task_changes": self.task_changes} if self.task_changes else {}
        return {**facts, "budget_left": self.budget_left, **changes}


def _check_privileged(recorded: list[str], definition: TaskDefinition) -> None:
    """Refuse a version of a task file without exactly those privileged readings that the run's critic observes."""
    other = sorted({*recorded} ^ {*definition.own_terms()["privileged"]})
    if other and definition.file is not None:
        raise QuadrupedError(
            f"{definition.file.name}: has another privileged reading {', '.join(other)} than the run, whose critic "
            f"observes it; name the run's version of the file, or {_NEW}"
        )


def _read_config(path: Path, definition: TaskDefinition) -> tuple[TrainConfig, _Used]:
    """Return the training of a run's config.json with its whole task, and the steps and seconds at which it began."""
    document = fitted(read_json(path, _NEW), _StoredRun, str(path), _NEW)
    training, task = document["training"], document["task"]
    for name, valid in _REMOVED.items():
        if valid and training.get(name, valid[0]) not in valid:
            raise QuadrupedError(
                f"{path}: training.{name}: found {short(training[name])}, with which this version does not train; its "
                f"policy works, and the version that wrote it resumes it"
            )
    values = {name: value for name, value in training.items() if name not in _REMOVED}
    known = {field.name for field in fields(TrainConfig)}
    if problems := sorted(known ^ values.keys()):
        problem = "is missing" if problems[0] in known else "is unknown"
        raise QuadrupedError(f"{path}: field {short(f'training.{problems[0]}')} {problem}; {_NEW}")
    if definition.file is not None and not {TASK_FILE, TERRAIN_FILE} & set(task):
        raise QuadrupedError(
            f"{definition.file.name}: {run_name(path.parent)} was trained without a task file, and a resumed training "
            f"keeps its task; leave the file out, or {_NEW}"
        )
    try:
        config = TrainConfig(**values)
    except QuadrupedError as error:
        raise QuadrupedError(f"{path}: {error}; {_NEW}") from error
    try:
        whole_task = TaskConfig.from_dict(task, definition)
    except TaskFileError as error:
        raise QuadrupedError(f"{path}: {error}") from error
    except QuadrupedError as error:
        raise QuadrupedError(f"{path}: {error}; {_NEW}") from error
    facts = document.get("resumed_from") or {"timesteps": 0, "seconds": 0.0}
    began = fitted(facts, _Used, f"{path}: {RESUMED_FROM}", _NEW)
    return replace(config, task=whole_task.to_dict()), began


def _read_curve(path: Path, timesteps: int) -> tuple[dict[str, str], ...]:
    """Return the rows of a learning curve up to a number of steps."""
    rows = []
    try:
        with path.open(newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                # Later than the checkpoint, or the line that a killed run left unfinished.
                if None in row.values() or float(row["timesteps"]) > timesteps:
                    break
                rows.append(row)
    except (KeyError, ValueError, csv.Error) as error:
        raise QuadrupedError(f"{path}: not a learning curve ({error!r}); {_NEW}") from error
    return tuple(rows)
