"""Pushes of a user add up to a limit within a second."""

import math

import pytest

from quadruped_env import QuadrupedError
from quadruped_env.simulation.push_limit import PushLimit


def test_pushes_within_a_second_add_up_to_the_limit():
    limit = PushLimit("/push")
    limit.check((0.0, 3.0, 0.0), time=10.0)
    # In the opposite direction too: what is between them may be an impact.
    limit.check((0.0, -2.0, 0.0), time=10.5)
    with pytest.raises(QuadrupedError, match=r"/push: \[0.5, 0.0, 0.0\] m/s and .* of the last 1 s add up to 5.5 m/s"):
        limit.check((0.5, 0.0, 0.0), time=10.9)
    # The first one no longer counts, nor does the refused one.
    limit.check((3.0, 0.0, 0.0), time=11.0)
    with pytest.raises(QuadrupedError):
        limit.check((0.1, 0.0, 0.0), time=11.4)


@pytest.mark.parametrize("velocity", [(math.nan, 0.0, 0.0), (0.0, -math.inf, 0.0), (3.0, 4.0, 0.1), (1e308,) * 3])
def test_push_that_is_not_finite_or_too_large_is_refused_and_not_counted(velocity):
    limit = PushLimit("/push")
    with pytest.raises(QuadrupedError, match="expected finite numbers and at most 5 m/s within 1 s"):
        limit.check(velocity, time=0.0)
    limit.check((5.0, 0.0, 0.0), time=0.0)
