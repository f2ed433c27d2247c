"""Types of arrays, and constant arrays."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
"""Real numbers in double precision."""
Bools = NDArray[np.bool_]
"""Masks."""
EnvIds = NDArray[np.intp]
"""Indices of some envs (R,)."""


def frozen(values: NDArray[Any]) -> NDArray[Any]:
    """Return the same array, read-only from now on: a constant."""
    values.setflags(write=False)
    return values
