"""Fields of configs: frozen dataclasses whose values their annotations check, made from nested plain values.

The annotation of a field says what it takes: a number or a whole number, a pair (low, high), one of several words,
another config. A `Parameter` in it, as in `Annotated[float, Parameter.positive("m")]`, gives unit and limits; a
function in it, called with the value and its path, converts the value itself.
"""

import dataclasses
import functools
import typing
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping
from types import NoneType, UnionType
from typing import Annotated, Any, ClassVar, Literal, Self, TypeVar

from quadruped_env.errors import QuadrupedError, did_you_mean, short
from quadruped_env.utils.parameters import LARGEST, Parameter
from quadruped_env.utils.plain import Plain, plain

Kind = TypeVar("Kind")
SectionKind = TypeVar("SectionKind", bound="Section")
Range = tuple[float, float]
"""A pair (low, high) with low <= high."""
Amplitude = float | Range | None
"""A pair (low, high); a number x, 0 or more, that stands for (-x, x); or None."""


class Fields:
    """Base of a config's frozen dataclasses: values are converted and checked when one is created.

    A subclass names its place in the config, `class ActionConfig(Fields, path="config.action")`, and calls
    `super().__post_init__()` before checks of its own.

    Raises:
        QuadrupedError: if a value is not valid; the message names the field, the value and the rule.
    """

    path: ClassVar[str] = "config"
    """Place in the config, for messages."""

    def __init_subclass__(cls, path: str = "", **kwargs: object) -> None:
        super().__init_subclass__(**kwargs)
        if path:
            cls.path = path

    def __post_init__(self) -> None:
        for name, hint in hints_of(type(self)).items():
            object.__setattr__(self, name, converted(getattr(self, name), hint, f"{type(self).path}.{name}"))

    def to_dict(self) -> dict[str, Plain]:
        """Return the nested plain values."""
        return {name: _to_plain(getattr(self, name)) for name in hints_of(type(self))}


class Section(Fields, Mapping[str, Any]):
    """A part of a task's config with fields that its terms add: attributes and items by name."""

    _again: ClassVar[Callable[[dict[str, Plain]], Mapping[str, Plain]]] = dict
    """Function that makes the section from its plain values; unpickling calls it, since pickle finds no class that was
    made while the program runs."""

    def __reduce__(self) -> tuple[object, ...]:
        return type(self)._again, (self.to_dict(),)

    def __deepcopy__(self, memo: dict[int, object]) -> Self:
        return self

    def __getitem__(self, name: str) -> Plain:
        if name not in hints_of(type(self)):
            raise KeyError(name)
        return getattr(self, name)

    def __iter__(self) -> Iterator[str]:
        return iter(hints_of(type(self)))

    def __len__(self) -> int:
        return len(hints_of(type(self)))

    def __hash__(self) -> int:
        return hash(tuple(self.items()))

    def __or__(self, changes: Mapping[str, Plain]) -> dict[str, Plain]:
        return {**self, **changes}

    def __repr__(self) -> str:
        changes = ", ".join(f"{name}={value!r}" for name, value in self.changes().items())
        return f"{type(self).path.rpartition('.')[2]}({changes})"

    def changes(self) -> dict[str, Plain]:
        """Return the values that are not the defaults; of a section within the section, its changes."""
        default = type(self)()
        changed = {name: value for name, value in self.items() if value != default[name]}
        return {name: value.changes() if isinstance(value, Section) else value for name, value in changed.items()}

    def replace(self, **changes: Plain) -> Self:
        """Return a copy with other values for some fields; raises a QuadrupedError as the constructor does."""
        return with_values(self, changes, type(self).path)


def extended(
    base: type[SectionKind], own: Mapping[str, tuple[Any, Plain]], again: Callable[..., Section] | None = None
) -> type[SectionKind]:
    """Return a section with more fields than `base`, or with other defaults.

    Args:
        base: the section; all of its fields must be given as keywords.
        own: annotation and default of each field by name.
        again: function that makes such a section from its plain values, which supports pickling.

    Raises:
        QuadrupedError: if a name cannot name a field.
    """
    for name in own:
        if not name.isidentifier() or (hasattr(base, name) and name not in hints_of(base)):
            raise QuadrupedError(f"{base.path}: {short(name)} cannot be the name of a field; choose another")
    fields = [(name, hint, default) for name, (hint, default) in own.items()]
    namespace = {} if again is None else {"_again": staticmethod(again)}
    return dataclasses.make_dataclass(
        base.__name__, fields, bases=(base,), namespace=namespace, frozen=True, eq=False, repr=False, kw_only=True
    )


def hints_of(kind: type) -> dict[str, Any]:
    """Return the annotation of each field that the constructor of a dataclass takes, by name."""
    return _hints(typing.cast(Hashable, kind))


@functools.cache
def _hints(kind: Any) -> dict[str, Any]:
    hints = typing.get_type_hints(kind, include_extras=True)
    return {entry.name: hints[entry.name] for entry in dataclasses.fields(kind) if entry.init}


