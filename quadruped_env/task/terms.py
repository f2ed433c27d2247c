"""Reward terms and terminations: the decorators that create them, and their parts of the config."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated

from quadruped_env.task.context import TaskContext
from quadruped_env.utils.arrays import Bools, Floats
from quadruped_env.utils.fields import Section, check
from quadruped_env.utils.parameters import LARGEST, Parameter, described, is_quantity, parameters_of
from quadruped_env.utils.plain import plain

Term = Callable[..., Floats | Callable[[TaskContext], Floats]]
"""Function (context, parameters) -> (N,), or (N, K) for K terms; or a class, created with the context and the
parameters, and then called with the context."""
Condition = Callable[..., Bools | Callable[[TaskContext], Bools]]
"""Function (context, parameters) -> mask (N,), or a class as above."""


@dataclass(frozen=True)
class RewardTerm:
    """One reward term, or several that are computed together. Created by `reward` or `reward_group`."""

    weights: dict[str, float]
    """Default weight of each term by name, per second."""
    function: Term
    unit: str
    parameters: dict[str, tuple[Parameter, float]]
    description: str

    def __post_init__(self) -> None:
        object.__setattr__(self, "weights", plain(self.weights))
        for name, weight in self.weights.items():
            rule = f"a number from {-LARGEST:g} to {LARGEST:g}, per second, as in @reward(weight=-0.5)"
            check(is_quantity(weight), f"reward {name}: weight", weight, rule)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the terms, in the order of the columns."""
        return tuple(self.weights)

    def described(self, name: str) -> str:
        """Return the description of one of the terms: its line `name: ...` in the docstring, or else the first line."""
        lines = [line.strip() for line in (self.function.__doc__ or "").splitlines()]
        own = [line.partition(": ")[2] for line in lines if line.startswith(f"{name}: ")]
        return own[0] if own else self.description

    def __call__(self, *args: object, **kwargs: object) -> Floats | Callable[[TaskContext], Floats]:
        """Call the function, or create an instance of the class."""
        return self.function(*args, **kwargs)


@dataclass(frozen=True)
class Termination:
    """A condition that ends an episode as a fall. Created by `termination`."""

    name: str
    function: Condition
    parameters: dict[str, tuple[Parameter, float]]
    description: str

    def __call__(self, *args: object, **kwargs: object) -> Bools | Callable[[TaskContext], Bools]:
        """Return the mask (N,) of the envs whose episode ends, or an instance of the class."""
        return self.function(*args, **kwargs)


def reward(weight: float, unit: str = "1") -> Callable[[Term], RewardTerm]:
    """Decorator: a function (context) -> (N,) becomes a reward term of the same name.

    Arguments with a default, after the context, are parameters that the config can change. A class instead of
    a function is instantiated once per task with the context, and then called with it at every step. It must keep its
    state in arrays of `context.memory`.

    Args:
        weight: default weight, per second; negative for a penalty.
        unit: unit of the function's result.
    """
    return lambda function: _term({function.__name__: weight}, unit, function)


def reward_group(unit: str = "1", **weights: float) -> Callable[[Term], RewardTerm]:
    """Decorator: a function (context) -> (N, K) becomes K reward terms that are computed together.

    Args:
        unit: unit of the function's result.
        weights: default weight of each column by name, per second.
    """
    return lambda function: _term(weights, unit, function)


def _term(weights: dict[str, float], unit: str, function: Term) -> RewardTerm:
    return RewardTerm(weights, function, unit, parameters_of(function), described(function))


def termination(function: Condition) -> Termination:
    """Decorator: a function (context) -> bool (N,) becomes a termination of the same name."""
    return Termination(function.__name__, function, parameters_of(function), described(function))


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Weights(Section, path="config.reward.weights"):
    """Weight of every reward term by name, per second, in the order in which they are added."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class RewardSection(Section, path="config.reward"):
    """Weights and parameters of the reward terms; each parameter of a term is a field of its name, too."""

    weights: Mapping[str, float]
    velocity_time_constant: Annotated[float, Parameter.positive("s")] = 0.4
    """Time constant of the average velocity, s."""
    contact_threshold: Annotated[float, Parameter("N", 0.0)] = 1.0
    """Normal force above which a foot is in contact, N."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class TerminationSection(Section, path="config.termination"):
    """Parameters of the terminations, by name."""
