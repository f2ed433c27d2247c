"""Helpers for arrays of any kind that honours NumPy's protocols: NumPy's own, and tensors on a GPU."""

from typing import Any

import numpy as np
from numpy.typing import NDArray


def dot(x: NDArray[np.floating], y: NDArray[np.floating]) -> NDArray[np.float64]:
    """Sum of x * y over the last axis.

    `np.vecdot` and `@` call the BLAS, whose kernels are chosen by the processor and round differently.
    """
    products: NDArray[np.float64] = np.add.reduce(x * y, axis=-1)
    return products


def frozen(values: NDArray[Any]) -> NDArray[Any]:
    """The same array, read-only from now on: a constant, which a GPU receives only once."""
    values.setflags(write=False)
    return values
