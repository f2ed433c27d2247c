"""Recorded array operations as one generated Python function.

Python itself computes with a few numbers, NumPy with arrays: a call of NumPy takes half a microsecond, ten times as
long as an addition in Python. Both have the same floating-point numbers, so the bits are the same.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

_FEW: Final = 6
"""Size of a result up to which Python computes it in less time than a call of NumPy takes."""
_ARITHMETIC: Final[dict[np.ufunc, str]] = {
    np.add: "{} + {}",
    np.subtract: "{} - {}",
    np.multiply: "{} * {}",
    np.positive: "{}",
    np.negative: "-{}",
    np.absolute: "abs({})",
}
if np.signbit(np.maximum([0.0, -0.0], [-0.0, 0.0])).tolist() == [True, False]:
    # On this processor NumPy returns the second one of two zeros; everywhere, a value that is not a number.
    _ARITHMETIC[np.maximum] = "{0} if {0} > {1} or {0} != {0} else {1}"
    _ARITHMETIC[np.minimum] = "{0} if {0} < {1} or {0} != {0} else {1}"
_COMPARISON: Final[dict[np.ufunc, str]] = {
    np.greater: "{} > {}",
    np.greater_equal: "{} >= {}",
    np.less: "{} < {}",
    np.less_equal: "{} <= {}",
}
_LOGIC: Final[dict[np.ufunc, str]] = {np.logical_or: "{} or {}", np.logical_and: "{} and {}", np.logical_not: "not {}"}
_KEYWORD_RESULT: Final = (np.maximum, np.minimum)
"""Ufuncs for which NumPy deprecates the result as a positional argument, which is otherwise faster than a keyword."""


@dataclass(frozen=True, eq=False)
class Operation:
    """A recorded operation: a ufunc, its reduction along an axis, or a copy to another type."""

    ufunc: np.ufunc | None
    """None: a copy."""
    inputs: tuple[NDArray[Any], ...]
    result: NDArray[Any]
    axis: int | None = None
    """Axis of a reduction."""
    reduces: bool = False

    def carry_out(self) -> None:
        """Compute the result."""
        if self.ufunc is None:
            np.copyto(self.result, self.inputs[0])
        elif self.reduces:
            self.ufunc.reduce(self.inputs[0], self.axis, out=self.result)
        else:
            self.ufunc(*self.inputs, out=self.result)

    @cached_property
    def arrays(self) -> tuple[tuple[NDArray[Any], ...], NDArray[Any]]:
        """Inputs and result as the call takes them.

        An elementwise operation takes views without the axes along which the result has length 1, and numbers in place
        of arrays of one element: NumPy is much faster if all arrays have one shape or are numbers, and if their only
        axis is strided.
        """
        if self.reduces or (self.ufunc is not None and self.ufunc.signature is not None):
            return self.inputs, self.result
        unit = [axis for axis in range(-self.result.ndim, 0) if self.result.shape[axis] == 1]
        inputs = (
            x.reshape(()) if x.size == 1 else x.squeeze(tuple(axis for axis in unit if axis >= -x.ndim))
            for x in self.inputs
        )
        return tuple(inputs), self.result.squeeze(tuple(unit))

    @cached_property
    def expression(self) -> str | None:
        """Python's expression for one element of the result, if Python computes it in less time."""
        if self.reduces:
            return None  # NumPy adds in an order of its own.
        inputs, result = self.arrays
        if max(x.size for x in (*inputs, result)) > _FEW or any(x.squeeze().ndim > 1 for x in (*inputs, result)):
            return None
        types = {x.dtype for x in inputs}
        numbers, truths = types == {np.dtype(np.float64)}, types == {np.dtype(np.bool_)}
        if self.ufunc is None:
            to_number = result.dtype == np.float64
            return "{}" if numbers and to_number else "1.0 if {} else 0.0" if truths and to_number else None
        if numbers:
            return (_ARITHMETIC if result.dtype == np.float64 else _COMPARISON).get(self.ufunc)
        return _LOGIC.get(self.ufunc) if truths and result.dtype == np.bool_ else None


