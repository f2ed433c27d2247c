"""Conversion of NumPy values to plain Python ones, and checks of numbers given by a caller."""

import dataclasses
import enum
from typing import Any, Final

import numpy as np

from quadruped_env.errors import QuadrupedError

Plain = Any
"""A value as JSON takes it, such as a field of a config: number, text, None, or lists and mappings of these."""

_PLAIN: Final = frozenset({float, int, str, bool, type(None)})


def plain(value: Any) -> Any:
    """Return the same value as JSON takes it.

    NumPy scalars become Python's numbers, arrays, tuples and lists become lists, enums their values, dataclasses dicts.
    Everything else stays as it is.
    """
    if type(value) in _PLAIN:  # the most frequent case and the cheapest check
        return value
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    if isinstance(value, dict):
        return {plain(key): plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    if isinstance(value, enum.Enum):
        return value.value
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return plain(dataclasses.asdict(value))
    return value


def whole_number(name: str, value: Any, low: int, or_none: bool = False) -> int:
    """Return a value as a Python int.

    Args:
        name: the argument's name, for the error.
        value: an int or a NumPy integer.
        low: least valid value.
        or_none: whether the error lists None as valid; None itself is for the caller to let through.

    Raises:
        QuadrupedError: if it is not an integer, is a bool, or is less than low.
    """
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool) and value >= low:
        return int(value)
    none = ", or None" if or_none else ""
    raise QuadrupedError(f"{name}: expected a whole number, {low} or more{none}; found {value!r}")
