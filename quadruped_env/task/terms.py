"""Reward terms, terminations and their parameters, and the decorators that create them."""

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
    """Unit and valid range of a number in the config, used to annotate an argument of a term."""

    unit: str = "1"
    low: float = -math.inf
    high: float = math.inf
    exclusive: bool = False
    """True if `low` itself is not valid."""

    @classmethod
    def positive(cls, unit: str = "1") -> "Parameter":
        """Parameter whose values must be greater than 0."""
        return cls(unit, 0.0, exclusive=True)

    def accepts(self, value: float) -> bool:
        """True if a number is valid."""
        return (self.low < value if self.exclusive else self.low <= value) and value <= self.high

    def rule(self) -> str:
        """Valid values as text, for error messages."""
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
    """Parameters of a term's function or class: its arguments that have a number as default.

    Raises:
        QuadrupedError: if an argument after the context has no default, or a default that is not a number.
    """
    found: dict[str, tuple[Parameter, float]] = {}
    # A class receives the context twice, in `__init__` and in `__call__`. Its parameters are those of `__init__`.
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
    """One reward term, or several that are computed together. Created by `reward` or `reward_group`."""

    weights: dict[str, float]
    """Default weight of each term by name, per second."""
    function: Callable[..., Any]
    """Function (context) -> (N,), or (N, K) for K names; or a class, created and then called with the context."""
    unit: str
    parameters: dict[str, tuple[Parameter, float]]
    description: str

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the terms, in the order of the columns."""
        return tuple(self.weights)

    def described(self, name: str) -> str:
        """Description of one of the terms: its line `name: ...` in the docstring, or else the first line."""
        lines = [line.strip() for line in (self.function.__doc__ or "").splitlines()]
        own = [line.partition(": ")[2] for line in lines if line.startswith(f"{name}: ")]
        return own[0] if own else self.description

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        """Call the function, or create an instance of the class."""
        return self.function(*args, **kwargs)


@dataclass(frozen=True)
class Termination:
    """A condition that ends an episode as a fall. Created by `termination`."""

    name: str
    function: Callable[..., NDArray[np.bool_]]
    parameters: dict[str, tuple[Parameter, float]]
    description: str

    def __call__(self, *args: Any, **kwargs: Any) -> NDArray[np.bool_]:
        """Mask (N,) of the envs whose episode ends."""
        return self.function(*args, **kwargs)


def reward(weight: float, unit: str = "1") -> Callable[[Callable[..., Any]], RewardTerm]:
    """Decorator: a function (context) -> (N,) becomes a reward term of the same name.

    Arguments with a default, after the context, are parameters that the config can change. A class in place of a
    function is instantiated once per task with the context, and then called with it at every step. It must keep its
    state in arrays of `context.memory`.

    Args:
        weight: default weight, per second; negative for a penalty.
        unit: unit of the function's result.
    """

    def decorate(function: Callable[..., Any]) -> RewardTerm:
        return _term({function.__name__: weight}, unit, function)

    return decorate


def reward_group(unit: str = "1", **weights: float) -> Callable[[Callable[..., Any]], RewardTerm]:
    """Decorator: a function (context) -> (N, K) becomes K reward terms that are computed together.

    Args:
        unit: unit of the function's result.
        weights: default weight of each column by name, per second.
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
    """Make a function or class importable by name for pickling, although the term replaces it in the module."""
    function.__qualname__ = f"{function.__qualname__}.function"


def described(function: Callable[..., Any]) -> str:
    """First line of a docstring."""
    return (function.__doc__ or "").strip().partition("\n")[0]
