"""Array operations of a function, recorded once and then repeated without the Python code around them.

For a single env, the calls, attributes and new arrays of a reward term cost more than its arithmetic. A pure function
of arrays that stay where they are is called once with stand-ins for these arrays. They record each NumPy ufunc with its
arguments and its result. To repeat them, `array_program` computes the same on the same arrays, to the same bits.
"""

import copy
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from quadruped_env.array_memory import with_shared_memory
from quadruped_env.array_program import Operation, program

Key = tuple[Any, ...]
"""Name, method and inputs of an operation, each input as `_location` describes it."""


class NotCapturableError(TypeError):
    """Raised if a function does something other than applying ufuncs to its arrays and taking views of them."""


class Capture:
    """Recorded operations, which `repeat` carries out in their order. An operation that recurs is recorded once."""

    def __init__(self) -> None:
        self._operations: list[Operation] = []
        self._kept: list[NDArray[Any]] = []
        """Arrays whose values are read after a repetition."""
        self._program: Callable[[], None] | None = None
        self._repeated = False
        self._last: Operation | None = None
        """The last operation, if its result is a new array."""
        self._results: dict[Key, NDArray[Any]] = {}
        """Results of the operations recorded so far, until something else is written there or into their inputs."""

    def repeat(self) -> None:
        """Compute the results of all recorded functions again, from the current values of their arrays."""
        if self._program is not None:
            self._program()
        elif self._repeated:
            self._program = program(with_shared_memory(self._operations, self._kept), self._kept)
            self._program()
        else:
            # To write the program takes longer than to do without it once, and many an env is reset and never steps.
            self._repeated = True
            for operation in self._operations:
                operation.carry_out()

    def record(self, function: Callable[..., Any], *arguments: Any) -> NDArray[Any]:
        """Call a function with stand-ins (see `stand_in`), and record its operations.

        Returns:
            The function's result, which every `repeat` overwrites. It may be a view of an argument.

        Raises:
            NotCapturableError: if the function is not pure; in that case nothing is recorded.
        """
        recorded, results = len(self._operations), self._results.copy()
        self._last = None
        self._program, self._repeated = None, False
        try:
            result = self._array(function(*arguments))
        except (AttributeError, TypeError, ValueError) as error:
            del self._operations[recorded:]
            self._results = results
            raise NotCapturableError(f"{function} cannot be captured: {error}") from error
        self._kept.append(result)
        return result

    def record_into(self, to: NDArray[Any], function: Callable[..., Any], *arguments: Any) -> None:
        """Record a function whose result every `repeat` writes to an array; see `record`.

        The last operation writes there itself if it can. A result with gaps between its values is copied instead, as
        NumPy may round an exponential differently there.
        """
        result = self.record(function, *arguments)
        same_layout = (result.shape, result.dtype) == (to.shape, to.dtype) and to.flags.c_contiguous
        self._kept[-1] = to
        if same_layout and self._last is not None and self._last.result is result:
            self._operations[-1] = replace(self._last, result=to)
            self._overwritten(result)
        else:
            self._operations.append(Operation(None, (result,), to))

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
        if "out" in options:
            result = ufunc(*arrays, out=self._array(options["out"][0]))
            self._operations.append(Operation(ufunc, tuple(arrays), result))
            self._kept.append(result)
            self._last = None
            self._overwritten(result)
            return _StandIn(self, result)
        key = (ufunc.__name__, method, options.get("axis"), *map(_location, inputs, arrays))
        known = self._results.get(key)
        if known is not None:
            self._last = None
            return _StandIn(self, known)
        axis = options.get("axis")
        result = ufunc.reduce(arrays[0], axis) if method == "reduce" else ufunc(*arrays)
        self._last = Operation(ufunc, tuple(arrays), np.asarray(result), axis, reduces=method == "reduce")
        self._operations.append(self._last)
        self._results[key] = self._last.result
        return _StandIn(self, self._last.result)

    def copied(self, array: NDArray[Any], dtype: DTypeLike) -> "_StandIn":
        """Record a conversion of an array to another type."""
        self._last = None
        key = ("astype", np.dtype(dtype).str, _location(array, array))
        if key not in self._results:
            self._results[key] = array.astype(dtype)
            self._operations.append(Operation(None, (array,), self._results[key]))
        return _StandIn(self, self._results[key])

    def _overwritten(self, array: NDArray[Any]) -> None:
        """Forget the operations with an array as their result or one of their inputs."""
        low, high = np.lib.array_utils.byte_bounds(array)

        def apart(key: Key, result: NDArray[Any]) -> bool:
            inputs = [part[:2] for part in key if isinstance(part, tuple)]
            return all(end <= low or start >= high for start, end in (*inputs, np.lib.array_utils.byte_bounds(result)))

        self._results = {key: result for key, result in self._results.items() if apart(key, result)}

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
