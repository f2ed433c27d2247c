"""Built-in conditions that end an episode as a fall. Their arguments are fields of `config["termination"]`."""

import math
from typing import Annotated, Final, cast

import numpy as np
from numpy.typing import NDArray

from quadruped_env.task.context import TaskContext
from quadruped_env.task.terms import Termination, termination
from quadruped_env.utils.parameters import Parameter


@termination(pure=True)
class tilted:  # noqa: N801  named like functions, as all terms
    """The base leans more than 1 rad."""

    def __init__(
        self, context: TaskContext, max_tilt: Annotated[float, Parameter("rad", 0.0, math.pi, exclusive=True)] = 1.0
    ) -> None:
        self._lowest = context.xp.constant(math.cos(max_tilt))

    def __call__(self, context: TaskContext) -> NDArray[np.bool_]:
        """Values (N,)."""
        return context.readings.up_b[:, 2] < self._lowest


@termination(pure=True)
class trunk_contact:  # noqa: N801
    """The base or a hip presses on the ground with more than 1 N."""

    def __init__(self, context: TaskContext, max_trunk_force: Annotated[float, Parameter("N", 0.0)] = 1.0) -> None:
        self._most = context.xp.constant(max_trunk_force)

    def __call__(self, context: TaskContext) -> NDArray[np.bool_]:
        """Values (N,)."""
        return context.xp.any(context.readings.trunk_force > self._most)


# mypy ignores the return type of a class decorator.
TERMINATIONS: Final = cast("tuple[Termination, ...]", (tilted, trunk_contact))
