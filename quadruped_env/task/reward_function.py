"""Computation of the reward terms and terminations of a task."""

import functools
import inspect
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from quadruped_env.control.observations import ObservationLayout
from quadruped_env.errors import QuadrupedError
from quadruped_env.task.context import TaskContext
from quadruped_env.task.terms import RewardSection, RewardTerm, Termination, TerminationSection
from quadruped_env.utils.arrays import Bools, Floats
from quadruped_env.utils.fields import Section, check


class RewardFunction:
    """Weighted reward terms of a task, in their order. A term whose weights are 0 is not computed, and counts as 0."""

    def __init__(self, terms: Sequence[RewardTerm], config: RewardSection, context: TaskContext) -> None:
        self.names = tuple(name for term in terms for name in term.names)
        self._weights = np.array([config.weights[name] for name in self.names])[:, None] * context.timestep
        self._weights.setflags(write=False)
        self._functions = [(term, _with_parameters(term, config, context)) for term in terms]
        self._paid: list[tuple[int | slice, Callable[[TaskContext], Floats]]] = []
        """Function of each term that counts, with its index among the terms, or their slice."""
        start = 0
        for term, function in self._functions:
            stop = start + len(term.names)
            if any(config.weights[name] for name in term.names):
                self._paid.append((start if stop == start + 1 else slice(start, stop), function))
            start = stop
        self._values = np.zeros((len(self.names), len(context.velocity)))

    def __call__(self, context: TaskContext) -> Floats:
        """Return the weighted terms (T, N) in a new array."""
        for index, function in self._paid:
            self._values[index] = function(context).T
        return self._values * self._weights

    def check(self, context: TaskContext) -> None:
        """Compute every term once, to check its result.

        Raises:
            QuadrupedError: if a term raises an error or its result does not have shape (N,), or (N, K) for K names.
        """
        n = len(context.velocity)
        for term, function in self._functions:
            shape = (n,) if len(term.names) == 1 else (n, len(term.names))
            checked(f"reward {' and '.join(term.names)}", shape, functools.partial(function, context))


def checked(what: str, shape: tuple[int, ...], call: Callable[[], object], dtype: np.dtype[Any] | None = None) -> None:
    """Check that a user's function returns an array of a given shape, and of a given dtype if there is one.

    Raises:
        QuadrupedError: if it raises an error or returns something else.
    """
    try:
        value = call()
    except Exception as error:
        raise QuadrupedError(f"{what}: {type(error).__name__}: {error}") from error
    found, kind = getattr(value, "shape", type(value).__name__), getattr(value, "dtype", None)
    check(found == shape, what, found, f"an array of shape {shape}, one value per env")
    check(dtype in (None, kind), what, str(kind), f"an array of {dtype}, one value per env")


def check_fields(what: str, layout: ObservationLayout, num_envs: int, *arguments: object) -> None:
    """Check what each field of a layout reads from the arguments; see `checked`."""
    for field in layout.fields:
        shape = num_envs, field.width(layout.robot)
        checked(f"{what} {field.name}", shape, functools.partial(field.read, *arguments))


class Terminations:
    """Terminations of a task."""

    def __init__(self, terms: Sequence[Termination], config: TerminationSection, context: TaskContext) -> None:
        self._names = [term.name for term in terms]
        self._functions: list[Callable[[TaskContext], Bools]] = [
            _with_parameters(term, config, context) for term in terms
        ]

    def __call__(self, context: TaskContext, diverged: Bools) -> Bools:
        """Return the mask (N,) of the envs in which a condition holds or the simulation diverged, in a new array."""
        ended = diverged.copy()
        for function in self._functions:
            np.logical_or(ended, function(context), out=ended)
        return ended

    def check(self, context: TaskContext) -> None:
        """Compute every termination once, to check its result; see `RewardFunction.check`."""
        for name, function in zip(self._names, self._functions, strict=True):
            call = functools.partial(function, context)
            checked(f"termination {name}", (len(context.velocity),), call, np.dtype(np.bool_))


def _with_parameters(term: RewardTerm | Termination, config: Section, context: TaskContext) -> Any:
    """Return the function of a term with the config's parameters; for a class, an instance of it."""
    parameters = {name: config[name] for name in term.parameters}
    if inspect.isclass(term.function):
        return term(context, **parameters)
    return functools.partial(term.function, **parameters) if parameters else term.function
