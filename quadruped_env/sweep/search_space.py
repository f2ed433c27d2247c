"""The space of a sweep: fields of task and training that vary, each with a range or with choices.

A field of the training is named as in `TrainConfig`, a field of the task's config by `task.` and its path, as in
`task.reward.weights.foot_slip`.
"""

import contextlib
import dataclasses
import difflib
import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.training import TrainConfig
from quadruped_env.utils.documents import read_json, read_toml
from quadruped_env.utils.parameters import is_quantity

FIXED: Final = {
    "seed": "the number of seeds is set with --seeds, the first one with --seed",
    "name": "it is part of the directory's name",
    "checkpoint_seconds": "it changes no policy",
    "seconds": "trials are compared after equal numbers of steps; vary timesteps",
    "task": "name a field of it, such as task.reward.weights.foot_slip",
}
"""Fields of `TrainConfig` that do not vary -> reason or fix."""
TASK: Final = "task."
"""Beginning of the names of the task's fields."""
_LEAF: Final = {"low", "high", "log", "choices"}


@dataclass(frozen=True)
class Dimension:
    """One field of a space: a range of numbers, or choices."""

    field: str
    low: Any = None
    high: Any = None
    log: bool = False
    """True to draw the logarithm uniformly."""
    choices: tuple[Any, ...] = ()

    def __post_init__(self) -> None:
        numbers = is_quantity(self.low) and is_quantity(self.high)
        if not self.choices and not (numbers and (0 if self.log else -math.inf) < self.low < self.high):
            raise QuadrupedError(
                f"{short(self.field)}: expected choices, or low below high{', above 0' if self.log else ''}; found "
                f"{short(self.low)} and {short(self.high)}"
            )

    def holds(self, value: Any) -> bool:
        """True if `draw` could have given a value, which is from JSON."""
        return of_json(value) in self.choices if self.choices else is_quantity(value, self.low, self.high)

    @property
    def whole(self) -> bool:
        """True if the range is one of whole numbers."""
        return isinstance(self.low, int) and isinstance(self.high, int)

    def draw(self, generator: np.random.Generator) -> Any:
        """A random value."""
        if self.choices:
            return self.choices[int(generator.integers(len(self.choices)))]
        if self.log:
            value = math.exp(generator.uniform(math.log(self.low), math.log(self.high)))
            return min(max(round(value) if self.whole else value, self.low), self.high)
        if self.whole:
            return int(generator.integers(self.low, self.high, endpoint=True))
        return float(generator.uniform(self.low, self.high))

    def ends(self) -> tuple[Any, ...]:
        """The choices, or both ends of the range."""
        return self.choices or (self.low, self.high)

    def to_dict(self) -> dict[str, Any]:
        """Plain values: `choices`, or `low`, `high` and `log`."""
        if self.choices:
            return {"choices": list(self.choices)}
        return {"low": self.low, "high": self.high, "log": self.log}

    def __str__(self) -> str:
        if self.choices:
            return f"{self.field}={','.join(shown(value) for value in self.choices)}"
        return f"{self.field}={self.low:g}..{self.high:g}{':log' if self.log else ''}"


