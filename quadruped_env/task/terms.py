"""What a reward term, a termination, a randomization and a command are, and the decorators that make them."""

import inspect
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any, get_args, get_origin

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Parameter:
    """A number in the config: its unit and what it may be. Annotate an argument of a term with it."""

    unit: str = "1"
    low: float = -math.inf
    high: float = math.inf
    exclusive: bool = False
    """Whether `low` itself is not valid"""

    @classmethod
    def positive(cls, unit: str = "1") -> "Parameter":
        """Any number over 0."""
        return cls(unit, 0.0, exclusive=True)

    def accepts(self, value: float) -> bool:
        """Whether a number is valid."""
        return (self.low < value if self.exclusive else self.low <= value) and value <= self.high

    def rule(self) -> str:
        """What is valid, in words."""
        unit = "" if self.unit == "1" else f" ({self.unit})"
        if self.high < math.inf:
            high = "pi" if self.high == math.pi else f"{self.high:g}"
            return f"in {'(' if self.exclusive else '['}{self.low:g}, {high}]{unit}"
        if self.low == -math.inf:
            return f"a finite number{unit}"
        if self.low == 0.0 and self.exclusive:
            return f"positive{unit}"
        return f"{'over' if self.exclusive else 'at least'} {self.low:g}{unit}"


def parameters_of(function: Callable[..., Any]) -> dict[str, tuple[Parameter, float]]:
    """The parameters of a term's function or class: its arguments that have a number as default.

    Raises:
        QuadrupedError: if an argument behind the context has no default, or one that is no number.
    """
    found: dict[str, tuple[Parameter, float]] = {}
    # A class takes the context twice: when it is made and when it is called. Its parameters are those of `__init__`.
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


@dataclass(frozen=True)
class RewardTerm:
    """One reward term, or several that are computed together. Made by `reward` or `reward_group`."""

    weights: dict[str, float]
    """Name -> default weight, per second"""
    function: Callable[..., Any]
    """(context) -> (N,), or (N, K) for K names; or a class, made with (context) and then called with it"""
    unit: str
    parameters: dict[str, tuple[Parameter, float]]
    description: str

    @property
    def names(self) -> tuple[str, ...]:
        """In the order of the columns."""
        return tuple(self.weights)

    def described(self, name: str) -> str:
        """What one of the terms is: its line `name: ...` of the docstring, or else the first line."""
        lines = [line.strip() for line in (self.function.__doc__ or "").splitlines()]
        own = [line.partition(": ")[2] for line in lines if line.startswith(f"{name}: ")]
        return own[0] if own else self.description

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        """Compute it."""
        return self.function(*args, **kwargs)


@dataclass(frozen=True)
class Termination:
    """A condition that ends an episode as a fall. Made by `termination`."""

    name: str
    function: Callable[..., NDArray[np.bool_]]
    parameters: dict[str, tuple[Parameter, float]]
    description: str

    def __call__(self, *args: Any, **kwargs: Any) -> NDArray[np.bool_]:
        """Whether each env's episode ends, (N,)."""
        return self.function(*args, **kwargs)


def reward(weight: float, unit: str = "1") -> Callable[[Callable[..., Any]], RewardTerm]:
    """Decorator: a function (context) -> (N,) becomes a reward term of the same name.

    Arguments with a default, behind the context, are parameters that the config can change. A class in place of a
    function is made once per task with the context, and then called with it; what it remembers it gets from
    `context.memory`.

    Args:
        weight: default weight, per second; negative for a penalty.
        unit: of what the function returns.
    """

    def decorate(function: Callable[..., Any]) -> RewardTerm:
        return _term({function.__name__: weight}, unit, function)

    return decorate


def reward_group(unit: str = "1", **weights: float) -> Callable[[Callable[..., Any]], RewardTerm]:
    """Decorator: a function (context) -> (N, K) becomes K reward terms that are computed together.

    Args:
        unit: of what the function returns.
        weights: name and default weight (per second) of each column.
    """

    def decorate(function: Callable[..., Any]) -> RewardTerm:
        return _term(weights, unit, function)

    return decorate


def _term(weights: dict[str, float], unit: str, function: Callable[..., Any]) -> RewardTerm:
    _stay_importable(function)
    return RewardTerm(weights, function, unit, parameters_of(function), described(function))


def termination(function: Callable[..., Any]) -> Termination:
    """Decorator: a function (context) -> bool (N,) becomes a termination of the same name."""
    _stay_importable(function)
    return Termination(function.__name__, function, parameters_of(function), described(function))


def _stay_importable(function: Callable[..., Any]) -> None:
    """Let a function or class be pickled by name, though the term has taken its name in the module."""
    function.__qualname__ = f"{function.__qualname__}.function"


def described(function: Callable[..., Any]) -> str:
    """First line of a docstring."""
    return (function.__doc__ or "").strip().partition("\n")[0]
