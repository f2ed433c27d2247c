"""Intermediate results in shared memory: same bits, less memory, and nothing is overwritten that is still needed."""

import numpy as np
import pytest

from quadruped_env.array_memory import with_shared_memory
from quadruped_env.array_program import Operation

N = 256


def owner(array):
    return array if array.base is None else owner(array.base)


def operation(ufunc, *inputs, axis=None):
    if axis is None:
        return Operation(ufunc, inputs, ufunc(*inputs))
    return Operation(ufunc, inputs, ufunc.reduce(*inputs, axis), axis, reduces=True)


def chain(rng):
    """Operations that need two results at once, views of results, a reduction, and results of several sizes."""
    a, b = rng.standard_normal((2, N, 4))
    operations = [operation(np.add, a, b)]
    operations.append(operation(np.multiply, operations[0].result, a))
    operations.append(operation(np.subtract, operations[1].result, operations[0].result))
    column = operations[2].result[:, 1]
    operations.append(operation(np.negative, operations[1].result[:, ::-1]))
    operations.append(operation(np.greater, operations[3].result, b))
    operations.append(operation(np.add, operations[3].result, axis=1))
    operations.append(operation(np.maximum, operations[5].result, column))
    operations.append(operation(np.absolute, a))
    return (a, b), operations


@pytest.mark.parametrize("kept", range(8))
def test_a_kept_result_has_the_same_bits_and_its_own_place(kept):
    rng = np.random.default_rng(kept)
    inputs, operations = chain(rng)
    result = operations[kept].result
    shared = with_shared_memory(operations, [result[:, 0] if result.ndim > 1 else result])
    assert shared[kept].result is result
    for _ in range(2):
        for array in inputs:
            array[:] = rng.standard_normal((N, 4))
        for entry in operations:
            entry.carry_out()
        expected = result.copy()
        result[:] = 0
        for entry in shared:
            entry.carry_out()
        np.testing.assert_array_equal(result, expected)


def test_results_that_are_not_needed_at_once_share_memory():
    _, operations = chain(np.random.default_rng(0))
    shared = with_shared_memory(operations, [operations[6].result])
    places = {id(owner(entry.result)) for entry in shared}
    assert len(places) < len(operations)
    assert {entry.result.nbytes for entry in shared} == {entry.result.nbytes for entry in operations}


def test_an_operation_never_writes_over_its_inputs():
    _, operations = chain(np.random.default_rng(0))
    for entry in with_shared_memory(operations, [operations[6].result]):
        assert not any(np.may_share_memory(x, entry.result) for x in entry.inputs)


def test_small_results_stay_where_they_are():
    first = operation(np.negative, np.ones((1, 8)))
    second = operation(np.absolute, first.result)
    shared = with_shared_memory([first, second], [second.result])
    for entry, before in zip(shared, (first, second), strict=True):
        assert entry.result is before.result
        assert entry.inputs[0] is before.inputs[0]
