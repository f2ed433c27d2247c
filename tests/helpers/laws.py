"""Statistical tests of random draws: their distribution and their independence.

Draws are given as numbers that are uniform in [0, 1) if the law holds: the value's cumulative distribution function at
the draw. The smallest p-value that passes is fixed here, and shared by all comparisons that one call makes
(Bonferroni), so that a correct sampler fails one call in ten thousand, whatever the seed.
"""

import itertools
from typing import Final

import numpy as np
from scipy import stats

ALPHA: Final = 1e-4
"""Probability that a call fails although the law holds."""

NEIGHBOURS: Final = ((0, 1), (1, 0), (1, 1), (1, -1))
"""Shifts along two axes at which draws of related generators could meet: the next env's, the next episode's, and those
on the diagonals, where a key that is the sum of a seed and a counter repeats."""


def share(values, low, high):
    """Values that are uniform in [low, high) as numbers in [0, 1)."""
    return (np.asarray(values, dtype=np.float64) - low) / (high - low)


def assert_uniform(draws):
    """Kolmogorov-Smirnov test against the uniform law of each of some draws.

    Args:
        draws: name -> values, of any shape.
    """
    for name, values in draws.items():
        result = stats.kstest(np.ravel(values), "uniform")
        assert result.pvalue > ALPHA / len(draws), (
            f"{name} is not uniform: {np.size(values)} draws are {result.statistic:.3f} from the law "
            f"(p = {result.pvalue:.1e}), most at {result.statistic_location:.3f} of the range"
        )


def assert_equally_likely(counts, name):
    """Chi-squared test that all categories have the same probability."""
    result = stats.chisquare(counts)
    assert result.pvalue > ALPHA, f"{name}: {np.asarray(counts)} are not equally likely (p = {result.pvalue:.1e})"


def assert_probability(events, probability, name):
    """Binomial test that an event has a probability."""
    result = stats.binomtest(int(np.sum(events)), int(np.size(events)), probability)
    assert result.pvalue > ALPHA, (
        f"{name}: {np.mean(events):.4f} of {np.size(events)}, expected {probability} (p = {result.pvalue:.1e})"
    )


def assert_unrelated(one, other):
    """Assert that the draws of two groups are uncorrelated.

    Correlation of the draws, which are ranks already, and of their squared distances from the middle of the range.

    Args:
        one, other: name -> values (n,) each.
    """
    if one and other:
        _assert_no_correlation([(one, other, "")])


def assert_independent(draws, shifts=((0, 0),)):
    """Assert that draws are uncorrelated with one another, as `assert_unrelated` does for two groups.

    Args:
        draws: name -> values (A, B) over two axes, such as episodes and envs.
        shifts: offsets along both axes between the draws that are compared; (0, 0) compares different draws only.
    """
    pairs = []
    for shift in shifts:
        parts = [_parts(len_, by) for len_, by in zip(next(iter(draws.values())).shape, shift, strict=True)]
        first, second = (tuple(part[side] for part in parts) for side in (0, 1))
        groups = [{name: values[part].ravel() for name, values in draws.items()} for part in (first, second)]
        pairs.append((*groups, f", shifted by {shift}" if any(shift) else ""))
    _assert_no_correlation(pairs)


def _parts(length, shift):
    """The two slices of an axis that put the values a shift apart side by side."""
    start, stop = max(shift, 0), length + min(shift, 0)
    return slice(start - shift, stop - shift), slice(start, stop)


def _assert_no_correlation(pairs):
    found = []
    for one, other, where in pairs:
        same = one.keys() == other.keys() and not where
        for what, transform in (("", _centred), ("the spread of ", _squared)):
            columns = np.array([transform(values) for values in one.values()])
            others = np.array([transform(values) for values in other.values()])
            score = columns @ others.T / np.sqrt(columns.shape[1])
            for (i, a), (j, b) in itertools.product(enumerate(one), enumerate(other)):
                if not same or i < j:
                    found.append((abs(score[i, j]), f"{what}{a} and {b}{where}", columns.shape[1]))
    limit = stats.norm.isf(ALPHA / 2 / len(found))
    worst, name, count = max(found)
    assert worst < limit, (
        f"{name} are related: correlation {worst / np.sqrt(count):.3f} over {count} draws, "
        f"chance allows {limit / np.sqrt(count):.3f}"
    )


def _centred(values):
    values = values - np.mean(values)
    return values / np.std(values)


def _squared(values):
    return _centred((values - 0.5) ** 2)
