"""The run or checkpoint that a training goes on from: its settings, its step count and its learning curve."""

import csv
import json
import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

from quadruped_env.control.task_file import TASK_FILE, TaskFileError, recorded_terms
from quadruped_env.envs.arguments import changed
from quadruped_env.errors import QuadrupedError, QuadrupedWarning, short
from quadruped_env.policies import Policy, load_policy, task_note
from quadruped_env.policies.files import finished_directory
from quadruped_env.policies.not_a_policy import not_a_policy
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE
from quadruped_env.task import BUILT_IN, TaskConfig, TaskDefinition
from quadruped_env.task.randomization.randomization_presets import PRESET
from quadruped_env.task.task_config import flat
from quadruped_env.training import user_classes
from quadruped_env.training.run_directory import (
    CONFIG_FILE,
    PROGRESS_COLUMNS,
    PROGRESS_FILE,
    RESUME_FILE,
    RESUMED_FROM,
    TERM_COLUMN,
    run_name,
)
from quadruped_env.training.train_config import TrainConfig, field_rule
from quadruped_env.training.user_classes import OPTIONS, RECORDED, is_user_class, recorded_name
from quadruped_env.utils.documents import read_json
from quadruped_env.utils.plain import plain
from quadruped_env.utils.provenance import TERRAIN_FILE

NO_SECTIONS: Final[Mapping[str, str]] = MappingProxyType({})
KEPT: Final = (
    "recipe",
    "algo",
    "policy",
    "action_mode",
    "hidden",
    "activation",
    "symmetric",
    "asymmetric_critic",
    "log_std_init",
    "task",
)
"""Fields of `TrainConfig` that a resumed training takes from its parent: its network and its task."""
_ADDED: Final = frozenset({"policy"})
"""Fields of `TrainConfig` that runs of earlier versions lack; these were trained with the defaults."""
_REMOVED: Final = frozenset({"ranks", "device"})
"""Fields of runs of earlier versions that trained with several processes, or on a GPU."""

_MOST: Final = 1e15
"""Maximum number of steps and seconds that a run has learned from."""


