"""Array operations of a function, recorded once and then repeated without the Python code around them.

For a single env, the calls, attributes and new arrays of a reward term cost more than its arithmetic. A pure function
of arrays that stay where they are is called once with stand-ins for these arrays. They record each NumPy ufunc with its
arguments and its result; repeating them applies the same ufuncs to the same arrays, and gives the same bits.
"""

import copy
import functools
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, is_dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import DTypeLike, NDArray

Call = tuple[Callable[..., Any], tuple[Any, ...]]
Operation = tuple[Any, ...]
"""Name, method and inputs of an operation, each input as `_location` describes it."""

_NO_POSITIONAL_RESULT: Final = (np.maximum, np.minimum)
"""Ufuncs for which NumPy deprecates the result as a positional argument, which is otherwise faster than a keyword."""


class NotCapturableError(TypeError):
    """Raised if a function does something other than applying ufuncs to its arrays and taking views of them."""


class Capture:
    """Recorded operations, which `repeat` carries out in their order. An operation that recurs is recorded once."""

    def __init__(self) -> None:
        self._calls: list[Call] = []
        self._last: tuple[Callable[..., Any], tuple[Any, ...], NDArray[Any]] | None = None
        """The last operation, its arguments, and its result if this is a new array."""
        self._results: dict[Operation, NDArray[Any]] = {}
        """Results of the operations recorded so far, until something else is written there or into their inputs."""

    def repeat(self) -> None:
        """Compute the results of all recorded functions again, from the current values of their arrays."""
        for function, arguments in self._calls:
            function(*arguments)

    def record(self, function: Callable[..., Any], *arguments: Any) -> NDArray[Any]:
        """Call a function with stand-ins (see `stand_in`), and record its operations.

        Returns:
            The function's result, which every `repeat` overwrites. It may be a view of an argument.

        Raises:
            NotCapturableError: if the function is not pure; in that case nothing is recorded.
        """
        kept, results = len(self._calls), self._results.copy()
        self._last = None
        try:
            return self._array(function(*arguments))
        except (AttributeError, TypeError, ValueError) as error:
            del self._calls[kept:]
            self._results = results
            raise NotCapturableError(f"{function} cannot be captured: {error}") from error

    def record_into(self, to: NDArray[Any], function: Callable[..., Any], *arguments: Any) -> None:
        """Record a function whose result every `repeat` writes to an array; see `record`.

        The last operation writes there itself if it can. A result with gaps between its values is copied instead, as
        NumPy may round an exponential differently there.
        """
        result = self.record(function, *arguments)
        same_layout = (result.shape, result.dtype) == (to.shape, to.dtype) and to.flags.c_contiguous
        if same_layout and self._last is not None and self._last[2] is result:
            ufunc, inputs, _ = self._last
            self._calls[-1] = _call(ufunc, inputs, to)
            self._overwritten(result)
        else:
            self._calls.append((np.copyto, (to, result)))

    def stand_in(self, value: Any) -> Any:
        """A stand-in for an array, or a copy of an object with stand-ins for its arrays."""
        if isinstance(value, np.ndarray):
            return _StandIn(self, value)
        result = copy.copy(value)
        names = [f.name for f in fields(value)] if is_dataclass(value) else list(vars(value))
        for name in names:
            if isinstance(getattr(value, name), np.ndarray):
                object.__setattr__(result, name, _StandIn(self, getattr(value, name)))
        return result

    def applied(self, ufunc: np.ufunc, method: str, inputs: tuple[Any, ...], options: Mapping[str, Any]) -> "_StandIn":
        """Record a ufunc."""
        if not set(options) <= ({"axis"} if method == "reduce" else {"out"}) or method not in ("__call__", "reduce"):
            raise NotCapturableError(f"{ufunc.__name__}.{method} with {', '.join(options)}")
        if ufunc is np.power:
            raise NotCapturableError("**, which NumPy computes in several ways")
        # Numbers are converted once, to float64, as NumPy does next to an array of float64.
        arrays = [np.array(x) if isinstance(x, float) else self._array(x) for x in inputs]
        function: Callable[..., Any] = ufunc
        arguments: tuple[Any, ...] = tuple(arrays)
        if "out" in options:
            result = ufunc(*arrays, out=self._array(options["out"][0]))
            self._calls.append(_call(function, arguments, result))
            self._last = None
            self._overwritten(result)
            return _StandIn(self, result)
        operation = (ufunc.__name__, method, options.get("axis"), *map(_location, inputs, arrays))
        known = self._results.get(operation)
        if known is not None:
            self._last = None
            return _StandIn(self, known)
        if method == "reduce":
            function, arguments = ufunc.reduce, (arrays[0], options["axis"], None)
            result = ufunc.reduce(arrays[0], options["axis"])
        else:
            result = ufunc(*arrays)
        self._calls.append(_call(function, arguments, result))
        self._last = function, arguments, result
        self._results[operation] = result
        return _StandIn(self, result)

    def copied(self, array: NDArray[Any], dtype: DTypeLike) -> "_StandIn":
        """Record a conversion of an array to another type."""
        self._last = None
        operation = ("astype", np.dtype(dtype).str, _location(array, array))
        if operation not in self._results:
            self._results[operation] = array.astype(dtype)
            self._calls.append((np.copyto, (self._results[operation], array)))
        return _StandIn(self, self._results[operation])

    def _overwritten(self, array: NDArray[Any]) -> None:
        """Forget the operations with an array as their result or one of their inputs."""
        low, high = np.lib.array_utils.byte_bounds(array)

        def apart(operation: Operation, result: NDArray[Any]) -> bool:
            inputs = [part[:2] for part in operation if isinstance(part, tuple)]
            return all(end <= low or start >= high for start, end in (*inputs, np.lib.array_utils.byte_bounds(result)))

        self._results = {operation: result for operation, result in self._results.items() if apart(operation, result)}

    def _array(self, value: Any) -> NDArray[Any]:
        if isinstance(value, _StandIn):
            return value.array
        if isinstance(value, np.ndarray):
            return value
        raise NotCapturableError(f"{type(value).__name__} in place of an array")


