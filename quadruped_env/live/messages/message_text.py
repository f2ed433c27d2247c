"""Messages as text, as `ros2 topic echo --full-length` prints them."""

from collections.abc import Iterator
from typing import Any, Final

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.ros import message_type

_WIDTH: Final = 2**31 - 1
"""Maximum line width in characters: the largest that the YAML library accepts, so that no line is broken."""

_PLACEHOLDER: Final = "structure_needs_at_least_one_member"
"""Field of a type that has none."""


def plain(message: Any) -> dict[str, Any]:
    """A message of `quadruped_env.ros.cdr` as dicts, lists, numbers and strings, in the field order of its type."""
    values = {}
    for field in message_type(message.__msgtype__).fields:
        if field.name == _PLACEHOLDER:
            continue
        value = getattr(message, field.name)
        if field.is_message:
            value = [plain(one) for one in value] if field.many else plain(value)
        elif field.many:
            value = list(value) if field.base == "string" else value.tolist()
        values[field.name] = value
    return values


def field_at(values: Any, path: str) -> Any:
    """One field of a message.

    Args:
        values: the result of `plain`.
        path: field names separated by dots; a number indexes a list. Empty means the whole message.

    Raises:
        QuadrupedError: if there is no such field.
    """
    for name in filter(None, path.split(".")):
        if isinstance(values, dict) and name in values:
            values = values[name]
        elif isinstance(values, list) and name.isdecimal() and int(name) < len(values):
            values = values[int(name)]
        else:
            there = ", ".join(values) if isinstance(values, dict) else _count(values)
            raise QuadrupedError(f"--field {path}: there is no {name!r}; there is {there}")
    return values


def as_yaml(values: Any) -> str:
    """YAML with one line per list item, and the `---` line that ends a message.

    Raises:
        MissingExtraError: if PyYAML is not installed.
    """
    try:
        import yaml
    except ImportError as error:
        raise MissingExtraError("printing messages", "ros") from error
    text = yaml.dump(
        values, Dumper=yaml.CSafeDumper, default_flow_style=False, sort_keys=False, allow_unicode=True, width=_WIDTH
    )
    # For a single value PyYAML adds the end-of-document mark.
    return text.removesuffix("...\n") + "---\n"


def as_csv(values: Any) -> str:
    """All values in one CSV line; an empty list becomes one empty cell."""
    return f"{','.join(_cells(values))}\n"


def _cells(values: Any) -> Iterator[str]:
    if isinstance(values, dict):
        values = list(values.values())
    if isinstance(values, list):
        for one in values or [""]:
            yield from _cells(one)
    else:
        yield str(values)


def _count(values: Any) -> str:
    return f"a list of {len(values)}" if isinstance(values, list) else "a single value"
