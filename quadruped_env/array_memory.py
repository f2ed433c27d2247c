"""Shared memory for the intermediate results of recorded array operations.

Between two repetitions other code displaces all arrays from the caches, and to fetch memory then takes longer than to
compute. So results that are not needed at the same time share memory.
"""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.array_program import Operation, address

_SMALL: Final = 1024
"""Size of a result up to which it keeps its own memory, in bytes."""


def with_shared_memory(operations: Sequence[Operation], kept: Iterable[NDArray[Any]]) -> list[Operation]:
    """The same operations, with intermediate results in shared memory.

    Args:
        operations: the operations, in their order.
        kept: results that are read afterwards, which stay where they are.
    """
    stay = {id(_owner(array)) for array in kept}
    last = {id(_owner(x)): i for i, operation in enumerate(operations) for x in (*operation.inputs, operation.result)}
    free: dict[int, list[NDArray[np.uint8]]] = defaultdict(list)
    moved: dict[int, NDArray[np.uint8]] = {}

    def at_new_place(array: NDArray[Any]) -> NDArray[Any]:
        owner = _owner(array)
        if id(owner) not in moved:
            return array
        offset = address(array) - address(owner)
        return np.ndarray(array.shape, array.dtype, moved[id(owner)].data, offset, array.strides)

    result = []
    for i, operation in enumerate(operations):
        new = operation.result
        if new.base is None and new.nbytes > _SMALL and id(new) not in stay and id(new) not in moved:
            places = free[new.nbytes]
            moved[id(new)] = places.pop() if places else np.empty(new.nbytes, np.uint8)
        inputs = tuple(map(at_new_place, operation.inputs))
        result.append(replace(operation, inputs=inputs, result=at_new_place(new)))
        # Not before: NumPy may write a part of a result before it has read all of an input.
        for owner in {id(_owner(x)) for x in (*operation.inputs, new)}:
            if owner in moved and last[owner] == i:
                free[moved[owner].nbytes].append(moved[owner])
    return result


def _owner(array: NDArray[Any]) -> NDArray[Any]:
    """The array that owns an array's memory."""
    while isinstance(array.base, np.ndarray):
        array = array.base
    return array
