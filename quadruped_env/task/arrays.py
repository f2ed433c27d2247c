"""The few array functions that terms need, for NumPy arrays and torch tensors alike.

NumPy's ufuncs are called directly: on a single row the wrappers around them cost more than the arithmetic.
"""

from typing import Any

import numpy as np


def exp(x: Any) -> Any:
    """Elementwise exponential."""
    return np.exp(x) if isinstance(x, np.ndarray) else x.exp()


def positive(x: Any) -> Any:
    """Elementwise x where it is positive, else 0."""
    return np.maximum(x, 0.0) if isinstance(x, np.ndarray) else x.clip(0.0)


def clip(x: Any, low: float, high: float) -> Any:
    """Elementwise x, kept within [low, high]."""
    return np.minimum(np.maximum(x, low), high) if isinstance(x, np.ndarray) else x.clip(low, high)


def sign(x: Any) -> Any:
    """Elementwise -1, 0 or 1."""
    return np.sign(x) if isinstance(x, np.ndarray) else x.sign()


def any_of(x: Any) -> Any:
    """Whether anything along the last axis is true."""
    return np.logical_or.reduce(x, -1) if isinstance(x, np.ndarray) else x.any(-1)


def total(x: Any) -> Any:
    """Sum over the last axis."""
    return np.add.reduce(x, -1) if isinstance(x, np.ndarray) else x.sum(-1)


def like(constant: np.ndarray, x: Any) -> Any:
    """A constant as the same kind of array as x."""
    return constant if isinstance(x, np.ndarray) else x.new_tensor(constant)
