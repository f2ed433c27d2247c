"""Captured functions: a repetition equals a call to the last bit, and what cannot be captured is called."""

import itertools

import numpy as np
import pytest
from environments import make_native
from tasks import Terms, make_task, random_readings

from quadruped_env.capture import Capture, Functions, NotCapturableError
from quadruped_env.control import ControlConfig, ControlInterface
from quadruped_env.robot import MINI_QUADRUPED


def assert_same_bits(found, expected):
    assert found.dtype == expected.dtype
    np.testing.assert_array_equal(found.view(np.uint8), np.ascontiguousarray(expected).view(np.uint8))


def overwrite(arrays, others):
    """Write the values of one set of readings into the arrays of another."""
    for name in arrays.__slots__:
        getattr(arrays, name)[:] = getattr(others, name)


PURE = {
    "operators": lambda a, b: -(a * b - 2.0) / (abs(b) + 1.0),
    "ufuncs": lambda a, b: np.exp(np.minimum(a, b)) + np.maximum(a, 0.5),
    "views": lambda a, b: a[:, ::-1] * b[:, 1:2] + b[..., 2, None],
    "reduction": lambda a, b: np.add.reduce(a * b, -1),
    "dot": np.vecdot,
    "mask": lambda a, b: (a > b).astype(np.float64) * a,
    "result of a view": lambda a, b: a[:, 1],
    "written into a result": lambda a, b: np.sin(a + b, a * b),
    "in place, on a result": lambda a, b: _doubled(a + b),
    "written into a part of a result": lambda a, b: _with_sine_in_front(a + b, a) * 2.0,
}


def _doubled(values):
    values *= 2.0
    return values


def _with_sine_in_front(values, others):
    np.sin(others[:, :2], out=values[:, :2])
    return values


@pytest.mark.parametrize("function", PURE.values(), ids=PURE)
def test_repetition_of_a_pure_function_equals_a_call(function):
    rng = np.random.default_rng(0)
    a, b = rng.standard_normal((2, 4, 3))
    capture = Capture()
    result = capture.record(function, capture.stand_in(a), capture.stand_in(b))
    for _ in range(3):
        a[:], b[:] = rng.standard_normal((2, 4, 3))
        capture.repeat()
        assert_same_bits(np.ascontiguousarray(result), function(a, b))


SPECIAL = np.array([np.nan, np.inf, -np.inf, 0.0, -0.0, 1e308, -1e308, 5e-324, 1.0])
FEW_NUMBERS = {
    "add": np.add,
    "subtract": np.subtract,
    "multiply": np.multiply,
    "maximum": np.maximum,
    "minimum": np.minimum,
    "absolute and negative": lambda a, b: -abs(a * b),
    "comparisons": lambda a, b: (a > b).astype(np.float64) - (a <= b).astype(np.float64) * 2.0,
    "any": lambda a, b: np.logical_or.reduce(a < b, -1).astype(np.float64),
    "all": lambda a, b: (~np.logical_or.reduce(a >= b, -1) & (a[:, 0] > b[:, 0])).astype(np.float64),
}


@pytest.mark.parametrize("function", FEW_NUMBERS.values(), ids=FEW_NUMBERS)
def test_few_numbers_give_the_results_of_numpy_for_special_values_too(function):
    a, b = np.zeros((2, 1, 3))
    capture = Capture()
    result = capture.record(function, capture.stand_in(a), capture.stand_in(b))
    with np.errstate(all="ignore"):
        for x, y in itertools.product(SPECIAL, SPECIAL):
            a[:], b[:] = (x, 1.0, y), (y, x, -1.0)
            capture.repeat()
            expected = function(a, b)
            np.testing.assert_array_equal(result, expected)
            zero = expected == 0.0
            np.testing.assert_array_equal(np.signbit(result[zero]), np.signbit(expected[zero]))


