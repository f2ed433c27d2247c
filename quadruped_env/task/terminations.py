"""Built-in conditions that end an episode as a fall. Their arguments are fields of `config["termination"]`."""

import math
from typing import Annotated, Final

import numpy as np

from quadruped_env.task.context import TaskContext
from quadruped_env.task.terms import termination
from quadruped_env.utils.arrays import Bools
from quadruped_env.utils.parameters import Parameter


@termination
def tilted(
    context: TaskContext, max_tilt: Annotated[float, Parameter("rad", 0.0, math.pi, exclusive=True)] = 1.0
) -> Bools:
    """The base leans more than 1 rad."""
    return context.readings.up_b[:, 2] < math.cos(max_tilt)


@termination
def trunk_contact(context: TaskContext, max_trunk_force: Annotated[float, Parameter("N", 0.0)] = 1.0) -> Bools:
    """The base or a hip presses on the ground with more than 1 N."""
    touching: Bools = np.logical_or.reduce(context.readings.trunk_force > max_trunk_force, axis=-1)
    return touching


TERMINATIONS: Final = (tilted, trunk_contact)
"""Built-in terminations."""