def with_values(default: Kind, values: Plain, path: str) -> Kind:
    """Return a copy of a dataclass with nested plain values for some of its fields.

    Raises:
        QuadrupedError: if a field is unknown or a value is not valid; the message names it by its `path`.
    """
    if not isinstance(values, Mapping):
        raise QuadrupedError(f"{path}: expected a mapping of fields; found {short(values)}")
    hints = hints_of(type(default))
    check_names(values, hints, path)
    changes: dict[str, Any] = {}
    for name, value in values.items():
        present, place = getattr(default, name), f"{path}.{name}"
        if _is_config(present) and not _is_config(value):
            changes[name] = with_values(present, value, place)
        else:
            changes[name] = converted(value, hints[name], place)
    return dataclasses.replace(default, **changes)  # type: ignore[type-var]


def check_names(values: Mapping[str, Plain], valid: Iterable[str], path: str) -> None:
    """Raise a QuadrupedError if a mapping has a field that is not among the valid ones."""
    unknown = sorted(str(name) for name in set(values) - set(valid))
    if unknown:
        raise QuadrupedError(
            f"{path}: unknown field {short(unknown[0])}; valid fields are {', '.join(valid)}"
            f"{did_you_mean(unknown[0], valid)}"
        )


def converted(value: Plain, hint: Any, path: str) -> Plain:
    """Return a value as the annotation of its field says; NumPy's scalars and arrays become plain numbers and tuples.

    Raises:
        QuadrupedError: if it is not valid; the message names it by its `path`.
    """
    kind, metadata = _parts(hint)
    if _is_config(kind):
        return value if isinstance(value, kind) else with_values(kind(), value, path)
    parameter = Parameter()
    for entry in metadata:
        if isinstance(entry, Parameter):
            parameter = entry
        elif callable(entry):
            return entry(value, path)
    value, options = plain(value), typing.get_args(kind) if isinstance(kind, UnionType) else (kind,)
    if value is None and NoneType in options:
        return None
    if Range in options and (float not in options or isinstance(value, list)):
        return _pair(value, parameter, path)
    if typing.get_origin(kind) is Literal:
        return one_of(value, typing.get_args(kind), path)
    if bool in options:
        if not isinstance(value, bool):
            raise QuadrupedError(f"{path}: expected true or false; found {short(value)}")
        return value
    if int in options:
        valid = type(value) is int and parameter.accepts(value)
        check(valid, path, value, f"a whole number from {parameter.low:.0f} to {parameter.high:.0f}")
        return value
    if float not in options:
        return value
    result = _number(value, path)
    if Range in options:
        both = result >= 0.0 and parameter.accepts(result) and parameter.accepts(-result)
        check(both, path, result, f"0 or more, an amplitude x with x and -x {parameter.rule()}")
    check(parameter.accepts(result), path, result, parameter.rule())
    return result


def units_of(kind: type) -> dict[str, Plain]:
    """Return the unit of each field of a dataclass, nested for a dataclass within it."""
    found: dict[str, Plain] = {}
    for name, hint in hints_of(kind).items():
        own, _ = _parts(hint)
        found[name] = units_of(own) if _is_config(own) else unit_of(hint)
    return found


def unit_of(hint: Any) -> str:
    """Return the unit that an annotation gives."""
    return next((entry.unit for entry in _parts(hint)[1] if isinstance(entry, Parameter)), "1")


def known(values: Mapping[str, Plain], kind: type) -> dict[str, Plain]:
    """Return the part of nested values that a dataclass has fields for."""
    hints = {name: _parts(hint)[0] for name, hint in hints_of(kind).items()}
    return {
        name: known(value, hints[name])
        if isinstance(value, Mapping) and dataclasses.is_dataclass(hints[name])
        else value
        for name, value in values.items()
        if name in hints
    }


def check(condition: bool, path: str, value: object, rule: str) -> None:
    """Raise a QuadrupedError that names the field, the value and the rule, unless the condition holds."""
    if not condition:
        raise QuadrupedError(f"{path} must be {rule}; found {short(value)}")


def one_of(value: Plain, choices: Iterable[str], path: str) -> str:
    """Return a value that must be one of some words."""
    check(value in tuple(choices), path, value, f"one of {', '.join(choices)}")
    return str(value)


def _number(value: Plain, path: str) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise QuadrupedError(f"{path}: expected a number; found {short(value)}")
    if not abs(value) <= LARGEST:
        raise QuadrupedError(f"{path}: expected a number from {-LARGEST:g} to {LARGEST:g}; found {short(value)}")
    return float(value)


def _pair(value: Plain, parameter: Parameter, path: str) -> Range:
    if not isinstance(value, list) or len(value) != 2:
        raise QuadrupedError(f"{path}: expected a pair (low, high); found {short(value)}")
    low, high = (_number(entry, path) for entry in value)
    check(low <= high, path, (low, high), "a pair (low, high) with low <= high")
    check(parameter.accepts(low) and parameter.accepts(high), path, (low, high), parameter.rule())
    return low, high


def _is_config(kind: Any) -> bool:
    return dataclasses.is_dataclass(kind)


def _parts(hint: Any) -> tuple[Any, tuple[Any, ...]]:
    """Return the type of an annotation, and what `Annotated` adds to it."""
    return (hint.__origin__, hint.__metadata__) if typing.get_origin(hint) is Annotated else (hint, ())


def _to_plain(value: Any) -> Plain:
    if isinstance(value, Fields):
        return value.to_dict()
    return dataclasses.asdict(value) if dataclasses.is_dataclass(value) and not isinstance(value, type) else value
