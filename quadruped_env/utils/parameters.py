"""Numbers of a registered function that the config can change: unit and valid range of each."""

import inspect
import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Annotated, Any, Final, get_args, get_origin

from quadruped_env.errors import QuadrupedError

LARGEST: Final = 1e9
"""Largest size of a number in a task's config, in its unit: far beyond any robot, and far from where squares, sums in
float32 and physics overflow."""
SMALLEST: Final = 1e-9
"""Lowest value of a number that must be positive: the square of its inverse is finite."""


def is_quantity(value: Any, low: float = -LARGEST, high: float = LARGEST) -> bool:
    """Return True if a value is an int or float between two bounds, and not a bool."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and low <= value <= high


@dataclass(frozen=True)
class Parameter:
    """Unit and valid range of a number in the config, used to annotate an argument of a registered function."""

    unit: str = "1"
    low: float = -LARGEST
    high: float = LARGEST
    exclusive: bool = False
    """True if `low` itself is not valid, nor what is closer to it than `SMALLEST`."""

    @classmethod
    def positive(cls, unit: str = "1") -> "Parameter":
        """Return a parameter whose values must be greater than 0."""
        return cls(unit, 0.0, exclusive=True)

    def scaled(self, factor: float) -> "Parameter":
        """Return a copy with the limits times a factor."""
        low, high = (bound if abs(bound) == LARGEST else bound * factor for bound in (self.low, self.high))
        return replace(self, low=low, high=high)

    def accepts(self, value: float) -> bool:
        """Return True if a number is valid."""
        return self.low + (SMALLEST if self.exclusive else 0.0) <= value <= self.high

    def rule(self) -> str:
        """Return valid values as text, for error messages."""
        unit = "" if self.unit == "1" else f" ({self.unit})"
        if self.high < LARGEST:
            high = "pi" if self.high == math.pi else f"{self.high:g}"
            return f"in {'(' if self.exclusive else '['}{self.low:g}, {high}]{unit}"
        if self.low <= -LARGEST:
            return f"a number from {-LARGEST:g} to {LARGEST:g}{unit}"
        if self.low == 0.0 and self.exclusive:
            return f"positive{unit}, {SMALLEST:g} or more"
        return f"{'over' if self.exclusive else 'at least'} {self.low:g}{unit}"


def parameters_of(function: Callable[..., Any]) -> dict[str, tuple[Parameter, float]]:
    """Return parameters of a function or class: its arguments after the first, which need a number as default.

    Raises:
        QuadrupedError: if such an argument has no default, or a default that is not a number.
    """
    found: dict[str, tuple[Parameter, float]] = {}
    # A class receives the context twice, in `__init__` and in `__call__`. Its parameters are `__init__`'s.
    for argument in list(inspect.signature(function).parameters.values())[1:]:
        default = argument.default
        if isinstance(default, bool) or not isinstance(default, (int, float)):
            raise QuadrupedError(
                f"{function.__name__}: argument {argument.name!r} needs a number as its default, which the config can "
                f"change; found {'none' if default is argument.empty else repr(default)}"
            )
        annotation = argument.annotation
        meant = get_args(annotation)[1:] if get_origin(annotation) is Annotated else ()
        parameter = next((entry for entry in meant if isinstance(entry, Parameter)), Parameter())
        found[argument.name] = parameter, float(default)
    return found


def stay_importable(function: Callable[..., Any]) -> None:
    """Make a function or class importable by name for pickling, although the term replaces it in the module."""
    function.__qualname__ = f"{function.__qualname__}.function"


def described(function: Callable[..., Any]) -> str:
    """Return the first line of a docstring."""
    return (function.__doc__ or "").strip().partition("\n")[0]
