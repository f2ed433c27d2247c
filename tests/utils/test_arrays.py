"""NumPy's namespace of the terms: what it computes for few columns in other ways than for many."""

import numpy as np
import pytest

from quadruped_env.utils.arrays import NUMPY


@pytest.mark.parametrize("columns", range(10))
def test_functions_of_rows_do_not_depend_on_the_number_of_columns(columns):
    rng = np.random.default_rng(columns)
    x, y = rng.integers(-3, 4, (2, 50, columns)).astype(np.float64)  # whole numbers add up exactly
    np.testing.assert_array_equal(NUMPY.any(x > 1.0), np.any(x > 1.0, axis=-1))
    np.testing.assert_array_equal(NUMPY.sum(x), x.sum(axis=-1))
    if columns:
        np.testing.assert_array_equal(NUMPY.dot(x, y), (x * y).sum(axis=-1))
