"""Sums of products, which must not depend on the number of envs or on the processor's BLAS."""

import numpy as np
import pytest

from quadruped_env.utils.arrays import dot


@pytest.mark.parametrize("columns", range(10))
def test_dot_of_a_row_does_not_depend_on_the_other_rows(columns):
    x, y = np.random.default_rng(columns).standard_normal((2, 50, columns))
    found = dot(x, y)
    np.testing.assert_allclose(found, (x * y).sum(axis=-1), rtol=1e-12, atol=1e-15)
    np.testing.assert_array_equal(found, [dot(x[i : i + 1], y[i : i + 1])[0] for i in range(50)])
