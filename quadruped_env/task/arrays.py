"""The few array functions that terms need, for NumPy arrays and torch tensors alike.

NumPy's ufuncs are called directly: on a single row the wrappers around them cost more than the arithmetic.
"""

from typing import Any, Final

import numpy as np

# Scalars as arrays: on a single row, converting a Python number costs as much again as the operation.
ZERO: Final = np.array(0.0)
ONE: Final = np.array(1.0)
MINUS_ONE: Final = np.array(-1.0)


def exp(x: Any) -> Any:
    """Elementwise exponential."""
    return np.exp(x) if isinstance(x, np.ndarray) else x.exp()


def positive(x: Any) -> Any:
    """Elementwise x where it is positive, else 0."""
    return np.maximum(x, ZERO) if isinstance(x, np.ndarray) else x.clip(0.0)


def over_minus_one(x: Any) -> Any:
    """Elementwise x, or -1 where it is less."""
    return np.maximum(x, MINUS_ONE) if isinstance(x, np.ndarray) else x.clip(-1.0)


def any_of(x: Any) -> Any:
    """Whether anything along the last axis is true."""
    return np.logical_or.reduce(x, -1) if isinstance(x, np.ndarray) else x.any(-1)


def total(x: Any) -> Any:
    """Sum over the last axis."""
    return np.add.reduce(x, -1) if isinstance(x, np.ndarray) else x.sum(-1)


def dot(x: Any, y: Any) -> Any:
    """Sum of the products over the last axis, row by row: one call where `total(x * y)` takes two."""
    return np.vecdot(x, y) if isinstance(x, np.ndarray) else (x * y).sum(-1)


def reverse(x: Any) -> Any:
    """The last axis backwards."""
    return x[..., ::-1] if isinstance(x, np.ndarray) else x.flip(-1)


def as_number(mask: Any, x: Any) -> Any:
    """1 where true and 0 elsewhere, in the kind of number that x has."""
    return mask.astype(x.dtype) if isinstance(x, np.ndarray) else mask.to(x.dtype)


def like(constant: np.ndarray, x: Any) -> Any:
    """A constant as the same kind of array as x."""
    return constant if isinstance(x, np.ndarray) else x.new_tensor(constant)