@dataclass(frozen=True)
class Parent:
    """A run or checkpoint to go on from."""

    directory: Path
    config: TrainConfig
    """The training that left it, with the whole task"""
    timesteps: int
    """Environment steps that its policy has learned from, those of its own parents included"""
    seconds: float
    """Wall clock that they took"""
    budget_left: float
    """Share of the schedules that was left, from 1 at the start of a training to 0 when its budget is used"""
    budget_left_at_start: float
    """The same at the start of its own run, less than 1 if that was resumed too"""
    curve: tuple[dict[str, str], ...]
    """Rows of progress.csv up to `timesteps`"""
    definition: TaskDefinition = BUILT_IN
    """Terms and robot of its task"""
    user_code: Any = None
    """Files of the user's own algorithm and policy class, as the run recorded them"""
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
            raise QuadrupedError(f"--resume: {problem}; name a run such as runs/latest")
        directory = finished_directory(directory)
        for name in (CONFIG_FILE, CARD_FILE, TENSORS_FILE, RESUME_FILE, PROGRESS_FILE):
            if not (directory / name).is_file():
                raise QuadrupedError(
                    f"--resume: {directory / name} is missing, so the run is incomplete; resume one of its "
                    f"checkpoints/, or start a new training"
                )
        config, budget_left_at_start = _read_config(directory / CONFIG_FILE, definition)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", QuadrupedWarning)  # it says the same as `task_changes`
            policy, path = load_policy(directory, definition.path), directory / CARD_FILE
        card = policy.card
        if config.asymmetric_critic and TASK_FILE in policy.task:
            _check_privileged(policy)
        timesteps = _number(path, "card", card, "timesteps", whole=True)
        return cls(
            directory,
            config,
            int(timesteps),
            _number(path, "card", card, "seconds"),
            _number(path, "card", card, "budget_left", most=1.0),
            budget_left_at_start,
            _read_curve(directory / PROGRESS_FILE, int(timesteps)),
            definition,
            card.get(RECORDED),
            task_note(policy),
        )

    def resumed(self, changes: Mapping[str, Any], whole: Mapping[str, str] = NO_SECTIONS) -> TrainConfig:
        """Settings of the resumed training: this run's, with changes. Of the task, the reward may be another one.

        Without a budget it is the rest of this run's, or the same amount again if that was complete.

        Args:
            changes: fields of `TrainConfig` that the user set.
            whole: see `check`.

        Raises:
            QuadrupedError: if one of them cannot be changed, or is invalid.
        """
        self.check(changes, whole)
        task = self.with_reward(changes.get("task", {}))
        # Only the user knows where a file is, and whether to execute it.
        own = {name: changes[name] for name in OPTIONS if is_user_class(getattr(self.config, name))}
        changes = {name: value for name, value in changes.items() if name not in KEPT} | {"task": task} | own
        if "timesteps" in changes:
            changes = {"seconds": None, **changes}
        elif "seconds" not in changes and self.budget_left > 0.0:
            share = self.budget_left / (self.budget_left_at_start or 1.0)
            budget = "timesteps" if self.config.seconds is None else "seconds"
            left = getattr(self.config, budget) * share
            changes[budget] = max(1, round(left)) if budget == "timesteps" else left
        return replace(self.config, **changes)

    def with_reward(self, task: Mapping[str, Any]) -> dict[str, Any]:
        """This training's task with the reward of another one, or changes to it."""
        return changed(self.config.task, {"reward": task.get("reward", {})})

    def reward_changes(self, config: TrainConfig) -> str:
        """Differences of a resumed training's reward from this one's, in a sentence; empty without differences."""
        then, now = flat(_as_json(self.config.task["reward"])), flat(_as_json(config.task["reward"]))
        found = [f"reward.{path} {now[path]} (the run: {then[path]})" for path in now if now[path] != then[path]]
        return f"the reward differs from the run's: {'; '.join(found)}" if found else ""

    def check(self, asked: Mapping[str, Any], whole: Mapping[str, str] = NO_SECTIONS) -> None:
        """Refuse settings that differ from this training's network or task; its reward may be another one.

        Args:
            asked: fields of `TrainConfig`; of `task`, the fields of the config that are given are compared.
            whole: sections of the task's config that an option sets as a whole, with the option: what `asked` leaves
                out of them has its default.

        Raises:
            QuadrupedError: naming the option, the value given and the run's own.
        """
        for name in KEPT:
            kept = getattr(self.config, name)
            if name in OPTIONS and is_user_class(kept) and name not in asked:
                raise QuadrupedError(
                    f"--{name}: {self.name} was trained with {short(kept)}, whose file is not executed automatically: "
                    f"check the file, then name it with --{name} FILE.py:{kept.rpartition(':')[2]}"
                )
            if name not in asked:
                continue
            value: Any = recorded_name(asked[name]) if name in OPTIONS else asked[name]
            option = name.replace("_", "-")
            if name == "task":
                difference = self._task_difference(value, whole)
                if difference is None:
                    continue
                option, value, kept = difference
            elif value == kept:
                continue
            raise QuadrupedError(
                f"--{option}: found {short(value)}; {self.name} has {short(kept)}, and a resumed training keeps its "
                f"task and network: leave the option out, or start a new training without --resume"
            )

    def _task_difference(self, asked: dict[str, Any], whole: Mapping[str, str]) -> tuple[str, Any, Any] | None:
        """The first field of a task's config that is not as in this run: its option, its value and the run's."""
        for section, changes in asked.items():
            if section in ("reward", TASK_FILE):
                continue
            values, kept = _as_json(changes), _as_json(self.config.task.get(section))
            option = whole.get(section)
            preset = section == "randomization" and (isinstance(values, str) or PRESET in values)
            if option is not None or preset:
                complete = TaskConfig.from_dict({section: values}, self.definition).to_dict()[section]
                # Fields that only the run has count, too.
                values = {**dict.fromkeys(kept), **_as_json(complete)}
            found = _difference(values, kept, section)
            if found is not None:
                field, value, own = found
                field = field if option is None else field.removeprefix(f"{section}.")
                return f"{option or 'task'}: {field}", value, own
        return None

    def code_changes(self, config: TrainConfig) -> str:
        """Differences of a resumed training's own classes from this one's, in a sentence; empty without differences."""
        return user_classes.changes(self.user_code, vars(config))

    def facts(self) -> dict[str, Any]:
        """Facts about the parent in a resumed run's files."""
        facts = {"run": self.name, "timesteps": self.timesteps, "seconds": self.seconds}
        changes = {"task_changes": self.task_changes} if self.task_changes else {}
        return {**facts, "budget_left": self.budget_left, **changes}


def _as_json(value: Any) -> Any:
    """A value as it is read from a file again."""
    return json.loads(json.dumps(plain(value)))


def _difference(asked: Any, kept: Any, path: str = "") -> tuple[str, Any, Any] | None:
    """The first field of nested values that is not as in others: its path, its value and the other."""
    if not isinstance(asked, dict) or not isinstance(kept, dict):
        return None if asked == kept else (path, asked, kept)
    for name, value in asked.items():
        found = _difference(value, kept.get(name), f"{path}.{name}".lstrip("."))
        if found is not None:
            return found
    return None


