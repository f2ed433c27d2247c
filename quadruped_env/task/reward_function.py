"""The reward terms of a task, computed in one pass."""

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
    """Every reward term of a list, weighted, one row per term.

    Args:
        terms: in the order in which they are added.
        config: their weights and parameters.
        context: what they read.
    """

    def __init__(self, terms: Sequence[RewardTerm], config: Section, context: TaskContext) -> None:
        self.names = tuple(name for term in terms for name in term.names)
        self._weights = np.array([config.weights[name] for name in self.names])[:, None] * context.timestep
        self._single: list[tuple[int, Callable[[TaskContext], Any]]] = []
        self._joint: list[tuple[slice, Callable[[TaskContext], Any]]] = []
        self._listeners: list[Callable[[NDArray[np.intp], Floats], None]] = []
        row = 0
        for term in terms:
            function = _with_parameters(term, config, context)
            if hasattr(function, "command_changed"):
                self._listeners.append(function.command_changed)
            if len(term.names) == 1:
                self._single.append((row, function))
            else:
                self._joint.append((slice(row, row + len(term.names)), function))
            row += len(term.names)

    def command_changed(self, env_ids: NDArray[np.intp], velocity: Floats) -> None:
        """Let the terms that keep something per command know of new velocity commands (R, 2) of some envs (R,)."""
        for listener in self._listeners:
            listener(env_ids, velocity)

    def __call__(self, context: TaskContext) -> Floats:
        """Weighted terms (T, N), a new array."""
        values = np.empty((len(self.names), len(context.velocity)))
        for rows, function in self._joint:
            values[rows] = function(context).T
        for row, function in self._single:
            values[row] = function(context)
        values *= self._weights
        return values

    def check(self, context: TaskContext) -> None:
        """Compute every term once, to see that it fits.

        Raises:
            QuadrupedError: if a term fails or returns something of another shape than (N,), or (N, K) for K names.
        """
        n = len(context.velocity)
        for row, function in self._single:
            checked(f"reward {self.names[row]}", (n,), functools.partial(function, context))
        for rows, function in self._joint:
            names = self.names[rows]
            checked(f"reward {' and '.join(names)}", (n, len(names)), functools.partial(function, context))


def checked(what: str, shape: tuple[int, ...], call: Callable[[], Any]) -> None:
    """See that a function of a user's returns an array of a shape.

    Raises:
        QuadrupedError: if it fails, or returns something else.
    """
    try:
        value = call()
    except Exception as error:
        raise QuadrupedError(f"{what}: {type(error).__name__}: {error}") from error
    if np.shape(value) != shape:
        raise QuadrupedError(f"{what}: expected an array of shape {shape}, one value per env; found {np.shape(value)}")


class Terminations:
    """Every termination of a list.

    Args:
        terms: the conditions.
        config: their parameters.
        context: what they read.
    """

    def __init__(self, terms: Sequence[Termination], config: Section, context: TaskContext) -> None:
        self._functions = [(term.name, _with_parameters(term, config, context)) for term in terms]

    def __call__(self, context: TaskContext, diverged: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Envs (N,) in which a condition holds, or that diverged; a new array."""
        ended = diverged.copy()
        for _, function in self._functions:
            ended |= function(context)
        return ended

    def check(self, context: TaskContext) -> None:
        """As `RewardFunction.check`."""
        for name, function in self._functions:
            checked(f"termination {name}", (len(context.velocity),), functools.partial(function, context))


def _with_parameters(term: RewardTerm | Termination, config: Section, context: TaskContext) -> Any:
    """A term's function with the config's parameters; of a class, an instance."""
    parameters = {name: config[name] for name in term.parameters}
    function: Any = term.function
    if inspect.isclass(term.function):
        return function(context, **parameters)
    return functools.partial(function, **parameters) if parameters else function