NOT_PURE = {
    "condition": lambda a: a if a[0, 0] > 0.0 else -a,
    "copied selection": lambda a: a[[0, 2]],
    "function that is no ufunc": lambda a: np.clip(a, 0.0, 1.0),
    "conversion to an array": np.asarray,
    "power": lambda a: a**2.0,
    "integer": lambda a: 2 * a,
    "number": lambda a: a * float(a[0, 0]),
    "loop over rows": lambda a: sum(row for row in a),
    "assignment": lambda a: a.__setitem__(0, 1.0),
    "other method": lambda a: a.clip(0.0),
    "other option": lambda a: np.add(a, a, where=a > 0.0),
    "no array": lambda a: 1.0,
}


@pytest.mark.parametrize("function", NOT_PURE.values(), ids=NOT_PURE)
def test_function_that_is_not_pure_is_refused_and_leaves_nothing_recorded(function):
    capture, a = Capture(), np.ones((3, 2))
    kept = capture.record(np.negative, capture.stand_in(a))
    with pytest.raises(NotCapturableError, match="cannot be captured"):
        capture.record(lambda x: function(x * 2.0), capture.stand_in(a))
    a[:] = 5.0
    capture.repeat()
    np.testing.assert_array_equal(kept, np.full((3, 2), -5.0))
    assert len(capture._operations) == 1


@pytest.mark.parametrize("function", PURE.values(), ids=PURE)
@pytest.mark.parametrize("num_envs", [1, 4])
@pytest.mark.parametrize("contiguous", [True, False])
def test_result_written_into_an_array_equals_a_call(function, num_envs, contiguous):
    rng = np.random.default_rng(0)
    a, b = rng.standard_normal((2, num_envs, 3))
    shape = function(a, b).shape
    result = np.empty(shape) if contiguous else np.full((*shape, 2), np.nan)[..., 0]
    capture = Capture()
    capture.record_into(result, function, capture.stand_in(a), capture.stand_in(b))
    for _ in range(3):
        a[:], b[:] = rng.standard_normal((2, num_envs, 3))
        capture.repeat()
        assert_same_bits(np.ascontiguousarray(result), function(a, b))


def test_result_that_a_function_writes_to_one_of_its_arrays_is_in_both_arrays():
    a, total, result = np.ones((2, 3)), np.zeros((2, 3)), np.empty((2, 3))
    capture = Capture()
    capture.record_into(result, lambda x, y: np.add(x, y, out=y), capture.stand_in(a), capture.stand_in(total))
    total.fill(0.0)
    capture.repeat()
    np.testing.assert_array_equal(result, a)
    np.testing.assert_array_equal(total, a)


def test_operation_that_recurs_is_recorded_once():
    a = np.ones((4, 3))
    capture, results = Capture(), np.empty((2, 4, 3))
    functions = (lambda x: np.sin(x * 2.0) + 1.0, lambda x: np.sin(x * 2.0) * (x > 0.5).astype(np.float64))
    for function, result in zip(functions, results, strict=True):
        capture.record_into(result, function, capture.stand_in(a))
    assert [operation.ufunc for operation in capture._operations].count(np.sin) == 1
    a[:] = np.random.default_rng(0).standard_normal(a.shape)
    capture.repeat()
    for function, result in zip(functions, results, strict=True):
        assert_same_bits(result, function(a))


RECURRING = {
    "other view of one array": (lambda a: a[:, :2] * 2.0, lambda a: a[:, 1:] * 2.0),
    "other number": (lambda a: a * 2.0, lambda a: a * 3.0),
    "other axis": (lambda a: np.add.reduce(a, 0), lambda a: np.add.reduce(a, 1)),
    "other order": (lambda a: a - 2.0, lambda a: 2.0 - a),
    "last operation": (lambda a: a * 2.0, lambda a: a * 2.0),
    "last operation, then its input": (lambda a: a * 2.0, lambda a: np.sin(a * 2.0)),
    "input, then last operation": (lambda a: np.sin(a * 2.0), lambda a: a * 2.0),
    "result that is changed in place": (lambda a: _doubled(a + 1.0), lambda a: np.sin(a + 1.0)),
    "array that is changed in place": (lambda a: np.sin(a + 1.0), lambda a: _doubled(a + 1.0) * np.sin(a + 1.0)),
    "result that is overwritten": (lambda a: np.sin(a, a * 2.0), lambda a: np.cos(a * 2.0)),
    "comparison and its conversion": (lambda a: (a > 0.0).astype(np.float64), lambda a: (a > 0.0).astype(np.int64)),
}


