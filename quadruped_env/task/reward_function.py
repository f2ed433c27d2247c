"""Computation of the reward terms and terminations of a task."""

import functools
import inspect
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quadruped_env.capture import Functions
from quadruped_env.errors import QuadrupedError
from quadruped_env.task.config_sections import Section
from quadruped_env.task.context import TaskContext
from quadruped_env.task.terms import RewardTerm, Termination

Floats = NDArray[np.float64]


class RewardFunction:
    """Weighted reward terms of a task. A term whose weights are 0 is not computed, and counts as 0.

    Args:
        terms: terms in the order in which they are added.
        config: weights and parameters of the terms.
        context: input of the terms.
    """

    def __init__(self, terms: Sequence[RewardTerm], config: Section, context: TaskContext) -> None:
        self.names = tuple(name for term in terms for name in term.names)
        weights = np.array([config.weights[name] for name in self.names])[:, None] * context.timestep
        self._weights = context.xp.constant(weights)
        self._config = config
        self._functions = [(term, _with_parameters(term, config, context)) for term in terms]
        self._listeners: list[Callable[[NDArray[np.intp], Floats], None]] = [
            function.command_changed for _, function in self._functions if hasattr(function, "command_changed")
        ]
        self._values = context.xp.zeros((len(self.names), len(context.velocity)))
        self._captured: Functions | None = None

    def __getstate__(self) -> dict[str, Any]:
        # Captured operations refer to arrays, which are others after unpickling.
        return {**self.__dict__, "_captured": None}

    def command_changed(self, env_ids: NDArray[np.intp], velocity: Floats) -> None:
        """Notify the terms with a method `command_changed` of new velocity commands (R, 2) of some envs (R,)."""
        for listener in self._listeners:
            listener(env_ids, velocity)

    def __call__(self, context: TaskContext) -> Floats:
        """Weighted terms (T, N) in a new array."""
        if self._captured is None:
            self._captured = Functions(self._with_results(), context.stand_ins)
        self._captured.update(context)
        return self._values * self._weights

    def _with_results(self) -> Iterator[tuple[Callable[..., Any], bool, Floats]]:
        start = 0
        for term, function in self._functions:
            rows = self._values[start : start + len(term.names)]
            start += len(rows)
            if any(self._config.weights[name] for name in term.names):
                yield function, term.pure, rows[0] if len(rows) == 1 else rows.T

    def check(self, context: TaskContext) -> None:
        """Compute every term once, to check its result.

        Raises:
            QuadrupedError: if a term raises an error or its result does not have shape (N,), or (N, K) for K names.
        """
        for term, function in self._functions:
            call = functools.partial(function, context)
            checked(f"reward {' and '.join(term.names)}", _shape(term, context), call)


def _shape(term: RewardTerm, context: TaskContext) -> tuple[int, ...]:
    n, columns = len(context.velocity), len(term.names)
    return (n,) if columns == 1 else (n, columns)


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
        self._functions = [(term, _with_parameters(term, config, context)) for term in terms]
        self._values = [context.xp.zeros(len(context.velocity), np.bool_) for _ in terms]
        self._captured: Functions | None = None

    def __getstate__(self) -> dict[str, Any]:
        # See `RewardFunction`.
        return {**self.__dict__, "_captured": None}

    def __call__(self, context: TaskContext, diverged: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Mask (N,) of the envs in which a condition holds or the simulation diverged, in a new array."""
        if self._captured is None:
            functions = zip(self._functions, self._values, strict=True)
            self._captured = Functions([(f, term.pure, row) for (term, f), row in functions], context.stand_ins)
        self._captured.update(context)
        return functools.reduce(np.logical_or, self._values, diverged.copy())

    def check(self, context: TaskContext) -> None:
        """Compute every termination once, to check its result; see `RewardFunction.check`."""
        for term, function in self._functions:
            checked(f"termination {term.name}", (len(context.velocity),), functools.partial(function, context))


def _with_parameters(term: RewardTerm | Termination, config: Section, context: TaskContext) -> Any:
    """Function of a term with the config's parameters; for a class, an instance of it."""
    parameters = {name: config[name] for name in term.parameters}
    function: Any = term.function
    if inspect.isclass(term.function):
        return function(context, **parameters)
    return functools.partial(function, **parameters) if parameters else function
