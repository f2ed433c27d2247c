"""Definition of a sweep as plain values: its trainings, its space, its search and its score."""

import hashlib
import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final, Literal

from quadruped_env.envs.arguments import changed, task_config
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.sweep.search_space import TASK, Dimension, of_dict
from quadruped_env.training import TrainConfig
from quadruped_env.training.train_config import check_fields
from quadruped_env.utils.documents import check_regular
from quadruped_env.utils.plain import plain
from quadruped_env.utils.seeds import check_training_seeds

FORMAT_VERSION: Final = 1
SEARCHES: Final = ("random", "optuna", "grid")
SCHEDULERS: Final = ("none", "asha")
SCORES: Final = ("quick", "suite", "none")
MAX_TRIALS: Final = 100_000
_BOUNDS: Final = {
    "seeds": (1, 10**9),
    "settings": (1, 10**9),
    "cores_per_trial": (1, 10_000),
    "reduction": (2, 100),
    "rungs": (1, 20),
}
"""Lowest and highest value of each number of a sweep."""
MakeConfig = Callable[[Mapping[str, Any]], TrainConfig]
"""The settings of a training from fields of `TrainConfig` that a user set, with those of recipe and algorithm."""


@dataclass(frozen=True)
class SweepConfig:
    """A sweep: settings, each of which is trained with every seed. A trial is one training."""

    training: dict[str, Any] = field(default_factory=dict)
    """Fields of `TrainConfig` that all trials have; of `task`, changes to its config."""
    whole: tuple[str, ...] = ()
    """Sections of the task's config that are set as a whole, in place of the recipe's."""
    space: tuple[Dimension, ...] = ()
    """Fields that vary; empty: seeds of one config."""
    seeds: int = 1
    """Seeds of each setting, from `training["seed"]` on."""
    settings: int = 1
    """Number of settings."""
    search: Literal["random", "optuna", "grid"] = "random"
    scheduler: Literal["none", "asha"] = "none"
    reduction: int = 2
    """ASHA goes on with the best 1 / reduction of the trials at each rung."""
    rungs: int = 3
    """Number of ASHA's rungs, at the shares 1 / reduction ** rungs, ..., 1 / reduction of the budget."""
    score: Literal["quick", "suite", "none"] = "quick"
    """Measure of a finished trial: the quick suite, the full one, or nothing."""
    cores_per_trial: int = 1
    """Cores, and threads of the physics, of each trial."""
    task_file: str | None = None
    """The user's Python file of terms; every node executes it."""
    task_sha256: str | None = None
    """SHA-256 of that file."""

    def __post_init__(self) -> None:
        self._check_fields()
        if len(self) > MAX_TRIALS:
            raise QuadrupedError(f"--trials: {len(self)} trainings are more than {MAX_TRIALS}; lower it, or --seeds")
        for name, count in Counter(dimension.field for dimension in self.space).items():
            if count > 1:
                raise QuadrupedError(f"--vary {name}: found twice; give each field once, in --vary or in --space")
        first = self.training.get("seed", TrainConfig.seed)
        num_envs = self.training.get("num_envs", TrainConfig.num_envs)
        check_fields({"seed": first + self.seeds - 1})
        check_training_seeds("--seeds", first, self.seeds - 1 + num_envs)
        if not self.space and self.settings > 1:
            raise QuadrupedError(
                f"--trials: found {self.settings} without a field that varies; give --vary FIELD=LOW..HIGH or --space "
                f"FILE, or --seeds {self.settings} for that many seeds of one config"
            )
        if self.search != "random" and not self.space:
            raise QuadrupedError(f"--search: found {self.search} without a field that varies; give --vary or --space")
        if self.search == "grid":
            self._check_grid()
        if self.scheduler == "asha":
            if self.training.get("seconds") is not None:
                raise QuadrupedError(
                    "--scheduler: asha compares policies after equal numbers of steps; give --timesteps in place of "
                    "--seconds"
                )
            if len(self) < 2:
                raise QuadrupedError("--scheduler: asha compares trials, and this sweep has one; give more --trials")
        if self.score == "none" and (self.scheduler == "asha" or self.search == "optuna"):
            option = "--scheduler asha" if self.scheduler == "asha" else "--search optuna"
            raise QuadrupedError(f"--score: found none with {option}, which compares scores; give --score quick")

    def _check_fields(self) -> None:
        """Check each field by itself; their values may be those of a file."""
        for name, (low, high) in _BOUNDS.items():
            value = getattr(self, name)
            if type(value) is not int or not low <= value <= high:
                option = "--trials" if name == "settings" else f"--{name.replace('_', '-')}"
                raise QuadrupedError(f"{option}: expected {low} or more, and at most {high}; found {short(value)}")
        for name, valid in (("search", SEARCHES), ("scheduler", SCHEDULERS), ("score", SCORES)):
            if getattr(self, name) not in valid:
                raise QuadrupedError(
                    f"--{name}: expected one of {', '.join(valid)}; found {short(getattr(self, name))}"
                )
        for text in (*self.whole, self.task_file, self.task_sha256):
            if not isinstance(text, str | None):
                raise QuadrupedError(f"whole, task_file, task_sha256: expected texts; found {short(text)}")
        check_fields(self.training)

    def _check_grid(self) -> None:
        ranges = [dimension.field for dimension in self.space if not dimension.choices]
        if ranges:
            raise QuadrupedError(
                f"--search: a grid needs choices, and {ranges[0]} has a range; list its values, or search random"
            )
        size = math.prod(len(dimension.choices) for dimension in self.space)
        if self.settings != size:
            raise QuadrupedError(f"--trials: found {self.settings}; this grid has {size} settings; leave --trials out")

    def __len__(self) -> int:
        """Number of trials."""
        return self.settings * self.seeds

    def trials(self) -> Iterator[tuple[int, int, int]]:
        """Number, setting and seed of each trial; all seeds of the first setting come first."""
        first = self.training.get("seed", TrainConfig.seed)
        for number in range(len(self)):
            yield number, number // self.seeds, first + number % self.seeds

    def fields_of(self, values: Mapping[str, Any], seed: int) -> dict[str, Any]:
        """Fields of `TrainConfig` of a trial, of which `task` holds changes.

        Args:
            values: field of the space -> value.
            seed: seed of the training.
        """
        fields, task = {**self.training, "seed": seed}, dict(self.training.get("task", {}))
        for name, value in values.items():
            if not name.startswith(TASK):
                fields[name] = value
                continue
            nested: Any = plain(value)
            for part in reversed(name.removeprefix(TASK).split(".")):
                nested = {part: nested}
            task = changed(task, nested)
        return {**fields, **({"task": task} if task else {})}

    def milestones(self) -> tuple[int, ...]:
        """Rungs in units of the budget / reduction ** rungs; empty without ASHA."""
        return tuple(self.reduction**k for k in range(self.rungs)) if self.scheduler == "asha" else ()

    def check(self, make: MakeConfig) -> None:
        """Make the config of a training at every end of the space, and of the task that it trains in.

        Raises:
            QuadrupedError: if one of them is not valid; the message names the field that varies.
        """
        first = self.training.get("seed", TrainConfig.seed)
        base = {dimension.field: dimension.ends()[0] for dimension in self.space}
        _check_training(make(self.fields_of({}, first)), self.task_file)
        for dimension in self.space:
            for value in dimension.ends():
                # Alone, or with the others at their first values. Values that do not fit together fail in their trial.
                errors = []
                for values in ({dimension.field: value}, {**base, dimension.field: value}):
                    try:
                        _check_training(make(self.fields_of(values, first)), self.task_file)
                        break
                    except QuadrupedError as error:
                        errors.append(error)
                else:
                    raise QuadrupedError(f"--vary {dimension.field}: {short(value)} is not valid: {errors[0]}")

    def to_dict(self) -> dict[str, Any]:
        """Plain values for JSON."""
        return {
            **{name: plain(value) for name, value in vars(self).items() if name != "space"},
            "space": {dimension.field: plain(dimension.to_dict()) for dimension in self.space},
        }

    @classmethod
    def from_dict(cls, values: Mapping[str, Any], where: str) -> "SweepConfig":
        """The sweep with plain values of `to_dict`, also of an earlier version; `where` names them in errors.

        Raises:
            QuadrupedError: if they are not those of a sweep.
        """
        try:
            space = tuple(of_dict(name, entry) for name, entry in values["space"].items())
            training = known(values["training"])
            if "hidden" in training:
                training["hidden"] = tuple(training["hidden"])
            for dimension in space:
                for end in dimension.ends() if not dimension.field.startswith(TASK) else ():
                    check_fields({dimension.field: end})
            return cls(**{**values, "space": space, "training": training, "whole": tuple(values["whole"])})
        except QuadrupedError as error:
            raise QuadrupedError(f"{where}: {error}") from error
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise QuadrupedError(
                f"{where}: not the definition of a sweep ({short(str(error))}); start a new one"
            ) from error


def known(training: Mapping[str, Any]) -> dict[str, Any]:
    """Those fields of a training that this version has; an earlier one may have written others."""
    return {name: value for name, value in training.items() if name in TrainConfig.__dataclass_fields__}


def sha256_of(path: Path) -> str:
    """SHA-256 of a file.

    Raises:
        QuadrupedError: if it cannot be read.
    """
    try:
        check_regular(path, "name the Python file of --task")
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError as error:
        raise QuadrupedError(f"{path}: cannot be read ({error.strerror}); name the Python file of --task") from error


def _check_training(config: TrainConfig, task_file: str | None) -> None:
    task_config(config.action_mode, config.task, task_file)