@pytest.mark.parametrize("functions", RECURRING.values(), ids=RECURRING)
@pytest.mark.parametrize("contiguous", [True, False])
def test_recurring_operations_give_the_results_of_calls(functions, contiguous):
    rng = np.random.default_rng(0)
    a = rng.standard_normal((3, 3))
    results = [np.full((*np.shape(f(a)), 2), np.nan)[..., 0] for f in functions]
    if contiguous:
        results = [np.ascontiguousarray(result) for result in results]
    capture = Capture()
    for function, result in zip(functions, results, strict=True):
        capture.record_into(result, function, capture.stand_in(a))
    for _ in range(3):
        a[:] = rng.standard_normal(a.shape)
        capture.repeat()
        for function, result in zip(functions, results, strict=True):
            np.testing.assert_array_equal(result, function(a))


def test_operation_of_a_refused_function_is_not_taken_for_recorded():
    a, result = np.ones((2, 3)), np.empty((2, 3))
    capture = Capture()
    with pytest.raises(NotCapturableError):
        capture.record(lambda x: (x * 2.0).clip(0.0), capture.stand_in(a))
    capture.record_into(result, lambda x: np.sin(x * 2.0), capture.stand_in(a))
    a[:] = 3.0
    capture.repeat()
    np.testing.assert_array_equal(result, np.sin(a * 2.0))


def test_functions_that_cannot_be_captured_are_called_at_every_update():
    a, calls = np.ones((2, 3)), []

    def counted(x):
        calls.append(1)
        return x.sum(axis=1)

    results = np.empty(2), np.empty((2, 3)), np.empty((2, 3))
    named = (counted, False), (np.negative, True), (lambda x: x.clip(0.0, 1.0), True)
    functions = Functions(
        [(*function, result) for function, result in zip(named, results, strict=True)],
        lambda capture: (capture.stand_in(a),),
    )
    assert not calls
    for value in (2.0, -3.0):
        a[:] = value
        functions.update(a)
        for found, expected in zip(results, (a.sum(axis=1), -a, a.clip(0.0, 1.0)), strict=True):
            np.testing.assert_array_equal(found, expected)
    assert len(calls) == 2


@pytest.mark.parametrize("num_envs", [1, 5, 64])
def test_captured_rewards_equal_calls_of_the_terms(num_envs):
    rng = np.random.default_rng(num_envs)
    readings = random_readings(rng, num_envs)
    terms = Terms(readings)
    memory = terms.context.memory
    for _ in range(4):
        overwrite(readings, random_readings(rng, num_envs))
        terms.randomize(rng)
        before = [memory.get_state(env_id) for env_id in range(num_envs)]
        found = terms.function(terms.context)
        for env_id, state in enumerate(before):
            memory.set_state(env_id, state)  # so that the same step follows
        called = [np.atleast_2d(np.asarray(f(terms.context)).T) for _, f in terms.function._functions]
        assert_same_bits(found, np.concatenate(called) * terms.function._weights)


def test_every_built_in_term_and_field_on_level_ground_is_captured():
    task = make_task()
    task.step(np.zeros((3, 8)))
    for functions in (task._rewards._captured, task._terminations._captured, task.control._fields):
        assert functions._capture._operations
        assert not functions._called


def test_heights_on_a_height_field_are_looked_up_at_every_step():
    task = make_native(2, terrain="hills").task
    task.reset(np.arange(2))
    task.step(np.zeros((2, 8)))
    assert {f.__class__.__name__ for _, f in task._rewards._captured._called} == {"gait_clock", "base_height"}


def test_observation_of_other_readings_is_theirs():
    control = ControlInterface(MINI_QUADRUPED, ControlConfig(), 2)
    rng = np.random.default_rng(0)
    first, second = random_readings(rng, 2), random_readings(rng, 2)
    alone = ControlInterface(MINI_QUADRUPED, ControlConfig(), 2).observe(second)
    control.observe(first)
    np.testing.assert_array_equal(control.observe(second), alone)
    assert not np.array_equal(control.observe(first), alone)