def _check_privileged(policy: Policy) -> None:
    """Refuse another version of a task file whose privileged readings are not those that the run's critic observes."""
    recorded, definition = policy.task[TASK_FILE], policy.config.definition
    old, new = recorded_terms(recorded).get("privileged", []), definition.own_terms()["privileged"]
    if other := sorted({*old} ^ {*new}):
        assert definition.file is not None
        raise QuadrupedError(
            f"--task: {definition.file.name} has another privileged reading {', '.join(other)} than the run, whose "
            f"critic observes it; name the run's version of the file, or start a new training without --resume"
        )


def _read_config(path: Path, definition: TaskDefinition) -> tuple[TrainConfig, float]:
    """The training of a run's config.json with its whole task, and the share of the schedules that it began with."""
    document = read_json(path, "start a new training")
    training, task = _section(path, document, "training"), _section(path, document, "task")
    if training.get("device", "cpu") != "cpu":
        raise QuadrupedError(
            f"{path}: training.device: found {short(training['device'])}; a run of an earlier version's trainer on a "
            f"GPU works as a policy, and cannot be resumed; start a new training"
        )
    values: dict[str, Any] = {}
    for field in fields(TrainConfig):
        if field.name in _ADDED and field.name not in training:
            continue
        if field.name not in training:
            raise QuadrupedError(f"{path}: field 'training.{field.name}' is missing; start a new training")
        value = training[field.name]
        rule = field_rule(field.name, value)
        if rule is not None:
            raise QuadrupedError(
                f"{path}: training.{field.name}: expected {rule}; found {short(value)}; start a new training"
            )
        values[field.name] = value
    if definition.file is not None and not {TASK_FILE, TERRAIN_FILE} & set(task):
        raise QuadrupedError(
            f"--task: found {definition.file.name}; {run_name(path.parent)} was trained without a file, and a resumed "
            f"training keeps its task and network: leave the option out, or start a new training without --resume"
        )
    unknown = sorted(set(training) - set(values) - _REMOVED)
    if unknown:
        raise QuadrupedError(f"{path}: training has the unknown field {short(unknown[0])}; start a new training")
    try:
        config = TrainConfig(**{**values, "hidden": tuple(values["hidden"])})
        whole_task = TaskConfig.from_dict(task, definition)
    except QuadrupedError as error:
        fix = "" if isinstance(error, TaskFileError) else "; start a new training"
        raise QuadrupedError(f"{path}: {error}{fix}") from error
    if whole_task.action.mode != config.action_mode:
        raise QuadrupedError(
            f"{path}: training.action_mode is {config.action_mode!r} and task.action.mode is "
            f"{whole_task.action.mode!r}; start a new training"
        )
    share = 1.0
    if document.get(RESUMED_FROM) is not None:
        share = _number(path, RESUMED_FROM, _section(path, document, RESUMED_FROM), "budget_left", most=1.0)
    return replace(config, task=whole_task.to_dict()), share


def _section(path: Path, document: Any, name: str) -> dict[str, Any]:
    section = document.get(name) if isinstance(document, dict) else None
    if not isinstance(section, dict):
        raise QuadrupedError(f"{path}: field '{name}' is missing or not a table of fields; start a new training")
    return section


def _number(
    path: Path, section: str, values: Mapping[str, Any], name: str, most: float = _MOST, whole: bool = False
) -> float:
    value = values.get(name)
    kinds = (int,) if whole else (int, float)
    if isinstance(value, bool) or not isinstance(value, kinds) or not 0 <= value <= most:
        rule = f"a {'whole ' * whole}number, 0 to {most:g}"
        raise QuadrupedError(f"{path}: {section}.{name}: expected {rule}; found {short(value)}; start a new training")
    return value


def _read_curve(path: Path, timesteps: int) -> tuple[dict[str, str], ...]:
    """The rows of a learning curve up to a number of steps."""
    rows = []
    try:
        with path.open(newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file)
            names = reader.fieldnames or ()
            first, others = tuple(names[: len(PROGRESS_COLUMNS)]), names[len(PROGRESS_COLUMNS) :]
            if first != PROGRESS_COLUMNS or not all(name.startswith(TERM_COLUMN) for name in others):
                raise QuadrupedError(
                    f"{path}: line 1: expected the columns {', '.join(PROGRESS_COLUMNS)}, {TERM_COLUMN}...; "
                    f"found {short(','.join(names))}; start a new training"
                )
            for row in reader:
                if any(row[name] is None for name in names) or float(row["timesteps"]) > timesteps:
                    # Later than the checkpoint, or the line that a killed run left unfinished.
                    break
                rows.append({name: row[name] for name in names})
    except (ValueError, csv.Error) as error:
        if isinstance(error, QuadrupedError):
            raise
        raise QuadrupedError(f"{path}: not a table of numbers ({error}); start a new training") from error
    return tuple(rows)
