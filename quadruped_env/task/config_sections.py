"""Sections of the config whose fields depend on the task's terms: frozen, validated, with fields by name."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Self, cast

from quadruped_env.control.control_config import check, check_range
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.utils.parameters import LARGEST, Parameter
from quadruped_env.utils.plain import Plain, plain


@dataclass(frozen=True)
class Entry:
    """One field of a section."""

    default: Plain
    convert: Callable[[Plain, str], Plain]
    """Function (value, path in the config) -> converted value; raises a QuadrupedError if the value is not valid."""
    unit: str = "1"


Schema = Mapping[str, Entry]


def units_of(schema: Schema) -> dict[str, Plain]:
    """Unit of each field, nested for a section within the section."""
    return {
        name: units_of(entry.default.schema) if isinstance(entry.default, Section) else entry.unit
        for name, entry in schema.items()
    }


class Section(Mapping[str, Plain]):
    """One section of a task's config. Fields are attributes and items; `replace` returns a changed copy.

    Args:
        name: name of the section, for error messages.
        schema: fields of the section.
        values: values of some fields; the others have their defaults.
        remake: function that creates the section from its values, with all checks, when it is changed or unpickled;
            None: there are no further checks, and unpickling gives a dict.

    Raises:
        QuadrupedError: if a field is unknown or a value is not valid; the message says what is valid.
    """

    __slots__ = ("_name", "_remake", "_schema", "_values")

    def __init__(
        self, name: str, schema: Schema, values: Plain, remake: Callable[[dict[str, Plain]], "Section"] | None = None
    ) -> None:
        if not isinstance(values, Mapping):
            raise QuadrupedError(f"config.{name}: expected a mapping of fields; found {short(values)}")
        unknown = sorted(str(field) for field in set(values) - set(schema))
        if unknown:
            raise QuadrupedError(
                f"config.{name}: unknown field {short(unknown[0])}; valid fields are {', '.join(schema)}"
            )
        self._name, self._schema, self._remake = name, schema, remake
        self._values = {
            field: entry.convert(plain(values[field]), f"config.{name}.{field}") if field in values else entry.default
            for field, entry in schema.items()
        }

    def __getitem__(self, field: str) -> Plain:
        return self._values[field]

    def __getattr__(self, field: str) -> Plain:
        # Copying and unpickling look up attributes before `_values` exists.
        if field.startswith("_") or field not in self._values:
            raise AttributeError(f"config.{self._name} has no field {field!r}")
        return self._values[field]

    def __setattr__(self, field: str, value: Plain) -> None:
        if field not in self.__slots__:
            raise AttributeError(f"config.{self._name}.{field}: a config is frozen; use replace({field}=...)")
        object.__setattr__(self, field, value)

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mapping) and self._values == dict(other)

    def __hash__(self) -> int:
        return hash((self._name, repr(self._values)))

    def __repr__(self) -> str:
        return f"{self._name}({', '.join(f'{field}={value!r}' for field, value in self.changes().items())})"

    def __or__(self, changes: Mapping[str, Plain]) -> dict[str, Plain]:
        return {**self._values, **changes}

    def __reduce__(self) -> Plain:
        return self._remake or dict, (self.to_dict(),)

    def __deepcopy__(self, memo: dict[int, Plain]) -> Self:
        return self

    def replace(self, **changes: Plain) -> Self:
        """A copy of the section with other values for some fields; raises a QuadrupedError as the constructor does."""
        if self._remake is None:
            return type(self)(self._name, self._schema, self._values | changes)
        # Without the defaults, some of which depend on other fields.
        return cast(Self, self._remake(self.changes() | changes))

    def changes(self) -> dict[str, Plain]:
        """The values that are not the defaults; of a section within the section, its changes."""
        changed = {field: value for field, value in self._values.items() if value != self._schema[field].default}
        return {field: value.changes() if isinstance(value, Section) else value for field, value in changed.items()}

    @property
    def schema(self) -> Schema:
        """Fields of the section, with their defaults and units."""
        return self._schema

    def to_dict(self) -> dict[str, Plain]:
        """Plain values for JSON."""
        return {field: dict(value) if isinstance(value, Mapping) else value for field, value in self._values.items()}


def number(value: Plain, path: str, whole: bool = False) -> float:
    """Convert a value of the config to a number; one that need not be whole is at most `LARGEST` in size.

    Raises:
        QuadrupedError: if it is not one.
    """
    if isinstance(value, bool) or not isinstance(value, (int, float)) or (whole and not isinstance(value, int)):
        raise QuadrupedError(f"{path}: expected {'a whole number' if whole else 'a number'}; found {short(value)}")
    if not (whole or abs(value) <= LARGEST):
        raise QuadrupedError(f"{path}: expected a number from {-LARGEST:g} to {LARGEST:g}; found {short(value)}")
    return value if whole else float(value)


def pair(value: Plain, path: str) -> tuple[float, float]:
    """Convert a value of the config to a pair (low, high) with low <= high.

    Raises:
        QuadrupedError: if it is not one.
    """
    if not isinstance(value, (list, tuple)) or len(value) != 2:
        raise QuadrupedError(f"{path}: expected a pair (low, high); found {short(value)}")
    low, high = (number(item, path) for item in value)
    check_range(_field(path), (low, high))
    return low, high


def parameter_entry(parameter: Parameter, default: float) -> Entry:
    """Field for a number within the limits of a parameter."""

    def convert(value: Plain, path: str) -> float:
        converted = number(value, path)
        check(parameter.accepts(converted), _field(path), converted, parameter.rule())
        return converted

    return Entry(default, convert, parameter.unit)


def seed_entry(default: int) -> Entry:
    """Field for a seed."""

    def convert(value: Plain, path: str) -> int:
        valid = type(value) is int and 0 <= value < 2**32
        check(valid, _field(path), value, "a whole number, 0 or more, at most 4294967295")
        return int(value)

    return Entry(default, convert)


def section_entry(name: str, schema: Schema) -> Entry:
    """Field for a section within the section."""
    return Entry(Section(name, schema, {}), lambda value, path: Section(name, schema, value))


def range_entry(default: tuple[float, float] | None, parameter: Parameter, optional: bool = False) -> Entry:
    """Field for a pair (low, high) within the limits of a parameter, or None if it is optional."""

    def convert(value: Plain, path: str) -> tuple[float, float] | None:
        if value is None and optional:
            return None
        low, high = pair(value, path)
        check(parameter.accepts(low) and parameter.accepts(high), _field(path), (low, high), parameter.rule())
        return low, high

    return Entry(default, convert, parameter.unit)


def amplitude_entry(default: float, unit: str, parameter: Parameter) -> Entry:
    """Field for a pair (low, high), a number x, 0 or more, that stands for (-x, x), or None; each end is checked."""

    def convert(value: Plain, path: str) -> float | tuple[float, float] | None:
        if value is None:
            return None
        if isinstance(value, (list, tuple)):
            low, high = pair(value, path)
            check(parameter.accepts(low) and parameter.accepts(high), _field(path), (low, high), parameter.rule())
            return low, high
        converted = number(value, path)
        check(converted >= 0, _field(path), converted, "at least 0" if unit == "1" else f"at least 0 ({unit})")
        valid = parameter.accepts(converted) and parameter.accepts(-converted)
        check(valid, _field(path), converted, f"an amplitude x with x and -x {parameter.rule()}")
        return converted

    return Entry(default, convert, unit)


def _field(path: str) -> str:
    return path.removeprefix("config.")
