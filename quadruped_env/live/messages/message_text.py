"""Messages as text, as `ros2 topic echo --full-length` prints them."""

from dataclasses import asdict
from typing import Any, Final

import numpy as np

from quadruped_env.errors import MissingExtraError, QuadrupedError

_WIDTH: Final = 2**31 - 1
"""Maximum line width in characters: the largest that the YAML library accepts, so that no line is broken."""

_HIDDEN: Final = ("__msgtype__", "structure_needs_at_least_one_member")
"""Fields that are no content: the type's name, and the member of a type that has none."""


def plain(message: Any) -> dict[str, Any]:
    """Return a message of `quadruped_env.ros.cdr` as dicts, lists, numbers and strings, in its type's field order."""
    return asdict(message, dict_factory=_plain_fields)


def _plain_fields(fields: list[tuple[str, Any]]) -> dict[str, Any]:
    return {
        name: value.tolist() if isinstance(value, np.ndarray) else value
        for name, value in fields
        if name not in _HIDDEN
    }


def field_at(values: Any, path: str) -> Any:
    """Return one field of a message.

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
    """Return YAML with one line per list item, and the `---` line that ends a message.

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


def _count(values: Any) -> str:
    return f"a list of {len(values)}" if isinstance(values, list) else "a single value"