def _are_widths(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and bool(value) and all(isinstance(entry, int) for entry in value)


def shown(value: Any) -> str:
    """A value in words and tables: widths of layers as 64x64, other values as JSON."""
    if _are_widths(value):
        return "x".join(map(str, value))
    if isinstance(value, float):
        return f"{value:.4g}"
    return value if isinstance(value, str) else json.dumps(value)


def parse_dimension(text: str, task: Mapping[str, Any]) -> Dimension:
    """A dimension from the text of `--vary`: `FIELD=LOW..HIGH`, `FIELD=LOW..HIGH:log` or `FIELD=CHOICE,CHOICE`.

    Args:
        text: as typed.
        task: the task's whole config, whose fields can vary.

    Raises:
        QuadrupedError: naming the field, the value and the fix.
    """
    name, found, values = text.partition("=")
    name = name.strip()
    if not found or not values.strip():
        raise QuadrupedError(
            f"--vary: expected FIELD=LOW..HIGH, FIELD=LOW..HIGH:log or FIELD=CHOICE,CHOICE; found {short(text)}"
        )
    where, default = f"--vary {name}", default_of(name, task, "--vary")
    if ".." not in values:
        return _choices(where, name, _listed(where, values, default), default)
    ends, _, scale = values.strip().partition(":")
    if scale not in ("", "log"):
        raise QuadrupedError(f"{where}: expected ':log' or nothing after the range; found {short(scale)}")
    low, high = (_typed(where, end, default) for end in ends.split("..", 1))
    return _range(where, name, low, high, scale == "log", default)


def read_space(path: Path, task: Mapping[str, Any]) -> list[Dimension]:
    """The dimensions in a TOML or JSON file.

    Each field has a table with `low`, `high` and perhaps `log`, or with `choices`. Tables may be nested instead of dots
    in names.

    Raises:
        QuadrupedError: naming the file, the field, the value and the fix.
    """
    document = read_json(path) if path.suffix == ".json" else read_toml(path)
    if not isinstance(document, dict) or not document:
        raise QuadrupedError(f"{path}: expected a table of fields, such as learning_rate = {{low = 1e-4, high = 1e-2}}")
    return [_of_table(path, name, table, task) for name, table in _flat(path, document)]


def of_dict(field: str, values: Mapping[str, Any]) -> Dimension:
    """The dimension with the plain values of `Dimension.to_dict`."""
    choices = of_json(list(values.get("choices", ())))
    return Dimension(field, values.get("low"), values.get("high"), bool(values.get("log", False)), choices)


def of_json(value: Any) -> Any:
    """A value from JSON as `Dimension.draw` gives it, with tuples for lists."""
    return tuple(map(of_json, value)) if isinstance(value, list) else value


def default_of(name: str, task: Mapping[str, Any], option: str) -> Any:
    """Default of a field that can vary: of `TrainConfig`, or the value of a field of the task's config.

    Raises:
        QuadrupedError: if there is no such field, or it cannot vary; similar names are suggested.
    """
    if name.startswith(TASK):
        value: Any = task
        path = TASK[:-1]
        for part in name.removeprefix(TASK).split("."):
            if not isinstance(value, Mapping) or part not in value:
                known = [f"{path}.{key}" for key in value] if isinstance(value, Mapping) else []
                raise _unknown(option, name, f"{path}.{part}", known, path)
            value, path = value[part], f"{path}.{part}"
        if isinstance(value, Mapping):
            examples = ", ".join(f"{path}.{key}" for key in list(value)[:3])
            raise QuadrupedError(f"{option} {name}: found a section; name one of its fields, such as {examples}")
        return value
    fields = {field.name: field.default for field in dataclasses.fields(TrainConfig)}
    if name in FIXED:
        raise QuadrupedError(f"{option} {name}: this field cannot vary: {FIXED[name]}")
    if name not in fields:
        raise _unknown(option, name, name, [key for key in fields if key not in FIXED], "the training")
    return fields[name]


def _unknown(option: str, name: str, found: str, known: Sequence[str], where: str) -> QuadrupedError:
    # Without the section, which all of them share.
    last = {field.rpartition(".")[2]: field for field in known}
    near = [last[field] for field in difflib.get_close_matches(found.rpartition(".")[2], last, 3)]
    hint = f"similar fields: {', '.join(near)}" if near else f"fields of {where}: {', '.join(known)}"
    return QuadrupedError(
        f"{option} {name}: unknown field {short(found)}; {hint}; names of the task's fields begin with 'task.'"
    )


def _listed(where: str, text: str, default: Any) -> Sequence[Any]:
    """Choices as typed on the command line, separated by commas."""
    if not isinstance(default, str) and not _are_widths(default):
        with contextlib.suppress(ValueError):
            listed: Sequence[Any] = of_json(json.loads(f"[{text}]"))
            return listed
    parts = [part.strip() for part in text.split(",")]
    if not all(parts):
        raise QuadrupedError(f"{where}: an empty choice in {short(text)}; separate the choices with one comma each")
    return [_typed(where, part, default) for part in parts]


def _typed(where: str, text: str, default: Any) -> Any:
    """A value as typed on the command line, as the field's default has it."""
    if _are_widths(default):
        try:
            return tuple(int(width) for width in text.split("x"))
        except ValueError:
            raise QuadrupedError(f"{where}: expected widths such as 64x64; found {short(text)}") from None
    if isinstance(default, str):
        return text.strip('"')
    for parse in (json.loads, float):  # JSON takes 1e-4, but not .5
        with contextlib.suppress(ValueError):
            return of_json(parse(text))
    return text


def _of_table(path: Path, name: str, table: Mapping[str, Any], task: Mapping[str, Any]) -> Dimension:
    where = f"{path}: {name}"
    default = default_of(name, task, f"{path}:")
    if "choices" in table:
        if set(table) != {"choices"} or not isinstance(table["choices"], list):
            raise QuadrupedError(
                f"{where}: expected choices = [...] alone, or low and high; found {short(dict(table))}"
            )
        return _choices(where, name, of_json(table["choices"]), default)
    if not {"low", "high"} <= set(table) or not isinstance(table.get("log", False), bool):
        raise QuadrupedError(f"{where}: expected low, high and perhaps log = true; found {short(dict(table))}")
    return _range(where, name, table["low"], table["high"], table.get("log", False), default)


def _flat(path: Path, table: Mapping[str, Any], above: str = "") -> Iterable[tuple[str, Mapping[str, Any]]]:
    for key, value in table.items():
        name = f"{above}{key}"
        if not isinstance(value, Mapping):
            raise QuadrupedError(
                f"{path}: {name}: expected a table such as {{low = 0.0, high = 1.0}} or {{choices = [1, 2]}}; found "
                f"{short(value)}"
            )
        if set(value) & _LEAF and set(value) <= _LEAF:
            yield name, value
        else:
            yield from _flat(path, value, f"{name}.")


def _range(where: str, name: str, low: Any, high: Any, log: bool, default: Any) -> Dimension:
    if isinstance(default, bool) or not (default is None or isinstance(default, (int, float))):
        raise QuadrupedError(
            f"{where}: found a range, but the field is not a number (default: {shown(default)}); give choices, "
            f"separated by commas"
        )
    kind = 0.0 if default is None else default
    low, high = (_converted(f"{where}: {end}", value, kind) for end, value in (("low", low), ("high", high)))
    if low >= high:
        fix = f"swap the ends: {high:g}..{low:g}" if low > high else "give two different ends, or leave the field out"
        raise QuadrupedError(
            f"{where}: expected a range from the lower to the higher end; found {low:g}..{high:g}; {fix}"
        )
    if log and low <= 0:
        raise QuadrupedError(f"{where}: a logarithmic range needs ends above 0; found {low:g}; leave :log out")
    return Dimension(name, low, high, log)


def _choices(where: str, name: str, values: Sequence[Any], default: Any) -> Dimension:
    unique: list[Any] = []
    for given in values:
        value = _converted(where, given, default)
        if value in unique:
            raise QuadrupedError(f"{where}: the choice {shown(value)} is found twice; give each once")
        unique.append(value)
    if len(unique) < 2:
        raise QuadrupedError(
            f"{where}: expected two or more choices, or a range LOW..HIGH; found {', '.join(map(shown, unique))}; set "
            f"a single value with its option of 'train'"
        )
    return Dimension(name, choices=tuple(unique))


def _converted(where: str, value: Any, default: Any) -> Any:
    """A value as the type of the field's default.

    Raises:
        QuadrupedError: if it has another type.
    """
    numeric = isinstance(value, (int, float)) and not isinstance(value, bool)
    if isinstance(default, bool):
        kind, valid = "true or false", isinstance(value, bool)
    elif isinstance(default, int):
        kind, valid = "a whole number", numeric and float(value).is_integer()
    elif isinstance(default, float):
        kind, valid = "a number", numeric
    elif isinstance(default, str):
        kind, valid = "a name", isinstance(value, str)
    elif isinstance(default, (list, tuple)):
        kind, valid = "a list such as [0.6, 1.0]", isinstance(value, (list, tuple)) or value is None or numeric
    else:
        return value
    if not valid:
        raise QuadrupedError(f"{where}: expected {kind}; found {short(value)}")
    return type(default)(value) if isinstance(default, (int, float)) else value
