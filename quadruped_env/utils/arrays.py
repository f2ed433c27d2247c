"""Array functions for terms, as a namespace that is selected when a task is created.

Terms access it as `context.xp`. NumPy's ufuncs are called directly, because for a single env the wrappers around them
cost more than the arithmetic.
"""

import functools
from typing import Any, Final, Protocol

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray


class Namespace(Protocol):
    """Functions on float64 arrays (N, ...)."""

    zero: Any
    one: Any
    minus_one: Any
    """Constants as arrays, because for a single env converting a Python number costs as much as the operation."""

    def constant(self, values: ArrayLike) -> Any:
        """Array of constants."""
        ...

    def asarray(self, values: Any, dtype: DTypeLike = np.float64) -> Any:
        """Array of a type, from an array, a tensor or numbers; it may share their memory."""
        ...

    def zeros(self, shape: int | tuple[int, ...], dtype: DTypeLike = np.float64) -> Any:
        """New array of zeros."""
        ...

    def arange(self, stop: int) -> Any:
        """Whole numbers from 0 (stop,)."""
        ...

    def take(self, array: Any, index: Any) -> Any:
        """Entries of an array along its first axis."""
        ...

    def numpy(self, values: Any) -> NDArray[Any]:
        """NumPy array of an array's values."""
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
        """Sum of x * y over the last axis."""
        ...

    def number(self, mask: Any, /) -> Any:
        """1.0 where true, else 0.0."""
        ...


_SHORT: Final = 4
"""Length of vectors up to which NumPy adds column after column in less time than it reduces each row."""

_FEW: Final = 8
"""Number of truth values per env up to which NumPy takes less time for `or` after `or` than for a reduction."""


class NumPyArrays:
    """NumPy's functions, called directly."""

    zero: Any = np.array(0.0)
    one: Any = np.array(1.0)
    minus_one: Any = np.array(-1.0)

    exp = staticmethod(np.exp)
    abs = staticmethod(np.abs)
    maximum = staticmethod(np.maximum)
    minimum = staticmethod(np.minimum)

    def constant(self, values: ArrayLike) -> Any:
        """See `Namespace`."""
        return np.array(values, dtype=np.float64)

    def asarray(self, values: Any, dtype: DTypeLike = np.float64) -> Any:
        """See `Namespace`."""
        return np.asarray(values, dtype=dtype)

    def zeros(self, shape: int | tuple[int, ...], dtype: DTypeLike = np.float64) -> Any:
        """See `Namespace`."""
        return np.zeros(shape, dtype)

    def arange(self, stop: int) -> Any:
        """See `Namespace`."""
        return np.arange(stop)

    def take(self, array: Any, index: Any) -> Any:
        """See `Namespace`."""
        return array[index]

    def numpy(self, values: Any) -> NDArray[Any]:
        """See `Namespace`."""
        return np.asarray(values)

    def positive(self, x: Any, /) -> Any:
        """See `Namespace`."""
        return np.maximum(x, self.zero)

    @staticmethod
    def sum(x: Any, /) -> Any:
        """See `Namespace`."""
        return np.add.reduce(x, -1)

    @staticmethod
    def any(x: Any, /) -> Any:
        """See `Namespace`."""
        if not 0 < x.shape[-1] <= _FEW:
            return np.logical_or.reduce(x, -1)
        return functools.reduce(np.logical_or, (x[..., i] for i in range(x.shape[-1])))

    @staticmethod
    def dot(x: Any, y: Any, /) -> Any:
        """See `Namespace`."""
        products = x * y
        # Not `np.vecdot`, which calls the BLAS: its kernels, chosen by the processor, round differently.
        if x.shape[-1] > _SHORT:
            return np.add.reduce(products, -1)
        return functools.reduce(np.add, (products[..., i] for i in range(x.shape[-1])))

    @staticmethod
    def number(mask: Any, /) -> Any:
        """See `Namespace`."""
        return mask.astype(np.float64)


NUMPY: Final[Namespace] = NumPyArrays()


def frozen(values: NDArray[Any]) -> NDArray[Any]:
    """The same array, read-only from now on: a constant, which a GPU receives only once."""
    values.setflags(write=False)
    return values


def floats(values: Any) -> Any:
    """Array of float64, from numbers or a NumPy array; an array of another library as it is."""
    if hasattr(values, "__array_function__") and not isinstance(values, np.ndarray):
        return values
    return np.asarray(values, dtype=np.float64)
