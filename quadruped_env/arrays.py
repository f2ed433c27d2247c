"""Array functions for terms, as a namespace that is selected when a task is created.

Terms access it as `context.xp`. NumPy's ufuncs are called directly, because for a single env the wrappers around them
cost more than the arithmetic.
"""

from typing import Any, Final, Protocol

import numpy as np
from numpy.typing import ArrayLike


class Namespace(Protocol):
    """Functions on float64 arrays (N, ...)."""

    zero: Any
    one: Any
    minus_one: Any
    """Constants as arrays, because for a single env converting a Python number costs as much as the operation."""

    def constant(self, values: ArrayLike) -> Any:
        """Array of constants."""
        ...

    def exp(self, x: Any, /) -> Any:
        """Elementwise exponential."""
        ...

    def abs(self, x: Any, /) -> Any:
        """Elementwise absolute value."""
        ...

    def maximum(self, x: Any, y: Any, /) -> Any:
        """Elementwise larger of two arrays."""
        ...

    def minimum(self, x: Any, y: Any, /) -> Any:
        """Elementwise smaller of two arrays."""
        ...

    def positive(self, x: Any, /) -> Any:
        """Elementwise max(x, 0)."""
        ...

    def sum(self, x: Any, /) -> Any:
        """Sum over the last axis."""
        ...

    def any(self, x: Any, /) -> Any:
        """True where any element along the last axis is true."""
        ...

    def dot(self, x: Any, y: Any, /) -> Any:
        """Sum of x * y over the last axis, in one call."""
        ...

    def number(self, mask: Any, /) -> Any:
        """1.0 where true, else 0.0."""
        ...


class _NumPy:
    zero: Any = np.array(0.0)
    one: Any = np.array(1.0)
    minus_one: Any = np.array(-1.0)

    exp = staticmethod(np.exp)
    abs = staticmethod(np.abs)
    maximum = staticmethod(np.maximum)
    minimum = staticmethod(np.minimum)
    dot = staticmethod(np.vecdot)

    @staticmethod
    def constant(values: ArrayLike) -> Any:
        return np.array(values, dtype=np.float64)

    def positive(self, x: Any, /) -> Any:
        return np.maximum(x, self.zero)

    @staticmethod
    def sum(x: Any, /) -> Any:
        return np.add.reduce(x, -1)

    @staticmethod
    def any(x: Any, /) -> Any:
        return np.logical_or.reduce(x, -1)

    @staticmethod
    def number(mask: Any, /) -> Any:
        return mask.astype(np.float64)


NUMPY: Final[Namespace] = _NumPy()