def program(operations: Sequence[Operation], kept: Iterable[NDArray[Any]]) -> Callable[[], None]:
    """A function that carries out operations in their order, always on the same arrays.

    Args:
        operations: the operations.
        kept: results that are read afterwards. Others need not be written.
    """
    code = _Code([*kept, *(x for op in operations if op.expression is None for x in op.inputs)])
    for operation in operations:
        if operation.expression is None:
            code.call(operation)
        else:
            code.compute(operation, operation.expression)
    return code.function()


class _Code:
    def __init__(self, read: Iterable[NDArray[Any]]) -> None:
        self._lines: list[str] = []
        self._objects: dict[str, Any] = {}
        """Objects that the code uses, by name."""
        self._variables: dict[int, str] = {}
        """Variable with the value of a number in memory, by address."""
        self._read = [np.lib.array_utils.byte_bounds(array) for array in read]
        """Memory that other code than Python's arithmetic reads."""

    def call(self, operation: Operation) -> None:
        """Let NumPy carry out an operation."""
        inputs, result = operation.arrays
        to = self._name(result)
        if operation.ufunc is None:
            self._lines.append(f"{self._name(np.copyto)}({to}, {self._name(inputs[0])})")
        elif operation.reduces:
            reduce = self._name(operation.ufunc.reduce)
            self._lines.append(f"{reduce}({self._name(inputs[0])}, {operation.axis}, None, {to})")
        else:
            out = f"out={to}" if operation.ufunc in _KEYWORD_RESULT else to
            self._lines.append(f"{self._name(operation.ufunc)}({', '.join((*map(self._name, inputs), out))})")
        low, high = np.lib.array_utils.byte_bounds(result)
        self._variables = {at: name for at, name in self._variables.items() if not low <= at < high}

    def compute(self, operation: Operation, expression: str) -> None:
        """Let Python carry out an operation, by an expression for each element of the result."""
        inputs, result = operation.arrays
        operands = [self._load(x.squeeze()) for x in inputs]
        variables = []
        for i in range(result.size):
            values = (names[i if len(names) > 1 else 0] for names in operands)
            variables.append(self._assign(expression.format(*values)))
        result = result.squeeze()
        self._variables.update(zip(_addresses(result), variables, strict=True))
        low, high = np.lib.array_utils.byte_bounds(result)
        if any(start < high and low < end for start, end in self._read):
            memory = self._name(memoryview(np.atleast_1d(result)))  # type: ignore[arg-type]  # it is a buffer
            self._lines.extend(f"{memory}[{i}] = {name}" for i, name in enumerate(variables))

    def _load(self, array: NDArray[Any]) -> list[str]:
        """Variables with the numbers of an array."""
        addresses = list(_addresses(array))
        if any(at not in self._variables for at in addresses):
            names = [f"v{len(self._lines)}_{i}" for i in range(len(addresses))]
            method = array.item if array.size == 1 else array.tolist
            self._lines.append(f"{', '.join(names)} = {self._name(method)}()")
            # Only those not known: what Python has computed may not be in memory.
            self._variables = dict(zip(addresses, names, strict=True)) | self._variables
        return [self._variables[at] for at in addresses]

    def _assign(self, expression: str) -> str:
        if expression.isidentifier():
            return expression
        self._lines.append(f"v{len(self._lines)} = {expression}")
        return f"v{len(self._lines) - 1}"

    def _name(self, value: Any) -> str:
        name = f"x{len(self._objects)}"
        self._objects[name] = value
        return name

    def function(self) -> Callable[[], None]:
        """The code as a function."""
        namespace = dict(self._objects)
        exec("\n    ".join(("def repeat():", *self._lines, "return")), namespace)  # noqa: S102  it is our own code
        repeat: Callable[[], None] = namespace["repeat"]
        return repeat


def address(array: NDArray[Any]) -> int:
    """Address of an array's first element in memory."""
    start: int = array.__array_interface__["data"][0]
    return start


def _addresses(array: NDArray[Any]) -> Iterator[int]:
    start = address(array)
    stride = array.strides[0] if array.ndim else 0
    return (start + i * stride for i in range(array.size))