def _location(value: Any, array: NDArray[Any]) -> Any:
    """A number itself, or beginning, end and layout of an array in memory: the same for the same input."""
    if isinstance(value, float):
        return value
    return (*np.lib.array_utils.byte_bounds(array), array.shape, array.strides, array.ctypes.data, array.dtype.str)


def _call(function: Callable[..., Any], arguments: tuple[Any, ...], result: NDArray[Any]) -> Call:
    """Fastest call of an operation that writes its result to an array."""
    if isinstance(function, np.ufunc) and function.signature is None:
        arguments, result = _without_unit_axes(arguments, result)
    if function in _NO_POSITIONAL_RESULT:
        return functools.partial(function, out=result), arguments
    return function, (*arguments, result)


def _without_unit_axes(
    inputs: tuple[NDArray[Any], ...], result: NDArray[Any]
) -> tuple[tuple[NDArray[Any], ...], NDArray[Any]]:
    """Views without the axes along which the result has length 1, and numbers in place of arrays of one element.

    NumPy is much faster if all arrays have one shape or are numbers, and if their only axis is strided.
    """
    unit = [axis for axis in range(-result.ndim, 0) if result.shape[axis] == 1]
    views = [x.reshape(()) if x.size == 1 else x.squeeze(tuple(a for a in unit if a >= -x.ndim)) for x in inputs]
    return tuple(views), result.squeeze(tuple(unit))


class Functions:
    """Functions of the same arguments, of which the pure ones are captured and the others called.

    Args:
        functions: each with True if it is pure, and with the array for its result.
        stand_ins: creates a capture's stand-ins for the arguments.
    """

    def __init__(
        self,
        functions: Iterable[tuple[Callable[..., Any], bool, NDArray[Any]]],
        stand_ins: Callable[[Capture], tuple[Any, ...]],
    ) -> None:
        self._capture = Capture()
        self._called: list[tuple[NDArray[Any], Callable[..., Any]]] = []
        arguments = stand_ins(self._capture)
        for function, pure, result in functions:
            if not (pure and self._captured(result, function, arguments)):
                self._called.append((result, function))

    def _captured(self, result: NDArray[Any], function: Callable[..., Any], arguments: tuple[Any, ...]) -> bool:
        try:
            self._capture.record_into(result, function, *arguments)
        except NotCapturableError:
            return False
        return True

    def update(self, *arguments: Any) -> None:
        """Compute all results; the arrays of the arguments must be those that the stand-ins stand for."""
        self._capture.repeat()
        for result, function in self._called:
            result[...] = function(*arguments)


class _StandIn(np.lib.mixins.NDArrayOperatorsMixin):
    """Stands for an array: ufuncs on it are recorded, basic indexing gives views, and anything else fails."""

    __slots__ = ("_capture", "array")

    def __init__(self, capture: Capture, array: NDArray[Any]) -> None:
        self._capture = capture
        self.array = array

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the array."""
        return self.array.shape

    def astype(self, dtype: DTypeLike) -> "_StandIn":
        """A converted copy."""
        return self._capture.copied(self.array, dtype)

    def __getitem__(self, index: Any) -> "_StandIn":
        view = self.array[index]
        if not np.may_share_memory(view, self.array):
            raise NotCapturableError(f"index {index!r}, which copies")
        return _StandIn(self._capture, view)

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> "_StandIn":
        return self._capture.applied(ufunc, method, inputs, options)

    def __array__(self, *_: Any, **__: Any) -> Any:
        raise NotCapturableError("a conversion to an array")

    def __bool__(self) -> bool:
        raise NotCapturableError("a condition on an array's values")

    __iter__ = __float__ = __int__ = __len__ = __bool__
