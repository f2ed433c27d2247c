"""Computation of the reward terms and terminations of a task."""

import functools
import inspect
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.task.context import TaskContext
from quadruped_env.task.settings import Section
from quadruped_env.task.terms import RewardTerm, Termination

Floats = NDArray[np.float64]


class RewardFunction:
    """Weighted reward terms of a task.

    Args:
        terms: terms in the order in which they are added.
        config: weights and parameters of the terms.
        context: input of the terms.
    """

    def __init__(self, terms: Sequence[RewardTerm], config: Section, context: TaskContext) -> None:
        self.names = tuple(name for term in terms for name in term.names)
        self._weights = np.array([config.weights[name] for name in self.names])[:, None] * context.timestep
        self._single: list[tuple[int, Callable[[TaskContext], Any]]] = []
        self._joint: list[tuple[slice, Callable[[TaskContext], Any]]] = []
        self._listeners: list[Callable[[NDArray[np.intp], Floats], None]] = []
        index = 0
        for term in terms:
            function = _with_parameters(term, config, context)
            if hasattr(function, "command_changed"):
                self._listeners.append(function.command_changed)
            if len(term.names) == 1:
                self._single.append((index, function))
            else:
                self._joint.append((slice(index, index + len(term.names)), function))
            index += len(term.names)

    def command_changed(self, env_ids: NDArray[np.intp], velocity: Floats) -> None:
        """Notify the terms with a method `command_changed` of new velocity commands (R, 2) of some envs (R,)."""
        for listener in self._listeners:
            listener(env_ids, velocity)

    def __call__(self, context: TaskContext) -> Floats:
        """Weighted terms (T, N) in a new array."""
        values = np.empty((len(self.names), len(context.velocity)))
        for indices, function in self._joint:
            values[indices] = function(context).T
        for index, function in self._single:
            values[index] = function(context)
        values *= self._weights
        return values

    def check(self, context: TaskContext) -> None:
        """Compute every term once, to check its result.

        Raises:
            QuadrupedError: if a term raises an error or its result does not have shape (N,), or (N, K) for K names.
        """
        n = len(context.velocity)
        for index, function in self._single:
            checked(f"reward {self.names[index]}", (n,), functools.partial(function, context))
        for indices, function in self._joint:
            names = self.names[indices]
            checked(f"reward {' and '.join(names)}", (n, len(names)), functools.partial(function, context))


def checked(what: str, shape: tuple[int, ...], call: Callable[[], Any]) -> None:
    """Check that a user's function returns an array of a given shape.

    Raises:
        QuadrupedError: if it raises an error or returns another shape.
    """
    try:
        value = call()
    except Exception as error:
        raise QuadrupedError(f"{what}: {type(error).__name__}: {error}") from error
    if np.shape(value) != shape:
        raise QuadrupedError(f"{what}: expected an array of shape {shape}, one value per env; found {np.shape(value)}")


class Terminations:
    """Terminations of a task.

    Args:
        terms: termination conditions.
        config: parameters of the terms.
        context: input of the terms.
    """

    def __init__(self, terms: Sequence[Termination], config: Section, context: TaskContext) -> None:
        self._functions = [(term.name, _with_parameters(term, config, context)) for term in terms]

    def __call__(self, context: TaskContext, diverged: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Mask (N,) of the envs in which a condition holds or the simulation diverged, in a new array."""
        ended = diverged.copy()
        for _, function in self._functions:
            ended |= function(context)
        return ended

    def check(self, context: TaskContext) -> None:
        """Compute every termination once, to check its result; see `RewardFunction.check`."""
        for name, function in self._functions:
            checked(f"termination {name}", (len(context.velocity),), functools.partial(function, context))


def _with_parameters(term: RewardTerm | Termination, config: Section, context: TaskContext) -> Any:
    """Function of a term with the config's parameters; for a class, an instance of it."""
    parameters = {name: config[name] for name in term.parameters}
    function: Any = term.function
    if inspect.isclass(term.function):
        return function(context, **parameters)
    return functools.partial(function, **parameters) if parameters else function
