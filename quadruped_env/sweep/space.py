"""The space of a sweep: the fields of task and training that vary, each with one of Optuna's distributions.

A field of the training is named as in `TrainConfig`, a field of the task's config by `task.` and its path, such as
`task.reward.weights.foot_slip`. Choices may be lists, which Optuna does not store, so it gets them as JSON.
"""

import contextlib
import json
import math
from collections.abc import Mapping
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, did_you_mean, short
from quadruped_env.task.task_config import flat
from quadruped_env.training import TrainConfig

FIXED: Final = ("seed", "name", "checkpoint_seconds", "seconds", "task")
"""Fields of `TrainConfig` that do not vary."""
TASK: Final = "task."
"""Prefix of the names of the task's fields."""


def optuna_module() -> Any:
    """Import Optuna, without its messages about each trial."""
    try:
        import optuna
    except ImportError as error:
        raise MissingExtraError("A search over settings", "sweep") from error
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    return optuna


def parse_dimension(text: str, task: Mapping[str, Any]) -> tuple[str, Any]:
    """Return field and distribution from the text of `--vary`: a range, or two or more choices.

    Args:
        text: `FIELD=LOW..HIGH`, `FIELD=LOW..HIGH:log` or `FIELD=CHOICE,CHOICE`.
        task: the task's whole config, whose fields can vary.

    Raises:
        QuadrupedError: naming the field, the value and the fix.
    """
    name, _, values = (part.strip() for part in text.partition("="))
    known = {field: entry.default for field, entry in TrainConfig.__dataclass_fields__.items() if field not in FIXED}
    known |= flat(task, TASK)
    if name not in known:
        hint = did_you_mean(name, known) or "; fields of the task begin with 'task.', seeds are set with --seeds"
        raise QuadrupedError(f"sweep.vary {short(name)}: not a field that can vary{hint}")
    try:
        return name, _distribution(values, known[name])
    except ValueError as error:  # Optuna raises it, too
        raise QuadrupedError(
            f"sweep.vary {name}: expected LOW..HIGH, LOW..HIGH:log, or two or more choices with commas between them; "
            f"found {short(values)} ({error}); a single value is set with its option of 'train'"
        ) from error


def _distribution(values: str, default: Any) -> Any:
    """Return the distribution of a field with a default; a ValueError says what is wrong with the values."""
    distributions = optuna_module().distributions
    if ".." in values:
        ends, colon, scale = values.partition(":")
        low, high = map(float, ends.split(".."))
        if not low < high < math.inf or (colon and scale != "log"):
            raise ValueError("the lower end comes first")
        if type(default) is not int:
            return distributions.FloatDistribution(low, high, log=bool(colon))
        if not (low.is_integer() and high.is_integer()):
            raise ValueError("whole numbers are needed")
        return distributions.IntDistribution(int(low), int(high), log=bool(colon))
    choices: list[Any] = [part.strip() for part in values.split(",")]
    if not isinstance(default, str):
        with contextlib.suppress(ValueError):
            choices = json.loads(f"[{values}]")
    if isinstance(default, tuple) and isinstance(choices[0], str):  # widths of layers
        choices = [[int(width) for width in part.split("x")] for part in choices]
    listed = [json.dumps(choice) for choice in choices]
    if len(set(listed)) < max(2, len(listed)):
        raise ValueError("different choices are needed")
    return distributions.CategoricalDistribution(listed)


def size(distribution: Any) -> float:
    """Return the number of values; infinite for a range of real numbers."""
    if hasattr(distribution, "choices"):
        return len(distribution.choices)
    return distribution.high - distribution.low + 1 if isinstance(distribution.low, int) else math.inf


def ends(distribution: Any) -> list[Any]:
    """Return the choices, or both ends of the range."""
    if hasattr(distribution, "choices"):
        return [json.loads(choice) for choice in distribution.choices]
    return [distribution.low, distribution.high]


def shown(value: Any) -> str:
    """Return a value as text: widths of layers as 64x64, other values as JSON."""
    if isinstance(value, list) and value and all(isinstance(entry, int) for entry in value):
        return "x".join(map(str, value))
    if isinstance(value, float):
        return f"{value:.4g}"
    return value if isinstance(value, str) else json.dumps(value)


def in_words(values: Mapping[str, Any]) -> str:
    """Return the values of a setting as text; empty for seeds of one config."""
    return ", ".join(f"{name}={shown(value)}" for name, value in values.items())
